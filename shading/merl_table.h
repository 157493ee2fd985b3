#pragma once
// A measured BRDF: the MERL table.

#include "math/padded_vector.h"
#include "math/vec.h"

#include <cstddef>
#include <mutex>

namespace refraster {

/// f(theta_h, theta_d, phi_d) in 1/sr, without cosine, for red, green and blue. A sample with a negative channel was
/// never measured. Matusik et al., "A data-driven reflectance model", 2003; half and difference angles after
/// Rusinkiewicz, "A new change of variables for efficient BRDF representation", 1998.
///
/// Immutable. Copies in other precisions are made when they are first asked for, once, whatever threads ask: a frame
/// pays only for those it reads.
class MerlTable {
public:
  static constexpr int theta_h_bins = 90, theta_d_bins = 90, phi_d_bins = 180;
  static constexpr std::size_t samples = std::size_t{90} * 90 * 180;

  /// `rgb` holds 3 * samples finite values, interleaved, phi_d fastest, then theta_d, then theta_h.
  explicit MerlTable(PaddedVector<double> rgb);

  /// Index of the first channel of a sample. 0 <= h, d < 90, 0 <= p < 180.
  static constexpr int offset(int h, int d, int p) { return 3 * ((h * theta_d_bins + d) * phi_d_bins + p); }

  /// The values in the precision that a rung reads: double, or float (each value rounded once).
  template <class F>
  const F* values() const;

  /// g = log2(1 + f / log_epsilon) >= 0 in double or float; -1 in all channels of a sample that was never measured.
  template <class F>
  const F* log_values() const;

  /// Below this value, in 1/sr, interpolating logarithms turns into interpolating values: it keeps the logarithm of
  /// black finite. Black paint has f near 1e-2, so that nothing measured is that dark.
  static constexpr double log_epsilon = 1e-4;

  Rgb<double> sample(int h, int d, int p) const {
    const double* at = doubles_.data() + offset(h, d, p);
    return {at[0], at[1], at[2]};
  }

private:
  template <class F>
  struct Copy {
    std::once_flag made;
    PaddedVector<F> values;
  };

  template <class F>
  const F* made_once(Copy<F>& copy, double (*encode)(double)) const;

  PaddedVector<double> doubles_;
  mutable Copy<float> floats_, log_floats_;
  mutable Copy<double> log_doubles_;
};

} // namespace refraster
