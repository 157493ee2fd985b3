#pragma once
// Whether this build carries a sanitizer. Each takes memory as it likes and puts its own calls before the system's.

namespace refraster {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) // g++
inline constexpr bool built_with_sanitizer = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) // clang++
inline constexpr bool built_with_sanitizer = true;
#else
inline constexpr bool built_with_sanitizer = false;
#endif
#else
inline constexpr bool built_with_sanitizer = false;
#endif

} // namespace refraster
