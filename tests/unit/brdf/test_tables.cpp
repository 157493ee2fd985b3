// Tables that are made from models, beside those models.

#include "brdf/angles.h"
#include "tests/support/shading/brdf_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace refraster;
using namespace refraster::test;

namespace {

/// The two bins whose centres a coordinate in bins lies between; the same one twice beyond the first or last centre.
struct Around {
  int below, above;
};
Around centres_around(double x, int bins) {
  const int below = static_cast<int>(std::floor(x - 0.5));
  return {std::clamp(below, 0, bins - 1), std::clamp(below + 1, 0, bins - 1)};
}

struct Extent {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
};

/// Of the model's own red at the eight centres around a point.
Extent at_centres_around(const BrdfModel& model, double u, double v, double w) {
  const Around hs = centres_around(u, MerlTable::theta_h_bins), ds = centres_around(v, MerlTable::theta_d_bins);
  const int p_below = static_cast<int>(std::floor(w - 0.5)), half_turn = MerlTable::phi_d_bins;
  Extent extent;
  for (const int h : {hs.below, hs.above})
    for (const int d : {ds.below, ds.above})
      for (const int p : {(p_below + half_turn) % half_turn, (p_below + 1) % half_turn}) {
        const double f = model_value(model, directions_at_centre(h, d, p)).x;
        extent = {std::min(extent.least, f), std::max(extent.greatest, f)};
      }
  return extent;
}

} // namespace

TEST_SUITE_BEGIN("slow");

TEST_CASE("a table of a model errs by interpolation and by nothing else") {
  for_each_model([](const auto& defaults) {
    const BrdfModel model(defaults);
    CAPTURE(model_text(model));
    const Brdf table = table_brdf_from([&](const Double3&, const Double3& i, const Double3& o) {
      return model_value(model, {i, o});
    });
    std::mt19937_64 bits(3);
    const auto uniform = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    int compared = 0, interpolated = 0;
    for (int k = 0; k < 20000; ++k) {
      const double u = 90 * uniform(), v = 90 * uniform(), w = 180 * uniform();
      const DirectionPair at = directions_of(HalfDifferenceAngles{90 * (u / 90) * (u / 90), v, w});
      // So far above the horizon that all centres around are above it: they are 2 degrees apart at most, 3 together.
      constexpr double sine_of_6_degrees = 0.105;
      if (std::min(at.i.z, at.o.z) < sine_of_6_degrees) continue;
      const BrdfValue read = table.value(at);
      REQUIRE(read.measured);
      const Extent around = at_centres_around(model, u, v, w);
      // A mean of eight, with weights of three products each: some twenty roundings.
      constexpr double rounding = 32 * 0x1p-53;
      REQUIRE(read.f.x >= around.least * (1 - rounding));
      REQUIRE(read.f.x <= around.greatest * (1 + rounding));
      ++compared;
      interpolated += read.f.x != model_value(model, at).x;
    }
    CHECK(compared > 5000);
    if (model_name(model) != Lambert::name) CHECK(interpolated > compared / 2);
    // At the centres themselves it has no error, but for finding the place.
    for (const int h : {0, 7, 40})
      for (const int d : {0, 20, 50})
        for (const int p : {0, 60, 179}) {
          const DirectionPair centre = directions_at_centre(h, d, p);
          if (std::min(centre.i.z, centre.o.z) <= 0) continue;
          const double f = model_value(model, centre).x;
          REQUIRE(table.value(centre).f.x == doctest::Approx(f).epsilon(1e-10));
        }
  });
}

TEST_SUITE_END();
