// Where a triangle may be on a device: corners are moved as far as a profile allows, and what was said must hold.

#include "tests/support/random.h"
#include "tests/support/raster/window_scene.h"
#include "verify/bounds/device_triangle.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace refraster::test {
namespace {

constexpr int side = 32;

DeviceProfile profile_of(double lattice, SetupPositions positions) {
  DeviceProfile profile;
  profile.raster.lattice = lattice, profile.raster.snap_steps = 0.5;
  profile.raster.setup_positions = positions;
  profile.interpolation.units = 6, profile.interpolation.relative = 0;
  return profile;
}

/// Twice the signed areas that a point makes with the edges opposite each corner, positive inside; 0 for no triangle.
std::array<double, 3> areas(const std::array<Double2, 3>& corner, const Double2& p) {
  const auto area = [](const Double2& a, const Double2& b, const Double2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double all = area(corner[0], corner[1], corner[2]);
  std::array<double, 3> result{};
  if (all == 0) return result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = area(corner[(k + 1) % 3], corner[(k + 2) % 3], p) * (all < 0 ? -1 : 1);
  return result;
}

struct Corner {
  Double2 at{0};
  double w = 1;
};

/// A triangle as a scene has it, and ways in which a device may have it.
struct MovedTriangles {
  WindowScene window{side};
  std::array<Corner, 3> corner;
  explicit MovedTriangles(const std::array<Corner, 3>& corners) : corner(corners) {
    std::vector<Float3> places;
    for (const Corner& c : corner) places.push_back(window.place(c.at.x, c.at.y, c.w));
    window.add(places);
    // What the scene holds is what was rounded to floats.
    for (std::size_t i = 0; i < 3; ++i) {
      const Float3 p = places[i];
      corner[i].w = -static_cast<double>(p.z);
      const double half = side / 2.0;
      corner[i].at = {half + half * static_cast<double>(p.x) / corner[i].w,
                      half - half * static_cast<double>(p.y) / corner[i].w};
    }
  }
  /// Corners moved by at most `reach` along each axis; every other time as far as that.
  std::array<Double2, 3> moved(double reach, Random& random) const {
    std::array<Double2, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto step = [&] {
        return random.uniform(0, 1) < 0.5 ? random.uniform(-reach, reach) : random.uniform(0, 1) < 0.5 ? -reach : reach;
      };
      result[i] = corner[i].at + Double2(step(), step());
    }
    return result;
  }
};

std::array<Corner, 3> random_corners(Random& random) {
  std::array<Corner, 3> corner;
  const double size = std::exp2(random.uniform(-9, 5));
  const Double2 about(random.uniform(0, side), random.uniform(0, side));
  for (Corner& c : corner) {
    c.at = about + Double2(random.uniform(-size, size), random.uniform(-size, size));
    c.w = std::exp2(random.uniform(0, 3));
  }
  if (random.uniform(0, 1) < 0.3)
    corner[2].at = corner[0].at + (corner[1].at - corner[0].at) * random.uniform(-0.5, 1.5);
  return corner;
}

/// Window depth of a point of a moved triangle: z / w is linear in the window.
double depth_at(const std::array<Double2, 3>& at, const std::array<double, 3>& z, const Double2& p) {
  const std::array<double, 3> weight = areas(at, p);
  const double sum = weight[0] + weight[1] + weight[2];
  return (weight[0] * z[0] + weight[1] * z[1] + weight[2] * z[2]) / sum;
}

} // namespace

TEST_CASE("whatever corners a device rounds, a sample that is certain is certain, and depths and shifts hold") {
  Random random(1);
  long inside = 0, ambiguous = 0, outside = 0;
  for (int n = 0; n < 3000; ++n) {
    const double lattice = n % 3 == 0 ? 1.0 / 16 : 1.0 / 256;
    const DeviceProfile profile = profile_of(lattice, n % 2 ? SetupPositions::snapped : SetupPositions::either);
    const MovedTriangles triangles(random_corners(random));
    const RenderOptions options = triangles.window.options();
    const DeviceFrame frame(triangles.window.scene, options, profile, ShaderMatrices::one);
    const DeviceTriangle device(frame, 0);
    REQUIRE(device.is_seen());
    const PixelRect box = device.pixels();
    std::array<double, 3> z{};
    std::array<Double2, 3> ours;
    for (std::size_t i = 0; i < 3; ++i) {
      const WindowVertex v = frame.context().geometry.window[device.ref().vertex[i]];
      z[i] = 0.5 * v.z + 0.5;
      ours[i] = Double2(v.x, v.y) / double{subpixels};
    }
    for (int way = 0; way < 6; ++way) {
      const std::array<Double2, 3> moved = triangles.moved(lattice / 2, random);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const Double2 p(x + 0.5, y + 0.5);
          const std::array<double, 3> area = areas(moved, p);
          const double least = std::min({area[0], area[1], area[2]});
          const Coverage coverage = device.coverage(p.x, p.y);
          const bool in_box = x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
          if (least > 0) REQUIRE(in_box);
          if (coverage.certainty == Coverage::Certainty::inside) {
            ++inside;
            REQUIRE(least > 0);
          } else if (coverage.certainty == Coverage::Certainty::outside) {
            ++outside;
            REQUIRE(least <= 0);
          } else {
            ++ambiguous;
            REQUIRE(coverage.ambiguous_edges != 0);
            // What is certain of it is so: only those edges may be on the other side.
            if (least < 0 && device.may_face_front() != device.may_face_back())
              for (std::size_t k = 0; k < 3; ++k)
                if (area[k] < 0) REQUIRE((coverage.ambiguous_edges >> k & 1) == 1);
          }
          if (least <= 0) continue;
          const ValueRange depth = device.depth(p.x, p.y);
          const double there = depth_at(moved, z, p);
          REQUIRE(depth.lo <= there);
          REQUIRE(there <= depth.hi);
          // The same weights of our corners are at another point: that is the shift.
          const double sum = area[0] + area[1] + area[2];
          const Double2 seen = (ours[0] * area[0] + ours[1] * area[1] + ours[2] * area[2]) / sum;
          if (profile.raster.setup_positions == SetupPositions::snapped) continue; // it then has lattice points only
          const SampleShift shift = device.shift(p.x, p.y);
          for (int axis = 0; axis < 2; ++axis) {
            const double by = (seen[axis] - p[axis]) * subpixels;
            // Doubles lose less than this on the way.
            REQUIRE(std::abs(by - shift.centre[axis]) <= shift.radius[axis] + 1e-6 / sum);
          }
        }
    }
  }
  CHECK(inside > 100'000);
  CHECK(ambiguous > 1'000);
  CHECK(outside > 1'000'000);
}

TEST_CASE("what is ambiguous is no more than a step of the lattice at an edge") {
  const DeviceProfile profile = profile_of(1.0 / 256, SetupPositions::snapped);
  WindowScene window(side);
  window.add({window.place(2, 2, 1), window.place(30, 2, 1), window.place(2, 30, 1)});
  const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::one);
  const DeviceTriangle triangle(frame, 0);
  const double near = 0.75 / 256,
               far = 0.25 / 256; // half a step and what the vertex stage loses: less than three quarters
  const auto at = [&](double x, double y) { return triangle.coverage(x, y).certainty; };
  CHECK(at(2 + near, 10) == Coverage::Certainty::inside);
  CHECK(at(2 - near, 10) == Coverage::Certainty::outside);
  CHECK(at(2 + far, 10) == Coverage::Certainty::ambiguous);
  CHECK(at(2 - far, 10) == Coverage::Certainty::ambiguous);
  CHECK(triangle.coverage(2, 10).ambiguous_edges == 2); // the edge opposite the second corner
  CHECK(triangle.coverage(2, 2).ambiguous_edges == 6);  // the first corner, where two meet
}

TEST_CASE("a device that rounds to our lattice has our points, but where they are nearly halfway") {
  const DeviceProfile profile = profile_of(1.0 / 256, SetupPositions::snapped);
  for (const double offset : {0.0, 0.25 / 256, 0.5 / 256}) {
    WindowScene window(side);
    const double x = 2 + offset;
    window.add({window.place(x, 2, 1), window.place(x + 28, 2, 1), window.place(x, 30, 1)});
    const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::one);
    const SampleShift shift = DeviceTriangle(frame, 0).shift(8.5, 8.5);
    const double of_weights = 0.01; // of floats, in an image of 32 pixels
    CHECK(shift.radius.y < of_weights);
    if (offset < 0.5 / 256) CHECK(shift.radius.x < of_weights);
    else CHECK(shift.radius.x >= 0.5);
  }
}

TEST_CASE("a corner near the eye plane, whose place in the window is hardly known, moves no sample far") {
  const DeviceProfile profile = profile_of(1.0 / 256, SetupPositions::exact);
  WindowScene window(side, 1e-6);
  // In the window the first corner lies 16 million pixels to the left; floats of a camera far off say so to 1 in 16.
  window.add({Float3(-1, 0.1f, -1e-6f), window.place(30, 2, 1), window.place(30, 30, 1)});
  window.scene.camera.position = {4, 4, 4};
  window.scene.camera.target = {4, 4, 3};
  window.scene.objects[0].position = {4, 4, 4};
  const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::three);
  const DeviceTriangle triangle(frame, 0);
  REQUIRE(triangle.is_seen());
  const SampleShift shift = triangle.shift(20.5, 16.5);
  CHECK(shift.radius.x < 2);
  CHECK(shift.radius.y < 2);
  CHECK(triangle.coverage(20.5, 16.5).certainty == Coverage::Certainty::inside);
  CHECK(triangle.coverage(31.5, 16.5).certainty == Coverage::Certainty::outside);
}

TEST_CASE("which side a triangle shows is open only if rounding may turn it over") {
  const DeviceProfile profile = profile_of(1.0 / 256, SetupPositions::snapped);
  const auto facing = [&](double height) {
    WindowScene window(side);
    window.add({window.place(4, 16, 1), window.place(28, 16, 1), window.place(16, 16 + height, 1)});
    const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::one);
    const DeviceTriangle triangle(frame, 0);
    return std::pair(triangle.may_face_front(), triangle.may_face_back());
  };
  CHECK(facing(-4) == std::pair(true, false)); // counter-clockwise in the image
  CHECK(facing(4) == std::pair(false, true));
  CHECK(facing(0.1 / 256) == std::pair(true, true));
}

TEST_CASE("a triangle behind the eye is not seen; one that reaches behind it is") {
  const DeviceProfile profile = profile_of(1.0 / 256, SetupPositions::exact);
  WindowScene window(side);
  window.add({Float3(0, 0, 1), Float3(1, 0, 1), Float3(0, 1, 2)});
  window.add({Float3(-1, -1, -2), Float3(1, -1, -2), Float3(0, -1, 4)});
  const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::one);
  CHECK(!DeviceTriangle(frame, 0).is_seen());
  const DeviceTriangle ground(frame, 1);
  REQUIRE(ground.is_seen());
  // Its front edge is at y = 24; below that it goes on to the lower border.
  CHECK(ground.coverage(16.5, 23.5).certainty == Coverage::Certainty::outside);
  CHECK(ground.coverage(16.5, 25.5).certainty == Coverage::Certainty::inside);
  CHECK(ground.coverage(16.5, 31.5).certainty == Coverage::Certainty::inside);
  CHECK(ground.coverage(16.5, 24).certainty == Coverage::Certainty::ambiguous);
}

} // namespace refraster::test
