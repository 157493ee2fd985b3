#pragma once
// Whether one image is the other after lossy compression in blocks, as JPEG and its kin do it.

#include "verify/transformations/transformations.h"

namespace refraster {

/// Which of two images was compressed.
enum class Compressed { none, a, b };

/// How many coefficients of 8 x 8 pixels are not zero in b, as a share of those that are not zero in a: on the grid of
/// a codec, from the image's corner, and on that one of three other grids where it is least.
struct BlockSpectrum {
  std::uint64_t blocks = 0; // that differ and are not of one colour in b, of those that are looked at
  double on_grid = 1, beside = 1;
};

/// A codec of blocks sets most of the small coefficients of each block's cosine transform to zero (ITU-T T.81, A.3.3
/// and A.3.4). After decoding, they are zero but for the rounding of pixels - on its grid, and on no other, since
/// blocks do not meet smoothly. What is zero in both images, flat colour, tells nothing, and a picture that is itself
/// made of squares of 8 pixels has its zeros in both. Luma of JFIF; of a million pixels at most.
BlockSpectrum block_spectrum(const StoredImage& a, const StoredImage& b);

/// Whether the share on the grid is below 0.8 of that beside it; b first. Measured on drawn and rendered pictures
/// (tests/unit/verify/test_block_compression.cpp): at most 0.72 after compression, at least 0.88 after all else, down
/// to a shift by one pixel of a picture of which few blocks differ.
Compressed find_block_compression(const StoredImage& a, const StoredImage& b);

} // namespace refraster
