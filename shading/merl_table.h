#pragma once
// A measured BRDF: the MERL table.

#include "math/vec.h"

#include <cstddef>
#include <mutex>
#include <vector>

namespace refraster {

/// f(theta_h, theta_d, phi_d) in 1/sr, without cosine, for red, green and blue. A sample with a negative channel was
/// never measured. Matusik et al., "A data-driven reflectance model", 2003; half and difference angles after
/// Rusinkiewicz, "A new change of variables for efficient BRDF representation", 1998.
class MerlTable {
public:
  static constexpr int theta_h_bins = 90, theta_d_bins = 90, phi_d_bins = 180;
  static constexpr std::size_t samples = std::size_t{90} * 90 * 180;

  /// `rgb` holds 3 * samples values, interleaved, phi_d fastest, then theta_d, then theta_h.
  explicit MerlTable(std::vector<double> rgb);

  /// Index of the first channel of a sample. 0 <= h, d < 90, 0 <= p < 180.
  static constexpr std::size_t offset(int h, int d, int p) {
    return 3 * (static_cast<std::size_t>(p) + phi_d_bins * (static_cast<std::size_t>(d) + theta_d_bins * static_cast<std::size_t>(h)));
  }

  /// The values in the precision that a rung reads: double, or float (each value rounded once; made when first asked
  /// for, safely from several threads).
  template <class F>
  const F* values() const;

  Rgb<double> sample(int h, int d, int p) const {
    const double* at = &doubles_[offset(h, d, p)];
    return {at[0], at[1], at[2]};
  }

private:
  std::vector<double> doubles_;
  mutable std::vector<float> floats_;
  mutable std::once_flag floats_once_;
};

} // namespace refraster
