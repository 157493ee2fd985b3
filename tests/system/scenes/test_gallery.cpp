// Laws that hold for every image of the gallery.

#include <refraster/files.h>
#include <refraster/image.h>

#include "tests/support/scenes/listed_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace refraster {
namespace {

/// Levels, radiance and all AOVs.
RenderOptions everything(int width, int height, Precision precision = Precision::double_) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.precision = precision;
  options.want_radiance = true;
  for (int aov = 0; aov < static_cast<int>(Aov::count_); ++aov) options.aovs.push_back(static_cast<Aov>(aov));
  return options;
}

template <class Value>
bool same_bits(const Image<Value>& a, const Image<Value>& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels &&
         std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(Value)) == 0;
}

template <class Value>
Image<Value> cut_out(const Image<Value>& image, const PixelRect& crop) {
  Image<Value> part(crop.width, crop.height, image.channels);
  for (int y = 0; y < crop.height; ++y)
    std::copy_n(image.at(crop.x, crop.y + y), crop.width * image.channels, part.at(0, y));
  return part;
}

void check_same(const Frame& a, const Frame& b) {
  CHECK(same_bits(a.rgb8, b.rgb8));
  CHECK(same_bits(a.radiance, b.radiance));
  REQUIRE(a.aovs.size() == b.aovs.size());
  for (std::size_t i = 0; i < a.aovs.size(); ++i) CHECK_MESSAGE(same_bits(a.aovs[i], b.aovs[i]), aov_kinds[i].name);
}

/// The greatest difference between the 8-bit images of the precisions double and float, in levels.
int float_difference(const Scene& scene, int width, int height) {
  RenderOptions options;
  options.width = width, options.height = height;
  const Frame reference = render(scene, options);
  options.precision = Precision::float_;
  const Frame fast = render(scene, options);
  int most = 0;
  for (std::size_t i = 0; i < reference.rgb8.values.size(); ++i)
    most = std::max(most, std::abs(int{reference.rgb8.values[i]} - int{fast.rgb8.values[i]}));
  return most;
}

/// What 999 of 1000 values of a fast image keep to, as difference from double in levels of an 8-bit image.
double fast_difference(const Scene& scene, int width, int height) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.want_rgb8 = false, options.want_radiance = true;
  const Frame reference = render(scene, options);
  options.precision = Precision::fast;
  const Frame fast = render(scene, options);
  std::vector<double> levels;
  const auto level = [](float x) { return 255 * std::clamp(static_cast<double>(x), 0.0, 1.0); };
  for (std::size_t i = 0; i < reference.radiance.values.size(); ++i)
    levels.push_back(std::abs(level(reference.radiance.values[i]) - level(fast.radiance.values[i])));
  const auto place = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 1000 * 999);
  std::nth_element(levels.begin(), place, levels.end());
  return *place;
}

/// Each law is checked on the scenes that are quickly read in every run, and on all in the slow suite.
template <class Law>
void for_scenes(const std::vector<std::string>& paths, const Law& law) {
  for (const std::string& path : paths) {
    CAPTURE(path);
    law(listed_scene(path));
  }
}

void check_finite(const Scene& scene) {
  for (const Precision precision : {Precision::double_, Precision::float_, Precision::fast}) {
    const Frame frame = render(scene, everything(160, 90, precision));
    const auto finite = [](const Image<float>& image) {
      return std::all_of(image.values.begin(), image.values.end(), [](float x) { return std::isfinite(x); });
    };
    CHECK(finite(frame.radiance));
    for (std::size_t i = 0; i < frame.aovs.size(); ++i) CHECK_MESSAGE(finite(frame.aovs[i]), aov_kinds[i].name);
    CHECK(frame.counts.undefined[Undefined::not_finite] == 0);
    CHECK(frame.counts.shaded > 0);
  }
}

void check_crop(const Scene& scene, const Frame& whole_frame, RenderOptions options, const PixelRect& crop) {
  options.crop = crop;
  options.threads = 3, options.tile_size = 16;
  const Frame part = render(scene, options);
  CHECK(same_bits(part.rgb8, cut_out(whole_frame.rgb8, crop)));
  CHECK(same_bits(part.radiance, cut_out(whole_frame.radiance, crop)));
  for (std::size_t i = 0; i < part.aovs.size(); ++i)
    CHECK_MESSAGE(same_bits(part.aovs[i], cut_out(whole_frame.aovs[i], crop)), aov_kinds[i].name);
}

} // namespace

TEST_CASE("every value of an image is a finite number, in every precision") {
  for_scenes(quick_scenes(), check_finite);
}

TEST_CASE("no pixel of a float image is more than one level from the double image") {
  for_scenes(quick_scenes(), [](const Scene& scene) { CHECK(float_difference(scene, 320, 180) <= 1); });
}

TEST_CASE("999 of 1000 values of a fast image are within half a level of double") {
  for_scenes(quick_scenes(), [](const Scene& scene) { CHECK(fast_difference(scene, 320, 180) <= 0.5); });
}

TEST_CASE("threads and tiles change no bit, and a crop is a part of the whole image") {
  for_scenes(quick_scenes(), [](const Scene& scene) {
    const RenderOptions whole = everything(131, 74); // no multiple of a tile or of a register
    const Frame reference = render(scene, whole);
    constexpr int threads[] = {1, 2, 3, 7}, tile_sizes[] = {8, 16, 32, 128};
    for (std::size_t i = 0; i < 4; ++i) {
      CAPTURE(tile_sizes[i]);
      RenderOptions options = whole;
      options.threads = threads[i], options.tile_size = tile_sizes[i];
      check_same(render(scene, options), reference);
    }
    check_crop(scene, reference, whole, {37, 19, 61, 29});
  });
}

TEST_CASE("the lecture's file says what the lecture says") {
  const Scene& scene = listed_scene(std::string(REFRASTER_SOURCE_DIR) + "/scenes/lecture/config.json");
  CHECK(scene.camera.position == Double3(0, 0, 6));
  REQUIRE(scene.point_lights.size() == 1);
  CHECK(scene.point_lights[0].position == Double3(0, 0, -10));
  CHECK(scene.point_lights[0].radiance == Double3(1, 1, 1));
  CHECK(scene.point_lights[0].constant == 1);
  CHECK(scene.point_lights[0].linear == 0.09);
  CHECK(scene.point_lights[0].quadratic == 0.032);
  REQUIRE(scene.direction_lights.size() == 1);
  CHECK(scene.direction_lights[0].direction == Double3(-0.2, -1, -0.3));
  CHECK(scene.direction_lights[0].radiance == Double3(0.1, 0.1, 0.1));
  REQUIRE(scene.objects.size() == 1);
  const Object& cube = scene.objects[0];
  CHECK(cube.mesh->triangles.size() == 12);
  CHECK(cube.scale == Double3(1, 1, 1));
  const Phong* phong = std::get_if<Phong>(&cube.material.fragment_function);
  REQUIRE(phong != nullptr);
  CHECK(phong->ka == Double3(0.05));
  CHECK(phong->kd == Double3(1));
  CHECK(phong->ks == Double3(1));
  CHECK(phong->glossiness == 8);
  CHECK(cube.material.diffuse_map.texture != nullptr);
}

TEST_CASE("the committed textures are those that make_textures makes") {
  namespace fs = std::filesystem;
  const fs::path made = fs::path(REFRASTER_BUILD_DIR) / "made_textures";
  const fs::path committed = fs::path(REFRASTER_SOURCE_DIR) / "scenes" / "gallery" / "assets" / "textures";
  fs::create_directories(made);
  const std::string command = REFRASTER_EMULATOR REFRASTER_BUILD_DIR "/scenes/make_textures " + made.string();
  REQUIRE(std::system((command + " >/dev/null").c_str()) == 0);
  const auto values = [](const fs::path& path) { return read_image(path).values; };
  int textures = 0;
  for (const auto& entry : fs::directory_iterator(made)) {
    CAPTURE(entry.path().filename().string());
    CHECK(same_bits(values(entry.path()), values(committed / entry.path().filename())));
    ++textures;
  }
  CHECK(textures == std::distance(fs::directory_iterator(committed), fs::directory_iterator()));
  // Scenes name no files outside their own folder: these are copies.
  const fs::path root = REFRASTER_SOURCE_DIR;
  CHECK(same_bits(values(root / "scenes/lecture/resource/textures/wood.png"), values(committed / "wood.png")));
  for (const auto& entry : fs::directory_iterator(root / "bench/scenes/textures")) {
    CAPTURE(entry.path().filename().string());
    CHECK(same_bits(values(entry.path()), values(committed / entry.path().filename())));
  }
}

TEST_SUITE("slow") {
  TEST_CASE("every value of every image of the gallery is a finite number") {
    for_scenes(listed_scenes(), check_finite);
  }

  TEST_CASE("at full size, no pixel of a float image is more than one level from the double image") {
    for_scenes(listed_scenes(), [](const Scene& scene) { CHECK(float_difference(scene, 1280, 720) <= 1); });
  }

  TEST_CASE("at full size, 999 of 1000 values of a fast image are within half a level of double") {
    for_scenes(listed_scenes(), [](const Scene& scene) { CHECK(fast_difference(scene, 1280, 720) <= 0.5); });
  }

  TEST_CASE("every thread count with every tile size gives the same bits, in double and in float") {
    for_scenes(listed_scenes(), [](const Scene& scene) {
      for (const Precision precision : {Precision::double_, Precision::float_}) {
        RenderOptions options = everything(211, 119, precision);
        const Frame reference = render(scene, options);
        for (const int threads : {1, 2, 3, 7})
          for (const int tile_size : {8, 16, 32, 64, 128}) {
            CAPTURE(threads);
            CAPTURE(tile_size);
            options.threads = threads, options.tile_size = tile_size;
            check_same(render(scene, options), reference);
          }
        check_crop(scene, reference, options, {58, 33, 101, 52});
      }
    });
  }
}

} // namespace refraster
