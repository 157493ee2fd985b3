// refraster_png_cost [--packings] IMAGE...
// A table of what it takes to make a PNG of each image: by stb_image_write, which wrote them before, and by ours, by 1
// and 2 threads; with --packings, of zlib's levels and strategies. The least of five times; the two take turns.

#include <refraster/files.h>

#include "io/image/png/png_write.h"
#include "raster/stopwatch.h"

#include <stb_image_write.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace refraster;

constexpr int repetitions = 5;

struct Cost {
  double milliseconds = std::numeric_limits<double>::infinity();
  std::size_t bytes = 0;

  template <class Work>
  void measure(const Work& work) {
    const Stopwatch stopwatch;
    bytes = work();
    milliseconds = std::min(milliseconds, stopwatch.milliseconds());
  }
};

std::size_t stb_bytes(const Image<std::uint8_t>& image) {
  std::size_t bytes = 0;
  const auto count = [](void* sum, void*, int size) { *static_cast<std::size_t*>(sum) += static_cast<std::size_t>(size); };
  stbi_write_png_to_func(count, &bytes, image.width, image.height, image.channels, image.values.data(),
                         image.width * image.channels);
  return bytes;
}

std::string name_of(const std::string& path) {
  const std::string name = path.substr(path.rfind('/') + 1);
  return name.substr(0, name.rfind('.'));
}

void print_costs(const std::string& path, const Image<std::uint8_t>& image) {
  Cost stb, one, two;
  for (int i = 0; i < repetitions; ++i) {
    stb.measure([&] { return stb_bytes(image); });
    one.measure([&] { return png_file(image, {.threads = 1}).size(); });
    two.measure([&] { return png_file(image, {.threads = 2}).size(); });
  }
  std::printf("| %s | %.0f | %.0f | %.0f | %.1f | %zu | %zu | %.3f |\n", name_of(path).c_str(), stb.milliseconds,
              one.milliseconds, two.milliseconds, stb.milliseconds / two.milliseconds, stb.bytes / 1024,
              two.bytes / 1024, static_cast<double>(two.bytes) / static_cast<double>(stb.bytes));
}

void print_packings(const std::string& path, const Image<std::uint8_t>& image) {
  struct Strategy {
    const char* name;
    int value;
  };
  const double stb = static_cast<double>(stb_bytes(image));
  for (const Strategy& strategy : {Strategy{"default", Z_DEFAULT_STRATEGY}, {"filtered", Z_FILTERED}, {"rle", Z_RLE}})
    for (int level = 1; level <= 9; ++level) {
      if (strategy.value == Z_RLE && level > 1) continue; // which has no levels
      Cost cost;
      for (int i = 0; i < repetitions; ++i)
        cost.measure([&] { return png_file(image, {.threads = 1}, {level, strategy.value}).size(); });
      std::printf("| %s | %s | %d | %.0f | %.3f |\n", name_of(path).c_str(), strategy.name, level, cost.milliseconds,
                  static_cast<double>(cost.bytes) / stb);
    }
}

Image<std::uint8_t> levels_of(const std::string& path) {
  const ImageFile file = read_image(path);
  Image<std::uint8_t> image(file.values.width, file.values.height, file.values.channels);
  std::transform(file.values.values.begin(), file.values.values.end(), image.values.begin(),
                 [](float value) { return static_cast<std::uint8_t>(value); });
  return image;
}

} // namespace

int main(int argc, char** argv) try {
  const bool packings = argc > 1 && std::strcmp(argv[1], "--packings") == 0;
  std::puts(packings ? "| image | strategy | level | ms | size / stb's |\n|---|---|---|---|---|"
                     : "| image | stb ms | 1 thread ms | 2 threads ms | stb / 2 threads | stb KiB | KiB | size / stb's |\n"
                       "|---|---|---|---|---|---|---|---|");
  for (int i = packings ? 2 : 1; i < argc; ++i) {
    const std::string path = argv[i];
    (packings ? print_packings : print_costs)(path, levels_of(path));
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "refraster_png_cost: %s\n", error.what());
  return 3;
}
