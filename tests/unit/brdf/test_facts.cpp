// Facts of tables and models whose facts are known.

#include "brdf/facts.h"
#include "tests/support/shading/brdf_tables.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace refraster;
using namespace refraster::test;

TEST_SUITE_BEGIN("slow"); // a table is 1.5 million samples

TEST_CASE("a Lambert table reflects its albedo, from every direction") {
  const Brdf table = table_brdf_from(Lambert{{0.2, 0.5, 0.8}});
  for (const double degrees : albedo_degrees) {
    const Rgb<double> albedo = directional_albedo(table, degrees);
    // The bound that directional_albedo promises.
    CHECK(albedo.x == doctest::Approx(0.2).epsilon(1e-3));
    CHECK(albedo.y == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(albedo.z == doctest::Approx(0.8).epsilon(1e-3));
  }
}

TEST_CASE("a narrow highlight is not missed: a smooth perfect metal reflects nearly all") {
  // The lobe falls to a quarter at theta_h = alpha = 0.05, which is bin u = 90 sqrt(0.05 / (pi/2)) = 16. Linear
  // interpolation is off by at most f'' / 8 = 1/16^2 = 0.4 % of a peak so many bins wide; the light that one bounce
  // loses to masking is below 0.5 % at these angles.
  const Brdf table = table_brdf_from(GgxConductor{0.05, Double3(1)});
  CHECK(directional_albedo(table, 0).x == doctest::Approx(1).epsilon(0.009));
  CHECK(directional_albedo(table, 30).x == doctest::Approx(1).epsilon(0.009));
}

TEST_CASE("samples that were never measured are counted, and kept out of the means") {
  PaddedVector<double> rgb(3 * MerlTable::samples, 0.25);
  rgb[3] = rgb[4] = rgb[5] = -1;
  rgb[6] = 4;
  const BrdfFacts facts = brdf_facts(table_brdf(std::make_shared<const MerlTable>(std::move(rgb))));
  CHECK(facts.never_measured == 1);
  CHECK(facts.channels[0].min == 0.25);
  CHECK(facts.channels[0].max == 4);
  CHECK(facts.channels[0].mean == doctest::Approx(0.25 + 3.75 / (MerlTable::samples - 1)).epsilon(1e-12));
  CHECK(facts.channels[1].max == 0.25);
}

TEST_CASE("a table is reciprocal to the last bit, since it cannot say otherwise") {
  // i and o swapped have the same theta_h and theta_d, and phi_d turned by half a turn: the same place in the table.
  const BrdfFacts facts = brdf_facts(table_brdf_from(GgxDielectric{}));
  CHECK(facts.reciprocity_pairs == 100'000);
  CHECK(facts.reciprocity_error == 0);
}

TEST_CASE("a model has the facts that its formula has") {
  const BrdfFacts lambert = brdf_facts({"lambert", {Lambert{{0.2, 0.5, 0.8}}}});
  CHECK(lambert.channels[1].min == doctest::Approx(0.5 / std::numbers::pi).epsilon(1e-15));
  CHECK(lambert.channels[1].max == lambert.channels[1].min);
  CHECK(lambert.albedos[2].albedo.z == doctest::Approx(0.8).epsilon(1e-3));
  CHECK(lambert.never_measured == 0);
  CHECK(impossibilities(lambert).empty());
}

TEST_CASE("what no surface does is said: the lecture's Blinn-Phong is neither reciprocal nor bounded by what arrives") {
  BlinnPhong blinn; // kd = ks = 1
  const std::vector<std::string> said = impossibilities(brdf_facts({"blinn_phong", {blinn}}));
  REQUIRE(said.size() == 2);
  CHECK(said[0].starts_with("reflects more light than arrives: albedo "));
  CHECK(said[1].starts_with("is not reciprocal: "));
  blinn.ks = Double3(0), blinn.kd = Double3(1 / std::numbers::pi); // Lambert's law with albedo 1
  CHECK(impossibilities(brdf_facts({"blinn_phong", {blinn}})).empty());
}

TEST_SUITE_END();
