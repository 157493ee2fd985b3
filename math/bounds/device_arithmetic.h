#pragma once
// The rounding budget of a device that is known only when the program runs.

#include "math/bounds/forks.h"
#include "math/bounds/rounding_budget.h"
#include "math/bounds/texture_errors.h"

namespace refraster::inline REFRASTER_KIT {

/// The errors of a device's operations: the members of a rounding budget, as values. As they are here they are those
/// that Vulkan 1.3, "Precision and operation of SPIR-V instructions", allows in single precision, where one ULP is
/// 2^-23 of the result at most; denormals may be flushed. The specification leaves atan2 4,096 ULP.
struct OperationErrors {
  double relative = 0x1p-23, absolute = 0x1p-126;
  double quotient_relative = 2.5 * 0x1p-23;
  double root_relative = (2 + 2.5) * 0x1p-23; // 1 / inversesqrt(x)
  double log2_units = 1.5, log2_absolute = 0x1p-21;
  double exp2_units = 4, exp2_units_by_exponent = 1; // 3 + 2 |x| ULP, and never less than 8
  double pow_units = 0;                              // not read: exp2(s log2(x))
  double atan2_units = 2048;
  double cut_off = -126;
};

/// The arithmetic of the OperationErrors in use on this thread, which reads textures with the TextureErrors in use.
struct DeviceArithmetic {
  /// One of them, read where a formula asks for it.
  struct Value {
    double OperationErrors::*member;
    operator double() const { return current().*member; }
  };
  static constexpr Value relative{&OperationErrors::relative}, absolute{&OperationErrors::absolute},
      quotient_relative{&OperationErrors::quotient_relative}, root_relative{&OperationErrors::root_relative},
      log2_units{&OperationErrors::log2_units}, log2_absolute{&OperationErrors::log2_absolute},
      exp2_units{&OperationErrors::exp2_units}, exp2_units_by_exponent{&OperationErrors::exp2_units_by_exponent},
      pow_units{&OperationErrors::pow_units}, atan2_units{&OperationErrors::atan2_units},
      cut_off{&OperationErrors::cut_off};
  static constexpr double smallest_normal = static_cast<double>(std::numeric_limits<float>::min());
  static constexpr double largest = static_cast<double>(std::numeric_limits<float>::max());
  static constexpr Sums sums = Sums::in_any_order;
  static constexpr Powers powers = Powers::by_logarithm;
  /// Of a texture or table, at once: a place that may be among more is not known well enough for what is read to mean
  /// anything. A spline's cell has 64, any other eight at most.
  static constexpr std::int64_t max_samples = 2048;

  /// From now on, on this thread; a render does so for its own (SampleRequest::enter).
  static void use(const OperationErrors& errors, const TextureErrors& texture = {}) {
    current() = errors;
    textures() = texture;
  }
  static const TextureErrors& texture() { return textures(); }

  /// What a comparison says: where the numbers leave it open, the path that is being followed.
  static Certainty decided(Certainty c) { return c == Certainty::unknown ? Forks::decided() : c; }

private:
  static OperationErrors& current() {
    static thread_local constinit OperationErrors errors;
    return errors;
  }
  static TextureErrors& textures() {
    static thread_local constinit TextureErrors errors;
    return errors;
  }
};

} // namespace refraster::inline REFRASTER_KIT
