// The worked example of CONTRIBUTING.md does what that page says.

#include <refraster/files.h>
#include <refraster/mesh.h>
#include <refraster/render.h>

#include "minnaert.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace refraster;

#include "worked_by_hand.inc"

TEST_CASE("the example runs over every number") {
  const auto shaded = []<class T>(T) {
    const Vec3<T> up(T(0), T(0), T(1));
    return reflected(moon::Minnaert{}, Fragment<T>{up, up, up, Rgb<T>(T(1)), nullptr}, Incident<T>{up, Rgb<T>(T(1))});
  };
  CHECK(shaded(Wide<float, 8>(0)).x[7] == 1);
  CHECK(shaded(Wide<double, 4>(0)).x[3] == 1);
  CHECK(static_cast<double>(shaded(Exact(0)).x) == 1);
  using Bounds = Interval<DoubleArithmetic>;
  CHECK(shaded(Bounds(0)).x.lo <= 1);
  CHECK(shaded(Bounds(0)).x.hi >= 1);
}

TEST_CASE("the example has fewer than 45 lines of header") {
  std::ifstream header(REFRASTER_BUILD_DIR "/tests/system/contributing/minnaert.h");
  int lines = 0;
  for (std::string line; std::getline(header, line);) ++lines;
  CHECK(lines > 0);
  CHECK(lines < 45);
}

namespace {

/// A working folder of its own, for as long as it lives.
struct Within {
  std::filesystem::path before = std::filesystem::current_path();
  explicit Within(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
  ~Within() { std::filesystem::current_path(before); }
};

} // namespace

TEST_CASE("the example's material of C++ and that of a scene file show the same") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "refraster_moon";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "moon.json") << R"({"scene": {
    "camera": {"position": "0 0 4", "fov_y": 40}, "point_lights": [],
    "direction_lights": [{"direction": "-1 -1 -1", "radiance": "1 1 1"}],
    "objects": [{"mesh": {"sphere": {}}, "fragment_function": "minnaert", "position": "0 0 0", "rotate_x": 0,
      "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
      "material": {"ka": "0.05 0.05 0.05", "kd": "1 1 1", "darkening": 2}}]}})";
  const Within within(folder);
  Object object;
#include "registration.inc"
  REQUIRE(scene.objects.size() == 1);
  REQUIRE(scene.objects[0].material.user_function);
  Scene built = scene;
  built.objects[0].material = object.material;
  const RenderOptions options{.width = 48, .height = 48, .threads = 1};
  const Frame read = render(scene, options);
  CHECK(read.counts.shaded > 500);
  CHECK(read.rgb8.values == render(built, options).rgb8.values);
  // A full moon is flat, with k = 1 it is Lambert's ball.
  built.objects[0].material.user_function = user_function(moon::Minnaert{.darkening = 1});
  CHECK(read.rgb8.values != render(built, options).rgb8.values);
}
