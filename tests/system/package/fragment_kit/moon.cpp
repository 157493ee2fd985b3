// moon SCENE: the scene in every precision that promises bits, with a fragment function that the library does not know.
// Prints the precision, how many pixels show something, and a hash of their radiance.

#include <refraster/files.h>
#include <refraster/render.h>

#include "minnaert.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>

namespace {

/// FNV-1a.
std::uint64_t hash_of(const refraster::Image<double>& image) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double value : image.values) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  }
  return hash;
}

} // namespace

int main(int, char** words) try {
  using namespace refraster;
  SceneOptions options;
  options.user_functions = {user_function<moon::Minnaert>()};
  const Scene scene = read_scene(words[1], options);
  for (const auto& [precision, name] : EnumNames<Precision>::names) {
    RenderOptions asked;
    asked.precision = precision;
    asked.width = precision == Precision::exact ? 32 : 160;
    asked.height = precision == Precision::exact ? 18 : 90;
    asked.samples = 4;
    asked.want_radiance_double = true;
    const Frame frame = render(scene, asked);
    std::printf("%s %llu", std::string(name).c_str(), static_cast<unsigned long long>(frame.counts.shaded));
    if (precision != Precision::fast) // promises no bits
      std::printf(" %016llx", static_cast<unsigned long long>(hash_of(frame.radiance_double)));
    std::puts("");
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
