// The extremes (docs/extremes.md), rows C: coverage.

#include "raster/samples.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/oracle.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;
using namespace refraster::test;

namespace {

using Corners = std::array<LatticePoint, 3>;

std::optional<AnyTriangle> on_lattice(const Corners& c) {
  const auto vertex = [](LatticePoint p) {
    return lattice_vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
  };
  return set_up_on_lattice({vertex(c[0]), vertex(c[1]), vertex(c[2])});
}

bool covers(const Corners& c, int x, int y) {
  const auto t = on_lattice(c);
  return t && t->covers(x, y);
}

// Lattice coordinates of a point given in pixels.
LatticePoint pixels(double x, double y) {
  return {static_cast<std::int64_t>(x * 256), static_cast<std::int64_t>(y * 256)};
}

// Whether the centre of pixel (px, py) is covered by a triangle with corners in pixels.
bool covers_centre(std::array<std::pair<double, double>, 3> corner, int px, int py) {
  Corners c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = pixels(corner[k].first, corner[k].second);
  return covers(c, px * 256 + 128, py * 256 + 128);
}

struct GridMesh {
  std::vector<Corners> triangles;
};

// Squares of about `step` pixels whose corners are moved about, some of them onto sample centres. A corner moves by
// less than a third of a square: with x and y each, the two corners on a square's diagonal stay on their sides of it,
// so that no triangle is turned over and the mesh has neither gaps nor overlaps.
GridMesh jittered_grid(int columns, int rows, int step, Random& random) {
  std::vector<LatticePoint> corner;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const bool on_border = i == 0 || j == 0 || i == columns || j == rows;
      const int reach = on_border ? 0 : step * 256 / 5;
      const auto moved = [&](int k) { return k * step * 256 + (reach ? random.below(2 * reach) - reach : 0); };
      LatticePoint p{moved(i), moved(j)};
      if (random.below(3) == 0 && !on_border && step >= 4) // half a pixel is an eighth of the square at most
        p = {(p.x & ~std::int64_t{255}) + 128, (p.y & ~std::int64_t{255}) + 128};
      corner.push_back(p);
    }
  GridMesh grid;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto at = [&](int di, int dj) {
        return corner[static_cast<std::size_t>((j + dj) * (columns + 1) + i + di)];
      };
      grid.triangles.push_back({at(0, 0), at(1, 0), at(0, 1)});
      grid.triangles.push_back({at(1, 1), at(0, 1), at(1, 0)});
    }
  return grid;
}

// The number of samples of pixels [0, width) x [0, height) that are not covered exactly once.
long not_once(const GridMesh& grid, int width, int height, SamplePosition sample) {
  std::vector<int> owners(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (const Corners& c : grid.triangles) {
    const auto t = on_lattice(c);
    if (!t) continue;
    const auto [x0, x1] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [y0, y1] = std::minmax({c[0].y, c[1].y, c[2].y});
    const auto pixel = [](std::int64_t v, int end) {
      return static_cast<int>(std::clamp<std::int64_t>(v / 256, 0, end - 1));
    };
    for (int y = pixel(y0, height); y <= pixel(y1, height); ++y)
      for (int x = pixel(x0, width); x <= pixel(x1, width); ++x)
        owners[static_cast<std::size_t>(y * width + x)] += t->covers(x * 256 + sample.x, y * 256 + sample.y);
  }
  return static_cast<long>(owners.size()) - std::count(owners.begin(), owners.end(), 1);
}

} // namespace

TEST_CASE("C1: a triangle without area has no fragments and is counted") {
  WindowScene window(16);
  const Float3 a = window.place(1, 1, 1), b = window.place(13, 4, 1);
  window.add({a, b, a});                                                             // a corner repeated
  window.add({a, window.place(7, 2.5, 1), b});                                       // on one line
  window.add({a, b, window.place(7, 2.5 + 0x1p-11, 1)});                             // only after snapping
  window.add({window.place(3, 3, 1), window.place(3, 3, 2), window.place(3, 3, 4)}); // seen along an edge
  window.add({window.place(3, 3, 1), window.place(8, 8, 2), Float3(0, 0, 0)});       // seen edge-on, through the eye
  const Frame frame = window.frame({Aov::object});
  CHECK(frame.counts.degenerate == 5);
  CHECK(frame.counts.drawn == 0);
  CHECK(drawn_pixels(frame) == 0);
}

TEST_CASE(
    "C2: a sliver a millionth of a pixel high covers nothing; one of a subpixel covers a row of centres it owns") {
  WindowScene window(16);
  const auto sliver = [&](double y, double height) {
    WindowScene one = window;
    one.add({one.place(1, y, 1), one.place(15, y, 1), one.place(15, y + height, 1)});
    return one.frame({Aov::object});
  };
  CHECK(sliver(5.25, 1e-6).counts.degenerate == 1);
  CHECK(sliver(5.5, 1e-6).counts.degenerate == 1); // through centres, but not after snapping
  // From the row of centres 1/256 down: a top edge through 14 centres, from x = 1.5 to 14.5.
  const Frame below = sliver(5.5, 1.0 / 256);
  CHECK(drawn_pixels(below) == 14);
  for (int x = 1; x < 15; ++x) CHECK(is_drawn(below, x, 5));
  // Upward, its edge through the centres is a bottom edge: they are not its own.
  CHECK(drawn_pixels(sliver(5.5, -1.0 / 256)) == 0);
}

TEST_CASE("C3: a centre on an edge or a corner belongs to the triangle that the top-left rule names") {
  // The centre (4.5, 4.5) of pixel (4, 4) on each kind of edge. y goes down.
  CHECK(covers_centre({{{4.5, 2}, {4.5, 7}, {9, 4}}}, 4, 4));      // left, upright
  CHECK(covers_centre({{{3.5, 2.5}, {5.5, 6.5}, {9, 3}}}, 4, 4));  // left, leaning
  CHECK(covers_centre({{{5.5, 2.5}, {3.5, 6.5}, {9, 7}}}, 4, 4));  // left, leaning the other way
  CHECK(!covers_centre({{{4.5, 2}, {4.5, 7}, {1, 4}}}, 4, 4));     // right, upright
  CHECK(!covers_centre({{{3.5, 2.5}, {5.5, 6.5}, {1, 7}}}, 4, 4)); // right, leaning
  CHECK(covers_centre({{{2, 4.5}, {7, 4.5}, {4, 9}}}, 4, 4));      // top, level
  CHECK(!covers_centre({{{2, 4.5}, {7, 4.5}, {4, 1}}}, 4, 4));     // bottom, level
  // On a corner: inside where both edges there are top or left ones.
  CHECK(covers_centre({{{4.5, 4.5}, {9, 4.5}, {4.5, 9}}}, 4, 4));  // top left corner
  CHECK(!covers_centre({{{4.5, 4.5}, {1, 4.5}, {4.5, 9}}}, 4, 4)); // top right: a right edge
  CHECK(!covers_centre({{{4.5, 4.5}, {9, 4.5}, {4.5, 1}}}, 4, 4)); // bottom left: a bottom edge
  CHECK(!covers_centre({{{4.5, 4.5}, {1, 4.5}, {4.5, 1}}}, 4, 4)); // bottom right
  CHECK(!covers_centre({{{4.5, 4.5}, {2, 9}, {7, 9}}}, 4, 4));     // top apex: its right edge
  CHECK(!covers_centre({{{4.5, 4.5}, {2, 1}, {7, 1}}}, 4, 4));     // bottom apex
  CHECK(covers_centre({{{4.5, 4.5}, {9, 2}, {9, 7}}}, 4, 4));      // left apex: both edges are left ones
  CHECK(!covers_centre({{{4.5, 4.5}, {1, 2}, {1, 7}}}, 4, 4));     // right apex
  // A square between centres owns those on its left and top sides.
  WindowScene window(16);
  window.add({window.place(2.5, 3.5, 1), window.place(8.5, 3.5, 1), window.place(2.5, 9.5, 1),
              window.place(8.5, 9.5, 1), window.place(8.5, 3.5, 1), window.place(2.5, 9.5, 1)});
  const Frame frame = window.frame({Aov::object});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) CHECK(is_drawn(frame, x, y) == (x >= 2 && x < 8 && y >= 3 && y < 9));
}

TEST_CASE(
    "C3: of a closed fan of 3 to 12 triangles around a centre, the one owns it that lies right and a little below") {
  for (int spokes = 3; spokes <= 12; ++spokes)
    for_all(40, [&](Random& random) {
      // Rim points on a square, in order around the hub, at distinct places.
      std::vector<int> place;
      while (static_cast<int>(place.size()) < spokes) {
        const int p = random.below(32);
        if (std::find(place.begin(), place.end(), p) == place.end()) place.push_back(p);
      }
      std::sort(place.begin(), place.end());
      for (int i = 0; i < spokes; ++i) { // the hub must lie inside: no gap of half the square or more
        const int gap =
            (place[static_cast<std::size_t>((i + 1) % spokes)] - place[static_cast<std::size_t>(i)] + 32) % 32;
        if (gap >= 16) return;
      }
      const auto rim = [](int p) {
        const int side = p / 8, along = (p % 8) * 256 - 1024;
        const int x[] = {along, 1024, -along, -1024}, y[] = {-1024, along, 1024, -along};
        return LatticePoint{8 * 256 + 128 + x[side], 8 * 256 + 128 + y[side]};
      };
      const LatticePoint hub{8 * 256 + 128, 8 * 256 + 128};
      int owners = 0;
      for (int i = 0; i < spokes; ++i) {
        const Corners c{hub, rim(place[static_cast<std::size_t>(i)]),
                        rim(place[static_cast<std::size_t>((i + 1) % spokes)])};
        const bool owns = covers(c, 8 * 256 + 128, 8 * 256 + 128);
        CHECK(owns == oracle_covers<Int128, 14>(c, hub));
        owners += owns;
      }
      CHECK(owners == 1);
    });
}

TEST_CASE("C4: the order of corners and the direction of a shared edge change no sample") {
  for_all(300, [](Random& random) {
    Corners c;
    for (LatticePoint& p : c) p = {random.below(24) * 128, random.below(24) * 128};
    const LatticePoint opposite{c[1].x + c[2].x - c[0].x, c[1].y + c[2].y - c[0].y};
    const auto first = on_lattice(c);
    for (int turn = 0; turn < 6; ++turn) {
      Corners turned = c;
      std::rotate(turned.begin(), turned.begin() + turn % 3, turned.end());
      if (turn >= 3) std::swap(turned[1], turned[2]);
      const auto t = on_lattice(turned);
      // The triangle on the other side of the edge 1-2, in the same turn.
      const auto neighbour = on_lattice(turn >= 3 ? Corners{c[2], c[1], opposite} : Corners{c[1], opposite, c[2]});
      REQUIRE(t.has_value() == first.has_value());
      if (!t) continue;
      for (int y = 128; y < 13 * 256; y += 256)
        for (int x = 128; x < 13 * 256; x += 256) {
          REQUIRE(t->covers(x, y) == first->covers(x, y));
          REQUIRE(!(t->covers(x, y) && neighbour->covers(x, y)));
          const bool on_edge =
              oracle_covers<Int128, 14>(c, {x, y}) != oracle_covers<Int128, 14>(Corners{c[1], opposite, c[2]}, {x, y});
          if (on_edge) REQUIRE((t->covers(x, y) || neighbour->covers(x, y)));
        }
    }
  });
}

TEST_CASE("C5: a mesh without gaps covers every sample once") {
  Random random(5);
  CHECK(not_once(jittered_grid(40, 30, 8, random), 320, 240, {128, 128}) == 0);
  CHECK(not_once(jittered_grid(400, 300, 1, random), 400, 300, {128, 128}) == 0);
  CHECK(not_once(jittered_grid(3, 3, 200, random), 600, 600, {128, 128}) == 0);
}

TEST_CASE("C6: snapping takes the nearest subpixel, and of two equally near ones the even") {
  // One pixel wide: x in subpixels is 128 (x / w) + 128. Half subpixels are exact, and so are the ties.
  for (int k = -1000; k <= 1000; ++k) {
    const double x_subpixel = k + 0.5;
    const auto snapped = [&](double x) { return window_vertex({x / 128 - 1, 1 - x / 128, 0, 1}, 1, 1); };
    const int even = k % 2 == 0 ? k : k + 1;
    const WindowVertex tie = snapped(x_subpixel);
    CHECK(tie.x == even);
    CHECK(tie.y == even);
    // A billionth of a pixel to either side.
    const double step = 256e-9;
    CHECK(snapped(x_subpixel + step).x == k + 1);
    CHECK(snapped(x_subpixel - step).x == k);
    CHECK(snapped(x_subpixel + step).y == k + 1);
    CHECK(snapped(x_subpixel - step).y == k);
  }
}

TEST_CASE("C7: a corner stands within half of 1/256 pixel of its place") {
  for_all(5000, [](Random& random) {
    const double w = random.log_uniform(1e-30, 1e30);
    const Double4 clip(random.uniform(-3, 3) * w, random.uniform(-3, 3) * w, 0, w);
    const WindowVertex v = window_vertex(clip, 640, 480);
    const Rational x = (Rational(clip.x) / Rational(w) + 1) * 320 * 256,
                   y = (1 - Rational(clip.y) / Rational(w)) * 240 * 256;
    // "from double": the place itself is computed with three roundings of numbers under 2^19.
    const Rational bound = Rational(1, 2) + Rational(3 * 0x1p-34);
    CHECK(abs(x - v.x) <= bound);
    CHECK(abs(y - v.y) <= bound);
  });
}

TEST_CASE("C8: every sample of a pixel is covered once, also on its border; equal colours resolve to that colour") {
  Random random(8);
  for (const int samples : {2, 4, 8, 16})
    for (const SamplePosition& place : sample_pattern(samples)) {
      CHECK(not_once(jittered_grid(20, 20, 4, random), 80, 80, place) == 0);
      CHECK(not_once(jittered_grid(90, 90, 1, random), 90, 90, place) == 0);
    }
  // #12 and #15 of 16 lie on the left and the top border of their pixel: an edge along it, seen from both sides.
  for (const auto& border : {std::tuple(12, 0, 128), std::tuple(15, 16, 0)}) {
    const int number = std::get<0>(border), x = std::get<1>(border), y = std::get<2>(border);
    const SamplePosition place = sample_pattern(16)[static_cast<std::size_t>(number)];
    CHECK(place.x == x);
    CHECK(place.y == y);
    const bool left = number == 12;
    const auto quad = [&](double x0, double y0, double x1, double y1) {
      return covers({pixels(x0, y0), pixels(x1, y0), pixels(x0, y1)}, 4 * 256 + x, 4 * 256 + y) +
             covers({pixels(x1, y1), pixels(x1, y0), pixels(x0, y1)}, 4 * 256 + x, 4 * 256 + y);
    };
    CHECK((left ? quad(4, 2, 8, 7) : quad(2, 4, 7, 8)) == 1); // begins at the border
    CHECK((left ? quad(1, 2, 4, 7) : quad(2, 1, 7, 4)) == 0); // ends at it
  }
  // Wholly inside and wholly outside, through the whole pipeline, on a colour that no sum of shares gives exactly.
  const Double3 colour(0.1, 1.0 / 3, 1e-3);
  for (const int samples : {2, 4, 8, 16}) {
    WindowScene window(16);
    window.add({window.place(2, 2, 1), window.place(14, 2, 1), window.place(2, 14, 1), window.place(14, 14, 1),
                window.place(14, 2, 1), window.place(2, 14, 1)},
               colour);
    const Frame frame = window.frame({}, samples);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const bool inside = x >= 2 && x < 14 && y >= 2 && y < 14;
        for (int c = 0; c < 3; ++c) CHECK(frame.radiance.at(x, y)[c] == (inside ? static_cast<float>(colour[c]) : 0));
      }
  }
}

TEST_CASE("C9: attributes are those at the pixel's centre, also where only other samples are covered") {
  // Centroid sampling is not offered. Of pixel (4, 4) only its right half is covered; the centre is not.
  WindowScene window(16);
  const std::vector<Float3> corner = {window.place(4.75, 2, 1), window.place(12, 2, 2), window.place(4.75, 12, 4)};
  window.add(corner, Double3(1), {{0, 0}, {1, 0}, {0, 1}});
  const Frame frame = window.frame({Aov::object, Aov::uv, Aov::position}, 4);
  REQUIRE(is_drawn(frame, 4, 4));
  const auto at = window.exact_triangle(corner[0], corner[1], corner[2]).at(4 * 256 + 128, 4 * 256 + 128);
  REQUIRE(at);
  CHECK(at->how == Meets::outside);
  CHECK(at->weight[1] < 0); // extrapolated
  for (std::size_t c = 0; c < 2; ++c) {
    const Mpfr expected = exact(at->weight[c + 1]);
    CHECK(abs(Mpfr(frame.aovs[1].at(4, 4)[c]) - expected) <= half_float_ulp(expected) + interpolation_bound(Mpfr(2)));
  }
}

TEST_CASE("C10: derivatives are the plane's own: no neighbour is asked, and none is written") {
  // A texture whose level k is of colour k: what is seen is the level of detail itself, over 16.
  auto texture = std::make_shared<Texture>();
  texture->full_scale = 16;
  for (int k = 0; k <= 8; ++k) {
    const int size = 256 >> k;
    texture->levels.push_back(
        {size, size, PaddedVector<float>(static_cast<std::size_t>(3 * size * size), static_cast<float>(k))});
  }
  const auto seen = [&](const std::vector<Float3>& corners, const std::optional<PixelRect>& crop) {
    WindowScene window(16, 0.25, 64);
    std::vector<Float2> uvs;
    for (const Float3& p : corners) uvs.emplace_back(p.x, p.z);
    Object& object = window.add(corners, Double3(1), uvs);
    object.material.diffuse_map.texture = texture;
    object.material.diffuse_map.filter = TextureFilter::trilinear;
    RenderOptions options = window.options({Aov::object});
    options.crop = crop;
    return render(window.scene, options);
  };
  // The plane y = -1, which row y shows at w = 8 / (y - 8); as one triangle, and as one that covers a single centre.
  const WindowScene window(16, 0.25, 64);
  const auto on_plane = [&](double x, double y) { return window.place(x, y, 8 / (y - 8)); };
  const Frame whole = seen({on_plane(-8, 16), on_plane(24, 16), on_plane(8, 8.5)}, {});
  for (const auto& pixel : {std::pair(8, 15), std::pair(7, 11), std::pair(0, 15), std::pair(15, 15)}) {
    const int px = pixel.first, py = pixel.second;
    CAPTURE(px);
    CAPTURE(py);
    REQUIRE(is_drawn(whole, px, py));
    // u = x_world = (px - 8) / (py - 8), v = -8 / (py - 8): per pixel right, du = 1 / h and dv = 0; down, du =
    // -(px - 8) / h^2 and dv = 8 / h^2, with h = py - 8 at the centre. LOD = log2 of the longer, in 256 texels.
    const Mpfr h = Mpfr(py) + 0.5 - 8, x = Mpfr(px) + 0.5 - 8;
    const Mpfr right = 1 / h, down = sqrt(x * x + 64) / (h * h);
    const Mpfr lod = log(256 * std::max(right, down)) / log(Mpfr(2));
    const Mpfr clamped = std::min(Mpfr(8), std::max(Mpfr(0), lod));
    // Derivatives to some tens of 2^-53, log2 to an ulp; between levels k and k + 1 the share is exact to 2^-50.
    const Mpfr bound = Mpfr(0x1p-44) + half_float_ulp(clamped / 16);
    CHECK(abs(Mpfr(whole.radiance.at(px, py)[0]) - clamped / 16) <= bound);
    const Frame crop = seen({on_plane(-8, 16), on_plane(24, 16), on_plane(8, 8.5)}, PixelRect{px, py, 1, 1});
    CHECK(crop.radiance.values[0] == whole.radiance.at(px, py)[0]);

    const Frame alone =
        seen({on_plane(px + 0.25, py + 0.25), on_plane(px + 0.75, py + 0.25), on_plane(px + 0.5, py + 0.75)}, {});
    CHECK(alone.counts.fragments == 1);
    CHECK(drawn_pixels(alone) == 1);
    // Its corners are floats and are snapped: each moves its uv by up to half a subpixel's worth over half a pixel.
    CHECK(std::abs(alone.radiance.at(px, py)[0] - whole.radiance.at(px, py)[0]) <= std::log2(1 + 8.0 / 256) / 16);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("C5: more than five million samples of meshes without gaps, each covered once") {
    Random random(55);
    long samples = 0;
    for (const int step : {1, 2, 5, 17, 64, 250}) {
      const int columns = 1000 / step, rows = 1000 / step;
      CHECK(not_once(jittered_grid(columns, rows, step, random), columns * step, rows * step, {128, 128}) == 0);
      samples += long{columns} * step * rows * step;
    }
    MESSAGE("samples, each covered once: " << samples);
    CHECK(samples > 5'000'000);
  }
}
