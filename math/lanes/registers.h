#pragma once
// The instructions that compilers do not find by themselves, or not always, for vectors of the size of a register:
// those of x86 here, those of ARM in registers_neon.h. Each does what the plain code in math/lanes/wide.h does, lane by
// lane and bit by bit; that code is the fallback.

#include "math/kit_namespace.h"

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include "math/lanes/registers_neon.h"
#endif

#include <cstdint>
#include <type_traits>

namespace refraster::inline REFRASTER_KIT::registers {

/// Whether comparing N lanes of F gives a bit for each lane, in a register of its own kind.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
template <class F, int N>
inline constexpr bool has_mask = N * sizeof(F) == 64;
#else
template <class F, int N>
inline constexpr bool has_mask = false;
#endif
/// As many bits.
template <int N>
using LaneMask = std::conditional_t<N <= 8, std::uint8_t, std::uint16_t>;

// Every name exists on every machine, so that `requires { sqrt(v); }` can ask.
struct NoRegister {};
NoRegister sqrt(NoRegister), min(NoRegister, NoRegister), max(NoRegister, NoRegister), widened(NoRegister);
void sign_bits(NoRegister), fused_difference(NoRegister, NoRegister, NoRegister),
    fused_sum(NoRegister, NoRegister, NoRegister), reciprocal_root_estimate(NoRegister),
    select(NoRegister, NoRegister, NoRegister);
void less(NoRegister, NoRegister), greater(NoRegister, NoRegister), less_equal(NoRegister, NoRegister),
    greater_equal(NoRegister, NoRegister), equal(NoRegister, NoRegister);

#if defined(__x86_64__)

// Square root, correctly rounded. 512 bits in the zero-masked forms: GCC 12 warns of its own undefined operand in the
// plain ones.
inline __m128 sqrt(__m128 x) {
  return _mm_sqrt_ps(x);
}
inline __m128d sqrt(__m128d x) {
  return _mm_sqrt_pd(x);
}
#if defined(__AVX__)
inline __m256 sqrt(__m256 x) {
  return _mm256_sqrt_ps(x);
}
inline __m256d sqrt(__m256d x) {
  return _mm256_sqrt_pd(x);
}
#endif
#if defined(__AVX512F__)
inline __m512 sqrt(__m512 x) {
  return _mm512_maskz_sqrt_ps(0xFFFF, x);
}
inline __m512d sqrt(__m512d x) {
  return _mm512_maskz_sqrt_pd(0xFF, x);
}
#endif

// x < y ? x : y and x > y ? x : y: y where either is NaN.
inline __m128 min(__m128 x, __m128 y) {
  return _mm_min_ps(x, y);
}
inline __m128d min(__m128d x, __m128d y) {
  return _mm_min_pd(x, y);
}
inline __m128 max(__m128 x, __m128 y) {
  return _mm_max_ps(x, y);
}
inline __m128d max(__m128d x, __m128d y) {
  return _mm_max_pd(x, y);
}
#if defined(__AVX__)
inline __m256 min(__m256 x, __m256 y) {
  return _mm256_min_ps(x, y);
}
inline __m256d min(__m256d x, __m256d y) {
  return _mm256_min_pd(x, y);
}
inline __m256 max(__m256 x, __m256 y) {
  return _mm256_max_ps(x, y);
}
inline __m256d max(__m256d x, __m256d y) {
  return _mm256_max_pd(x, y);
}
#endif
#if defined(__AVX512F__)
inline __m512 min(__m512 x, __m512 y) {
  return _mm512_maskz_min_ps(0xFFFF, x, y);
}
inline __m512d min(__m512d x, __m512d y) {
  return _mm512_maskz_min_pd(0xFF, x, y);
}
inline __m512 max(__m512 x, __m512 y) {
  return _mm512_maskz_max_ps(0xFFFF, x, y);
}
inline __m512d max(__m512d x, __m512d y) {
  return _mm512_maskz_max_pd(0xFF, x, y);
}
#endif

// From float to double, exactly.
#if defined(__AVX__)
inline __m256d widened(__m128 x) {
  return _mm256_cvtps_pd(x);
}
#endif
#if defined(__AVX512F__)
inline __m512d widened(__m256 x) {
  return _mm512_maskz_cvtps_pd(0xFF, x);
}
#endif

// The sign bit of each lane, lane 0 the lowest.
inline std::uint32_t sign_bits(__m128 x) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(x));
}
inline std::uint32_t sign_bits(__m128d x) {
  return static_cast<std::uint32_t>(_mm_movemask_pd(x));
}
#if defined(__AVX__)
inline std::uint32_t sign_bits(__m256 x) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(x));
}
inline std::uint32_t sign_bits(__m256d x) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd(x));
}
#endif

// x y - z, rounded once.
#if defined(__FMA__)
inline __m128 fused_difference(__m128 x, __m128 y, __m128 z) {
  return _mm_fmsub_ps(x, y, z);
}
inline __m128d fused_difference(__m128d x, __m128d y, __m128d z) {
  return _mm_fmsub_pd(x, y, z);
}
inline __m256 fused_difference(__m256 x, __m256 y, __m256 z) {
  return _mm256_fmsub_ps(x, y, z);
}
inline __m256d fused_difference(__m256d x, __m256d y, __m256d z) {
  return _mm256_fmsub_pd(x, y, z);
}
#if defined(__AVX512F__)
inline __m512 fused_difference(__m512 x, __m512 y, __m512 z) {
  return _mm512_fmsub_ps(x, y, z);
}
inline __m512d fused_difference(__m512d x, __m512d y, __m512d z) {
  return _mm512_fmsub_pd(x, y, z);
}
#endif
#endif

// x y + z, rounded once.
#if defined(__FMA__)
inline __m128 fused_sum(__m128 x, __m128 y, __m128 z) {
  return _mm_fmadd_ps(x, y, z);
}
inline __m256 fused_sum(__m256 x, __m256 y, __m256 z) {
  return _mm256_fmadd_ps(x, y, z);
}
#if defined(__AVX512F__)
inline __m512 fused_sum(__m512 x, __m512 y, __m512 z) {
  return _mm512_fmadd_ps(x, y, z);
}
#endif
#endif

// 1 / sqrt(x), good to 11 bits or more: which ones depends on the maker of the processor.
inline __m128 reciprocal_root_estimate(__m128 x) {
  return _mm_rsqrt_ps(x);
}
#if defined(__AVX__)
inline __m256 reciprocal_root_estimate(__m256 x) {
  return _mm256_rsqrt_ps(x);
}
#endif
#if defined(__AVX512F__)
inline __m512 reciprocal_root_estimate(__m512 x) {
  return _mm512_maskz_rsqrt14_ps(0xFFFF, x);
}
#endif

// Comparisons, false where either is NaN; and m ? x : y.
#if defined(__AVX512F__)
inline __mmask16 less(__m512 x, __m512 y) {
  return _mm512_cmp_ps_mask(x, y, _CMP_LT_OQ);
}
inline __mmask8 less(__m512d x, __m512d y) {
  return _mm512_cmp_pd_mask(x, y, _CMP_LT_OQ);
}
inline __mmask16 greater(__m512 x, __m512 y) {
  return _mm512_cmp_ps_mask(x, y, _CMP_GT_OQ);
}
inline __mmask8 greater(__m512d x, __m512d y) {
  return _mm512_cmp_pd_mask(x, y, _CMP_GT_OQ);
}
inline __mmask16 less_equal(__m512 x, __m512 y) {
  return _mm512_cmp_ps_mask(x, y, _CMP_LE_OQ);
}
inline __mmask8 less_equal(__m512d x, __m512d y) {
  return _mm512_cmp_pd_mask(x, y, _CMP_LE_OQ);
}
inline __mmask16 greater_equal(__m512 x, __m512 y) {
  return _mm512_cmp_ps_mask(x, y, _CMP_GE_OQ);
}
inline __mmask8 greater_equal(__m512d x, __m512d y) {
  return _mm512_cmp_pd_mask(x, y, _CMP_GE_OQ);
}
inline __mmask16 equal(__m512 x, __m512 y) {
  return _mm512_cmp_ps_mask(x, y, _CMP_EQ_OQ);
}
inline __mmask8 equal(__m512d x, __m512d y) {
  return _mm512_cmp_pd_mask(x, y, _CMP_EQ_OQ);
}
inline __m512 select(__mmask16 m, __m512 x, __m512 y) {
  return _mm512_mask_blend_ps(m, y, x);
}
inline __m512d select(__mmask8 m, __m512d x, __m512d y) {
  return _mm512_mask_blend_pd(m, y, x);
}
#endif

#endif // __x86_64__

} // namespace refraster::inline REFRASTER_KIT::registers
