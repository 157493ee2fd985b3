#pragma once
// A measured BRDF: the MERL table.

#include "math/half.h"
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

  /// The values as a precision reads them: in double; in float, each rounded once; or in Half, in units of
  /// unit<Half>(), each rounded once. A sample that was never measured has -1 in all channels; in double, what the file
  /// has.
  template <class Stored>
  const Stored* values() const;

  /// The f that a stored value of 1 means. Of double and float 1; of Half a power of two, chosen so that the greatest
  /// value of the table lies in (32752, 65504]: a metal's highlight is brighter than the largest half, and what is
  /// 2^28 times darker still has all its digits.
  template <class Stored>
  double unit() const;

  /// g = log2(1 + f / log_epsilon) >= 0 in double or float; -1 in all channels of a sample that was never measured.
  /// Not in Half: g goes up to 30, and half's 11 bits of that are a worse f than half's 11 bits of f.
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
  template <class Stored>
  struct Copy {
    std::once_flag made;
    PaddedVector<Stored> values;
    double unit = 1;
  };

  PaddedVector<double> doubles_;
  mutable Copy<float> floats_, log_floats_;
  mutable Copy<double> log_doubles_;
  mutable Copy<Half> halves_;
};

} // namespace refraster
