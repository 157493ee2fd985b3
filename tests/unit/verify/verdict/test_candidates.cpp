// What a pixel may show.

#include "tests/support/raster/window_scene.h"
#include "verify/bounds/candidates.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace refraster::test {
namespace {

constexpr int side = 16;
constexpr SamplePosition centre{subpixels / 2, subpixels / 2};

DeviceProfile narrow_profile() {
  DeviceProfile profile;
  profile.raster.setup_positions = SetupPositions::snapped;
  profile.interpolation = {InterpolationAnchor::triangle, 4, 0};
  return profile;
}

/// The numbers of the triangles that pixel (x, y) may show.
std::vector<std::uint32_t> shown(const WindowScene& window, int x, int y, bool& background) {
  const DeviceProfile profile = narrow_profile();
  const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::one);
  const std::vector<VisibleSet> sets = find_candidates(frame, {{x, y}}, centre);
  background = sets.at(0).background;
  std::vector<std::uint32_t> numbers;
  for (const Candidate& c : sets[0].candidates) numbers.push_back(c.number);
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;

/// A square from (2, 2) to (14, 14) at distance w, cut along the diagonal through pixel centres; its second half may
/// have corners of its own, some way off.
void add_square(WindowScene& window, double w, double apart = 0, bool turned = false) {
  const Float3 a = window.place(2, 2, w), b = window.place(14, 2, w), c = window.place(14, 14, w),
               d = window.place(2, 14, w);
  const Float3 a2 = window.place(2 - apart, 2 + apart, w), c2 = window.place(14 - apart, 14 + apart, w);
  if (turned) window.add({a, b, c, a2, d, c2});
  else window.add({a, b, c, a2, c2, d});
}

} // namespace

TEST_CASE("inside a triangle that nothing else covers, it is seen and nothing else") {
  WindowScene window(side);
  add_square(window, 1);
  bool background = true;
  CHECK(shown(window, 10, 4, background) == Numbers{0});
  CHECK(!background);
  CHECK(shown(window, 4, 10, background) == Numbers{1});
  CHECK(shown(window, 0, 0, background).empty());
  CHECK(background);
}

TEST_CASE("at an edge that two triangles share either is seen, and never what lies behind") {
  WindowScene window(side);
  add_square(window, 1);
  add_square(window, 2);
  bool background = true;
  CHECK(shown(window, 7, 7, background) == Numbers{0, 1});
  CHECK(!background);
}

TEST_CASE("between edges that are not the same, what lies behind may be seen") {
  const double apart = 0.25 / 256; // less than rounding may make of it
  WindowScene window(side);
  add_square(window, 1, apart);
  bool background = false;
  CHECK(shown(window, 7, 7, background) == Numbers{0, 1});
  CHECK(background);
  add_square(window, 2);
  CHECK(shown(window, 7, 7, background) == Numbers{0, 1, 2, 3});
  CHECK(!background); // the farther square has no gap
}

TEST_CASE("at a fold the two sides may both miss the sample") {
  WindowScene window(side);
  add_square(window, 1, 0, true);
  bool background = false;
  CHECK(shown(window, 7, 7, background) == Numbers{0, 1});
  CHECK(background);
}

TEST_CASE("around a corner all that meet there may be seen, and together leave no hole") {
  WindowScene window(side);
  const Float3 middle = window.place(8.5, 8.5, 1);
  const std::array<Float3, 4> ring = {window.place(2, 2, 1), window.place(2, 14, 1), window.place(14, 14, 1),
                                      window.place(14, 2, 1)};
  std::vector<Float3> corners;
  for (std::size_t i = 0; i < 4; ++i) corners.insert(corners.end(), {middle, ring[i], ring[(i + 1) % 4]});
  window.add(corners);
  bool background = true;
  CHECK(shown(window, 8, 8, background) == Numbers{0, 1, 2, 3});
  CHECK(!background);
  // Without one of them there is a hole.
  WindowScene open(side);
  corners.resize(9);
  open.add(corners);
  CHECK(shown(open, 8, 8, background) == Numbers{0, 1, 2});
  CHECK(background);
}

TEST_CASE("of surfaces that are equally far as far as the device can tell, either is seen") {
  WindowScene window(side);
  add_square(window, 1);
  add_square(window, 1 + 1e-7);
  add_square(window, 1.01);
  bool background = true;
  CHECK(shown(window, 10, 4, background) == Numbers{0, 2});
}

TEST_CASE("of the same triangle twice the first is seen, whatever a device makes of it") {
  WindowScene window(side);
  add_square(window, 1.3);
  add_square(window, 1.3);
  bool background = true;
  CHECK(shown(window, 10, 4, background) == Numbers{0});
  // With its corners in another order it is another one.
  std::vector<Float3> corners = window.scene.objects[1].mesh->positions;
  std::swap(corners[0], corners[1]), std::swap(corners[1], corners[2]);
  WindowScene turned(side);
  add_square(turned, 1.3);
  turned.add(corners);
  CHECK(shown(turned, 10, 4, background) == Numbers{0, 2});
}

TEST_CASE("what a depth plane may cut off may be missing") {
  WindowScene window(side, 1, 100);
  add_square(window, 1); // on the near plane
  bool background = false;
  CHECK(shown(window, 10, 4, background) == Numbers{0});
  CHECK(background);
  WindowScene before(side, 1.1, 100);
  add_square(before, 1);
  CHECK(shown(before, 10, 4, background).empty());
}

TEST_CASE("faces that are seen from behind are not drawn where the scene says so") {
  WindowScene window(side);
  add_square(window, 1);
  window.scene.objects[0].cull = Cull::back;
  bool background = false;
  CHECK(shown(window, 10, 4, background).empty()); // it runs clockwise
  CHECK(background);
}

TEST_CASE("many pixels in any order are each told what they may show") {
  WindowScene window(side);
  add_square(window, 1);
  const DeviceProfile profile = narrow_profile();
  const DeviceFrame frame(window.scene, window.options(), profile, ShaderMatrices::one);
  std::vector<PixelPlace> places;
  for (int i = 0; i < side * side; ++i) places.push_back({i * 7 % side, (side * side - 1 - i) / side});
  const std::vector<VisibleSet> sets = find_candidates(frame, places, centre);
  for (std::size_t i = 0; i < places.size(); ++i) {
    bool background = false;
    const Numbers alone = shown(window, places[i].x, places[i].y, background);
    REQUIRE(sets[i].candidates.size() == alone.size());
    REQUIRE(sets[i].background == background);
  }
}

} // namespace refraster::test
