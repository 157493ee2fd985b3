// How far two reflectances are apart, where that is known.

#include "brdf/comparison.h"
#include "brdf/grid.h"
#include "tests/support/shading/brdf_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace refraster;
using namespace refraster::test;

TEST_CASE("the bins of a table stand for all pairs of directions above the surface") {
  const BinWeights weights;
  double sum = 0;
  for (int h = 0; h < 90; ++h)
    for (int d = 0; d < 90; ++d)
      for (int p = 0; p < 180; ++p) {
        const DirectionPair pair = directions_at_centre(h, d, p);
        if (pair.i.z > 0 && pair.o.z > 0) sum += weights(h, d);
      }
  // Two hemispheres: (2 pi)^2. Bins that the horizon cuts count whole or not at all.
  CHECK(sum == doctest::Approx(4 * std::numbers::pi * std::numbers::pi).epsilon(3e-4));
}

TEST_SUITE_BEGIN("slow"); // a million pairs each

TEST_CASE("the errors between two Lambert surfaces are worked out by hand") {
  const Brdf a("a", {Lambert{Double3(0.5)}}), b("b", {Lambert{Double3(0.8)}});
  const BrdfComparison found = compare_brdfs(a, b);
  const double difference = 0.3 / std::numbers::pi;
  for (const RegionWords& words : brdf_regions) {
    CAPTURE(words.name);
    const BrdfErrors& errors = found.of(words.region);
    CHECK(errors.rms == doctest::Approx(difference).epsilon(1e-12));
    CHECK(errors.relative_rms == doctest::Approx(0.6).epsilon(1e-12));
    CHECK(errors.fraction > 0);
  }
  const BrdfErrors& all = found.of(BrdfRegion::all);
  // The mean of cos^2 over the hemisphere is 1/3, that of cos 1/2; bins at the horizon count whole or not at all.
  CHECK(all.cosine_rms == doctest::Approx(difference / std::sqrt(3)).epsilon(2e-4));
  CHECK(all.mean_difference == doctest::Approx(difference / 2).epsilon(2e-4));
  // (c a)^(1/3): the mean of c^(2/3) is 3/5.
  const double roots = std::cbrt(0.8 / std::numbers::pi) - std::cbrt(0.5 / std::numbers::pi);
  CHECK(all.cube_root_rms == doctest::Approx(roots * std::sqrt(0.6)).epsilon(2e-4));
  // Where the cosine is greatest: both along the normal.
  REQUIRE_FALSE(found.worst.empty());
  CHECK(found.worst[0].in_out.theta_in < 1);
  CHECK(found.worst[0].log_error ==
        doctest::Approx(std::log1p(0.8 / std::numbers::pi) - std::log1p(0.5 / std::numbers::pi)).epsilon(1e-3));
  CHECK(std::ranges::is_sorted(found.worst, std::greater<>(), &WorstPair::log_error));
}

TEST_CASE("highlight, retro, grazing and rest are where their names say, and are all pairs") {
  const Brdf black("black", {Lambert{Double3(0)}}), white("white", {Lambert{Double3(1)}});
  const BrdfComparison found = compare_brdfs(black, white);
  // The half vector within t of the normal: 1 - cos t of the hemisphere's half vectors, weighted by 4 cos theta_d:
  // for t = 10 degrees nearly all of their pairs lie above the surface.
  const BrdfErrors& highlight = found.of(BrdfRegion::highlight);
  CHECK(highlight.fraction == doctest::Approx(2 * (1 - std::cos(std::numbers::pi / 18))).epsilon(0.1));
  // A light at random is beyond 75 degrees with probability cos 75, and so is the eye.
  const double c = std::cos(75 * std::numbers::pi / 180);
  CHECK(found.of(BrdfRegion::grazing).fraction == doctest::Approx(1 - (1 - c) * (1 - c)).epsilon(0.02));
  // The eye within 20 degrees of the light: 1 - cos 20 of the hemisphere, less what the horizon cuts off.
  CHECK(found.of(BrdfRegion::retro).fraction == doctest::Approx(1 - std::cos(std::numbers::pi / 9)).epsilon(0.12));
  CHECK(found.of(BrdfRegion::all).fraction == 1);
  CHECK(found.of(BrdfRegion::all).pairs <= highlight.pairs + found.of(BrdfRegion::retro).pairs +
                                               found.of(BrdfRegion::grazing).pairs + found.of(BrdfRegion::rest).pairs);
}

TEST_CASE("a table is its formula at the centres of its bins, and what it does not know is counted") {
  const GgxDielectric formula{0.2, 1.5, {0.6, 0.3, 0.1}};
  const Brdf table = table_brdf_from(formula), model("model", {formula});
  const BrdfComparison found = compare_brdfs(table, model);
  CHECK(found.unknown == 0);
  // Reading at a centre interpolates with weights that are 0 but for rounding. A table raises directions that are
  // within 2^-10 of the horizon: the two differ there, where f is steep.
  CHECK(found.of(BrdfRegion::rest).relative_rms < 1e-9);
  const double log_rms = found.of(BrdfRegion::all).log_rms;
  CHECK(is_within({.max_rms = 1, .max_cosine_rms = {}, .max_log_rms = log_rms, .max_cube_root_rms = {}}, found));
  CHECK_FALSE(
      is_within({.max_rms = 1, .max_cosine_rms = {}, .max_log_rms = log_rms / 2, .max_cube_root_rms = {}}, found));
  const BrdfComparison same = compare_brdfs(model, model);
  CHECK(same.equal);
  CHECK(is_within({}, same));
  CHECK(same.of(BrdfRegion::all).rms == 0);
  CHECK(same.worst.empty());

  PaddedVector<double> rgb(3 * MerlTable::samples, 0.25);
  for (int k = 0; k < 3; ++k) rgb[static_cast<std::size_t>(MerlTable::offset(45, 10, 90) + k)] = -1;
  const Brdf gap = table_brdf(std::make_shared<const MerlTable>(std::move(rgb)));
  CHECK(compare_brdfs(gap, model).unknown <= 1); // neighbours may fill it: a centre is known to some roundings
}

TEST_CASE("reports have every region, and the numbers") {
  const Brdf a("lambert", {Lambert{Double3(0.5)}}), b("phong", {Phong{}});
  const BrdfComparisonReport report{a, b, {}, compare_brdfs(a, b)};
  const std::string text = comparison_text(report), json = comparison_json(report);
  for (const RegionWords& words : brdf_regions) {
    CHECK(text.find("\n" + std::string(words.name)) != std::string::npos);
    CHECK(json.find("\"" + std::string(words.name) + "\": {") != std::string::npos);
  }
  CHECK(text.starts_with("a  lambert\nb  phong\n"));
  CHECK(json.find("\"same\": false") != std::string::npos);
}

TEST_SUITE_END();
