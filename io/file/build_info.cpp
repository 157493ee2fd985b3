#include "io/file/build_info.h"

// CMakeLists.txt gives these to this file.
#if !defined(REFRASTER_VERSION) || !defined(REFRASTER_BUILD_TYPE) || !defined(REFRASTER_MARCH) ||                      \
    !defined(REFRASTER_FLAGS)
#error "io/CMakeLists.txt must define REFRASTER_VERSION, _BUILD_TYPE, _MARCH and _FLAGS for this file"
#endif

namespace refraster {
namespace {

std::string compiler() {
  const auto version = [](int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
  };
#if defined(__clang__)
  return "clang++ " + version(__clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return "g++ " + version(__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

/// The x86-64 level (System V psABI, "Micro-Architecture Levels") whose instructions this build may use; or ARM's name.
constexpr const char* isa() {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512CD__) && defined(__AVX512DQ__) &&                 \
    defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__) && defined(__BMI2__)
  return "x86-64-v3";
#elif defined(__SSE4_2__) && defined(__SSSE3__)
  return "x86-64-v2";
#elif defined(__x86_64__)
  return "x86-64";
#elif defined(__aarch64__)
  return "aarch64";
#else
  return "of another kind";
#endif
}

} // namespace

BuildInfo this_build() {
  return {REFRASTER_VERSION, compiler(), REFRASTER_BUILD_TYPE, REFRASTER_MARCH, isa(), REFRASTER_FLAGS};
}

} // namespace refraster
