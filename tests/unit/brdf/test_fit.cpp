// Fits of tables whose parameters are known.

#include "brdf/fit/fit.h"
#include "brdf/fit/levenberg_marquardt.h"
#include "tests/support/shading/brdf_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace refraster;
using namespace refraster::test;

namespace {

BrdfFit fit(const Brdf& brdf, std::string_view model, int lobes = 1) {
  const FittedModel* const listed = find_fitted_model(model);
  REQUIRE(listed != nullptr);
  std::optional<BrdfFit> found = fit_brdf(brdf, *listed, lobes);
  REQUIRE(found);
  return *found;
}

/// A table of f with noise of 1 %, normally distributed, on every value.
Brdf noisy_table(const BrdfModel& model) {
  std::mt19937_64 bits(7);
  return table_brdf_from([&](const Double3&, const Double3& i, const Double3& o) {
    Rgb<double> f = model_value(model, {i, o});
    for (int c = 0; c < 3; ++c) {
      double sum = -6; // of twelve uniform numbers: variance 1, the same from every library
      for (int k = 0; k < 12; ++k) sum += static_cast<double>(bits() >> 11) * 0x1p-53;
      f[c] = std::max(f[c] * (1 + 0.01 * sum), 0.0);
    }
    return f;
  });
}

Brdf exact_table(const BrdfModel& model) {
  return table_brdf_from([&](const Double3&, const Double3& i, const Double3& o) {
    return model_value(model, {i, o});
  });
}

/// The farthest that a parameter is from what it was, as a part of that.
double worst_parameter(const BrdfFit& found, const BrdfModel& truth) {
  const std::vector<FitParameter> there = fit_parameters({truth}), here = fit_parameters(found.lobes);
  REQUIRE(there.size() == here.size());
  double worst = 0;
  for (std::size_t k = 0; k < there.size(); ++k) {
    const double off = std::abs(here[k].value / there[k].value - 1);
    INFO(there[k].name << " " << there[k].value << " found as " << here[k].value);
    CHECK(off < 0.05);
    worst = std::max(worst, off);
  }
  return worst;
}

/// What is not fitted is compared as well. Of metal alone, the index of what is not metal is not seen.
double worst_parameter(const BrdfFit& found, const Microfacet& truth) {
  REQUIRE(found.lobes.size() == 1);
  const auto& here = std::get<Microfacet>(found.lobes.front());
  CAPTURE(model_text(found.lobes));
  double worst = std::max(std::abs(here.metallic - truth.metallic), std::abs(here.roughness / truth.roughness - 1));
  if (truth.metallic < 1) worst = std::max(worst, std::abs(here.ior / truth.ior - 1));
  for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(here.base_color[c] / truth.base_color[c] - 1));
  CHECK(worst < 0.05);
  return worst;
}

constexpr double roughnesses[] = {0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9};

Microfacet microfacet(double roughness, double metallic, double ior = 1.5) {
  Microfacet block;
  block.base_color = {0.8, 0.5, 0.2}, block.metallic = metallic, block.roughness = roughness, block.ior = ior;
  return block;
}

/// Blinn-Phong's exponent for a highlight as wide as that of GGX: Walter et al. 2007, section 5.2, 2 / alpha^2 - 2.
BlinnPhong blinn_phong(double alpha) {
  BlinnPhong block;
  block.ka = Double3(0), block.kd = {0.1, 0.15, 0.05}, block.ks = {0.3, 0.2, 0.25};
  block.glossiness = 2 / (alpha * alpha) - 2;
  return block;
}

/// The angle to the mirror direction is twice that to the half vector.
Phong phong_as_wide(const BlinnPhong& blinn) {
  Phong phong;
  static_cast<PhongParameters&>(phong) = blinn;
  phong.glossiness /= 4;
  return phong;
}

/// Tables of this roughness, without noise.
void check_exact(double roughness) {
  CAPTURE(roughness);
  const GgxConductor metal{roughness * roughness, {0.9, 0.7, 0.4}}; // as glTF has it: alpha from 4e-4 to 0.81
  CHECK(worst_parameter(fit(exact_table(metal), "ggx-conductor"), metal) < 0.01);
  for (const Microfacet& block :
       {microfacet(roughness, 0), microfacet(roughness, 0.5), microfacet(roughness, 1), microfacet(roughness, 0, 1.33)})
    CHECK(worst_parameter(fit(exact_table(block), "microfacet"), block) < 0.01);
  const GgxDielectric plastic{roughness * roughness, 1.5, {0.6, 0.3, 0.1}};
  CHECK(worst_parameter(fit(exact_table(plastic), "ggx-dielectric"), plastic) < 0.01);
  const BlinnPhong blinn = blinn_phong(roughness);
  CHECK(worst_parameter(fit(exact_table(blinn), "blinn_phong"), blinn) < 0.01);
  const Phong phong = phong_as_wide(blinn);
  CHECK(worst_parameter(fit(exact_table(phong), "phong"), phong) < 0.01);
}

void check_noisy(double roughness) {
  CAPTURE(roughness);
  const GgxConductor metal{roughness * roughness, {0.9, 0.7, 0.4}};
  CHECK(worst_parameter(fit(noisy_table(metal), "ggx-conductor"), metal) < 0.05);
  const GgxDielectric plastic{roughness * roughness, 1.5, {0.6, 0.3, 0.1}};
  CHECK(worst_parameter(fit(noisy_table(plastic), "ggx-dielectric"), plastic) < 0.05);
  const BlinnPhong blinn = blinn_phong(roughness);
  CHECK(worst_parameter(fit(noisy_table(blinn), "blinn_phong"), blinn) < 0.05);
  for (const double metallic : {0.0, 0.5, 1.0}) {
    CAPTURE(metallic);
    const Microfacet block = microfacet(roughness, metallic);
    CHECK(worst_parameter(fit(noisy_table(block), "microfacet"), block) < 0.05);
  }
  const Phong phong = phong_as_wide(blinn);
  CHECK(worst_parameter(fit(noisy_table(phong), "phong"), phong) < 0.05);
}

} // namespace

TEST_CASE("a least-squares problem with a known answer: Rosenbrock's") {
  const Minimum found = levenberg_marquardt(
      [](std::span<const double> x, std::span<double> r) {
        r[0] = 10 * (x[1] - x[0] * x[0]);
        r[1] = 1 - x[0];
      },
      2, {-1.2, 1}, 500);
  CHECK(found.converged);
  CHECK(found.x[0] == doctest::Approx(1).epsilon(1e-6));
  CHECK(found.x[1] == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("parameters keep their values with and without bounds") {
  for (const FittedModel& model : fitted_models)
    for (const FitStart& start_of : model.starts) {
      const std::vector<BrdfModel> start = start_of({{0.1, 0.2, 0.3}, {5, 6, 7}, 0.1, 0.9}, 2, 1);
      REQUIRE(start.size() == 2);
      const std::vector<FitParameter> parameters = fit_parameters(start);
      const std::vector<FitParameter> back = fit_parameters(with_unbounded(start, unbounded(parameters)));
      REQUIRE(back.size() == parameters.size());
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        INFO(model.name << " " << parameters[k].name);
        CHECK(back[k].name == parameters[k].name);
        CHECK(back[k].value == doctest::Approx(parameters[k].value).epsilon(1e-5));
        CHECK(parameters[k].range.contains(back[k].value));
      }
    }
}

TEST_CASE("of a Microfacet the index is fitted or the metal, as the start has none of it or some") {
  const auto has = [](const Microfacet& block, std::string_view name) {
    return std::ranges::any_of(fit_parameters({block}), [&](const FitParameter& p) { return p.name == name; });
  };
  Microfacet ground, metal;
  ground.metallic = 0, metal.metallic = 0.5;
  CHECK(has(ground, "ior"));
  CHECK_FALSE(has(ground, "metallic"));
  CHECK(has(metal, "metallic"));
  CHECK_FALSE(has(metal, "ior"));
  CHECK_FALSE(has(metal, "eta.r")); // by Schlick's law nothing depends on it
  metal.fresnel = MicrofacetFresnel::conductor;
  CHECK(has(metal, "eta.r"));
  // All metal is no end that a fit wants more than.
  for (const FitParameter& p : fit_parameters({Microfacet{}})) CHECK(p.is_at_end() == (p.name != "metallic"));
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("the start knows the height and width of a highlight") {
  const std::optional<HighlightShape> shape =
      highlight_shape({"", {Lambert{Double3(0.5)}, GgxConductor{0.1, Double3(0.5)}}});
  REQUIRE(shape);
  // D has fallen to a half at sin^2 = (sqrt(2) - 1) alpha^2, about: 0.0643 radians; other factors vary by per cents.
  CHECK(shape->half_width == doctest::Approx(0.0643).epsilon(0.05));
  CHECK(shape->diffuse.x == doctest::Approx(0.5 / std::numbers::pi).epsilon(0.1));
}

TEST_CASE("known parameters of synthesised tables are recovered to 1 %") {
  for (const double roughness : {0.02, 0.9}) check_exact(roughness); // the ends; those between, in "long"
}

TEST_CASE("with 1 % of noise they are recovered to 5 %") {
  check_noisy(0.2);
}

TEST_CASE("the same fit every time, and a poor one says so") {
  const Brdf brass = exact_table(GgxConductor{0.1, {0.91, 0.78, 0.42}});
  const BrdfFit once = fit(brass, "blinn_phong"), twice = fit(brass, "blinn_phong");
  CHECK(model_text(once.lobes) == model_text(twice.lobes));
  CHECK(once.log_rms == twice.log_rms);
  CHECK(fit(brass, "ggx-conductor").doubts.empty());
  // A conductor has no diffuse part: a white wall is not one.
  const BrdfFit wall = fit({"wall", {Lambert{Double3(0.8)}}}, "ggx-conductor");
  REQUIRE_FALSE(wall.doubts.empty());
  CHECK(fit_text(brass, wall).find("\npoor") != std::string::npos);
  CHECK(fit_json(brass, wall).find("\"poor\": true") != std::string::npos);
}

TEST_CASE("two lobes come nearer than one to a surface that has two") {
  const Brdf coated("coated", {GgxConductor{0.03, Double3(0.05)}, GgxConductor{0.3, {0.6, 0.3, 0.2}}});
  const double one = fit(coated, "ggx-conductor").log_rms, two = fit(coated, "ggx-conductor", 2).log_rms;
  CHECK(two < one / 10);
}

TEST_CASE("what is written for a scene is a fragment function, or a table") {
  const BrdfFit blinn{.model = "blinn_phong", .lobes = {blinn_phong(0.125)}};
  CHECK(is_fragment_function(blinn));
  CHECK(material_json(blinn, "t.binary").find("\"fragment_function\": \"blinn_phong\"") != std::string::npos);
  CHECK(material_json(blinn, "t.binary").find("\"glossiness\": 126") != std::string::npos);
  const BrdfFit steel{.model = "microfacet", .lobes = {microfacet(0.5, 1)}};
  CHECK(material_json(steel, "t.binary").find("\"roughness\": 0.5") != std::string::npos);
  CHECK(material_json(steel, "t.binary").find("\"eta\"") == std::string::npos);
  const BrdfFit metal{.model = "ggx-conductor", .lobes = {GgxConductor{}}};
  CHECK_FALSE(is_fragment_function(metal));
  CHECK(material_json(metal, "t.binary").find("\"brdf_file_path\": \"t.binary\"") != std::string::npos);
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("long");

TEST_CASE("so they are over the whole range of roughness") {
  for (const double roughness : roughnesses) check_exact(roughness), check_noisy(roughness);
}

TEST_CASE("no start of an exhaustive search comes nearer than the closed forms, on tables like measured ones") {
  // Like measured: a sharp and a broad lobe over a coloured ground, none of which a single lobe can be, and noise.
  const Brdf measured_like[] = {
      {"coated", {GgxConductor{0.05, Double3(0.1)}, GgxDielectric{0.35, 1.5, {0.4, 0.2, 0.1}}}},
      {"brushed", {GgxConductor{0.12, {0.5, 0.45, 0.3}}, GgxConductor{0.4, {0.3, 0.25, 0.2}}}},
      {"waxed", {GgxDielectric{0.15, 1.4, {0.1, 0.05, 0.02}}, GgxConductor{0.5, Double3(0.05)}}}};
  for (const Brdf& brdf : measured_like)
    for (const FittedModel& model : fitted_models) {
      INFO(brdf.label() << " " << model.name);
      const double ours = fit(brdf, model.name).log_rms;
      double best = ours;
      for (const double half_width : {0.005, 0.02, 0.08, 0.32})
        for (const double height : {0.3, 3.0})
          for (const double diffuse : {0.01, 0.1}) {
            const HighlightShape shape{Rgb<double>(diffuse), Rgb<double>(height), half_width, 0.92};
            for (const FitStart& start : model.starts)
              best = std::min(best, fit_brdf_from(brdf, std::string(model.name), start(shape, 1, 1))->log_rms);
          }
      // Where the sum changes by less than 1.5e-8 of itself the search is at rest, some such steps from the minimum.
      CHECK(ours <= best * (1 + 1e-5));
    }
}

TEST_SUITE_END();
