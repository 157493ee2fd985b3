#pragma once
// From what a formula gives to what an image stores.

#include "raster/resolve/rgb8.h"
#include "verify/verdict/verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace refraster {

/// How an image's numbers follow from radiance, in levels (1/255), and how far a right device may be off in storing.
class StoredValue {
public:
  StoredValue(const DeviceImage& image, const DeviceProfile& profile)
      : transfer_(image.transfer), to_levels_(255 / image.full_scale), precision_(image.precision),
        rounding_(image.precision.step *
                  (image.transfer == Transfer::srgb ? profile.output.srgb_levels : profile.output.unorm_levels)) {}

  bool is_integer() const { return precision_.saturates(); }
  /// One step between stored numbers; 0 of floating point.
  double step() const { return precision_.step; }
  double levels(float stored) const { return static_cast<double>(stored) * to_levels_; }

  /// In levels, not rounded: clamped and encoded as the image is.
  double of(double radiance) const {
    if (is_integer()) radiance = std::isnan(radiance) ? 0 : std::clamp(radiance, 0.0, 1.0);
    return 255 * (transfer_ == Transfer::srgb ? srgb_encoded(radiance) : radiance);
  }
  /// Whether a device that computes something in [lo, hi] may store this.
  bool may_be(double lo, double hi, double stored_levels) const {
    return of(lo) - tolerance(lo) <= stored_levels && stored_levels <= of(hi) + tolerance(hi);
  }
  bool may_be(const ColourBox& box, const Double3& stored_levels) const {
    for (int c = 0; c < 3; ++c)
      if (!may_be(box.lo[c], box.hi[c], stored_levels[c])) return false;
    return true;
  }
  /// Whether nearly all pixels of a right image can be told by are_plainly(): levels, without a curve.
  bool has_plain_levels() const {
    return is_integer() && transfer_ == Transfer::linear && rounding_ >= plain_distance();
  }
  /// Of has_plain_levels(): 1 only where is() and may_be() are true of a value and what is stored for it. By a few
  /// operations of many values at a time, so that an image that is exact costs little more than to be read.
  void are_plainly(const float* radiance, const float* stored, std::span<std::uint8_t> plain) const {
    const double farthest = plain_distance();
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const double level = 255 * std::clamp(static_cast<double>(radiance[i]), 0.0, 1.0);
      plain[i] = std::abs(level - levels(stored[i])) <= farthest;
    }
  }

  /// Whether that is this number, which is known in single precision, rounded once.
  bool is(float radiance, double stored_levels) const {
    const double exact = of(static_cast<double>(radiance)), apart = std::abs(exact - stored_levels);
    constexpr double single = 0x1p-23; // and the curve of sRGB makes it no more than twice as much
    if (is_integer()) return apart <= 0.5 * precision_.step + single * exact;
    return apart <= precision_.relative * std::abs(exact);
  }

  /// How far what is stored may be from what was computed.
  double tolerance(double radiance) const {
    return is_integer() ? rounding_ : precision_.relative * 2 * std::abs(of(radiance));
  }

private:
  double plain_distance() const { return 0.49 * precision_.step; } // the nearest level, and not near the middle of two

  Transfer transfer_;
  double to_levels_;
  StoredPrecision precision_;
  double rounding_;
};

} // namespace refraster
