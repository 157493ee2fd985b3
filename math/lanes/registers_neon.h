#pragma once
// ARM's counterpart of what math/lanes/registers.h has of x86, for registers of 16 bytes: only what g++ 12 does lane by
// lane, or in more steps than the machine needs. docs/portability.md has what it makes of the plain code otherwise.

#include "math/kit_namespace.h"

#include <arm_neon.h>

#include <cstdint>

namespace refraster::inline REFRASTER_KIT::registers {

// Square root, correctly rounded.
inline float64x2_t sqrt(float64x2_t x) {
  return vsqrtq_f64(x);
}

// From float to double, exactly.
inline float64x2_t widened(float32x2_t x) {
  return vcvt_f64_f32(x);
}

// The sign bit of each lane, lane 0 the lowest: each moves to its place, and all are added.
inline std::uint32_t sign_bits(float32x4_t x) {
  constexpr std::int32_t places[] = {0, 1, 2, 3};
  return vaddvq_u32(vshlq_u32(vshrq_n_u32(vreinterpretq_u32_f32(x), 31), vld1q_s32(places)));
}
inline std::uint32_t sign_bits(float64x2_t x) {
  constexpr std::int64_t places[] = {0, 1};
  return static_cast<std::uint32_t>(
      vaddvq_u64(vshlq_u64(vshrq_n_u64(vreinterpretq_u64_f64(x), 63), vld1q_s64(places))));
}

// x y - z, rounded once.
inline float32x4_t fused_difference(float32x4_t x, float32x4_t y, float32x4_t z) {
  return vfmaq_f32(vnegq_f32(z), x, y);
}
inline float64x2_t fused_difference(float64x2_t x, float64x2_t y, float64x2_t z) {
  return vfmaq_f64(vnegq_f64(z), x, y);
}

// x y + z, rounded once.
inline float32x4_t fused_sum(float32x4_t x, float32x4_t y, float32x4_t z) {
  return vfmaq_f32(z, x, y);
}

// 1 / sqrt(x), good to 15 bits: the machine's estimate has 8, and one step of Newton's method doubles them.
inline float32x4_t reciprocal_root_estimate(float32x4_t x) {
  const float32x4_t y = vrsqrteq_f32(x);
  return vmulq_f32(y, vrsqrtsq_f32(vmulq_f32(x, y), y));
}

} // namespace refraster::inline REFRASTER_KIT::registers
