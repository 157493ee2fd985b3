#pragma once
// Whether one image is the other after lossy compression in blocks, as JPEG and its kin do it.

#include "verify/transformations.h"

namespace refraster {

/// Which of two images was compressed.
enum class Compressed { none, a, b };

/// How often a coefficient of 8 x 8 pixels has become zero, on the grid of a codec and beside it.
struct BlockZeros {
  std::uint64_t blocks = 0; // that differ, of those that are looked at
  double on_grid = 0,
         beside = 0; // share of the coefficients that are zero in b and not in a, less those that are zero in
                     // a and not in b; on the grid from the image's corner, and on the worst of three others
};

/// A codec of blocks sets most of the small coefficients of each block's cosine transform to zero (ITU-T T.81, A.3.3
/// and A.3.4). After decoding, they are zero but for the rounding of pixels - on its grid, and on no other, since
/// blocks do not meet smoothly. What is zero in both images, flat colour, tells nothing, and a picture that is itself
/// made of squares of 8 pixels has its zeros in both. Luma of JFIF; of a million pixels at most.
BlockZeros block_zeros(const StoredImage& a, const StoredImage& b);

/// Whether at least a tenth more of the coefficients are zero on the grid than beside it; b first.
Compressed find_block_compression(const StoredImage& a, const StoredImage& b);

} // namespace refraster
