// Models by name: what is read, what is refused, what they reflect.

#include "brdf/brdf.h"
#include "brdf/model.h"
#include "math/elementary/degrees.h"

#include <doctest/doctest.h>

#include <numbers>
#include <random>

using namespace refraster;

namespace {

BrdfModel one(std::string_view text) {
  const ReadModels read = read_models(text);
  REQUIRE(read.faults.empty());
  REQUIRE(read.lobes.size() == 1);
  return read.lobes[0];
}

std::string fault_of(std::string_view text) {
  const ReadModels read = read_models(text);
  REQUIRE(read.faults.size() == 1);
  const ModelFault& fault = read.faults[0];
  return fault.place + ": " + fault.found + ", " + fault.expected;
}

/// The pair with these polar angles on opposite sides, in degrees.
DirectionPair opposite(double theta_in, double theta_out) {
  return directions_of(InOutAngles{theta_in, theta_out, 180});
}

} // namespace

TEST_CASE("a model is read by name, with its parameters, however they are written") {
  const auto blinn = std::get<BlinnPhong>(one("blinn_phong:ks=.5,glossiness=32"));
  CHECK(blinn.ks == Double3(0.5));
  CHECK(blinn.glossiness == 32);
  CHECK(blinn.kd == BlinnPhong{}.kd);
  CHECK(std::get<BlinnPhong>(one("blinn-phong:kd=.1,.2,.3,ks=1e+0,specular_gate=true")).kd == Double3(0.1, 0.2, 0.3));
  CHECK(std::get<Lambert>(one("diffuse:albedo=1")).albedo == Double3(1));
  CHECK(std::get<GgxConductor>(one("ggx_conductor:f0=.9,.8,.7,alpha=0.25")).f0 == Double3(0.9, 0.8, 0.7));
  CHECK(std::get<GgxConductor>(one("brass-like")).alpha == 0.1);
  CHECK(std::get<GgxConductor>(one("brass_like:alpha=.2")).f0.z == 0.42);
}

TEST_CASE("several models add up") {
  const ReadModels read = read_models("lambert:albedo=.5+ggx-conductor:f0=1e-2,alpha=.3+lambert");
  CHECK(read.faults.empty());
  REQUIRE(read.lobes.size() == 3);
  const DirectionPair at = opposite(30, 45);
  Rgb<double> sum(0);
  for (const BrdfModel& lobe : read.lobes) sum += model_value(lobe, at);
  CHECK(Brdf("sum", read.lobes).value(at).f == sum);
  CHECK(sum.x > 1 / std::numbers::pi);
}

TEST_CASE("what is wrong with a model is one line: where, what was found, what is expected") {
  CHECK(fault_of("blin_phong").starts_with(": \"blin_phong\", one of lambert, phong, blinn_phong, "));
  CHECK(fault_of("blin_phong").ends_with("; did you mean blinn_phong?"));
  CHECK(fault_of("phong:gloss=3") ==
        "phong: \"gloss\", one of ka, kd, ks, glossiness, specular_gate; did you mean glossiness?");
  CHECK(fault_of("phong:glossiness=-3") == "phong:glossiness: \"-3\", a number >= 0");
  CHECK(fault_of("phong:glossiness=") == "phong:glossiness: \"\", a number >= 0");
  CHECK(fault_of("phong:glossiness=nan") == "phong:glossiness: \"nan\", a number >= 0");
  CHECK(fault_of("phong:8") == "phong: \"8\", KEY=VALUE");
  CHECK(fault_of("phong:kd=1,2") == "phong:kd: \"1,2\", a number >= 0, or three, with commas between them");
  CHECK(fault_of("phong:kd=1,2,3,4").starts_with("phong:kd: \"1,2,3,4\""));
  CHECK(fault_of("phong:specular_gate=maybe") == "phong:specular_gate: \"maybe\", false or true");
  CHECK(fault_of("lambert:albedo=1.5") ==
        "lambert:albedo: \"1.5\", a number from 0 to 1, or three, with commas between them");
  CHECK(fault_of("lambert+").starts_with(": \"lambert+\", one of lambert"));
  CHECK(fault_of("").starts_with(": \"\", one of lambert"));
}

TEST_CASE("a path is no model, and a name with a colon is no path") {
  for (const char* const path : {"brass.binary", "./lambert", "tables/phong", "../phong:8", "a", "lambert.binary"})
    CHECK_FALSE_MESSAGE(means_model(path), path);
  for (const char* const model :
       {"lambert", "diffuse", "brass-like", "phog:ks=1", "blinn_phong:ks=.5", "lambert+phong"})
    CHECK_MESSAGE(means_model(model), model);
}

TEST_CASE("every model of the list is read back as it is written") {
  for_each_model([](const auto& model) {
    const std::string text = model_text(BrdfModel(model));
    CAPTURE(text);
    CHECK(model_text(one(text)) == text);
    CHECK(means_model(text));
    CHECK_FALSE(model_meaning(model).empty());
  });
  CHECK(model_text(std::vector<BrdfModel>{Lambert{}, GgxConductor{0.25, {0.5, 0.25, 1}}}) ==
        "lambert:albedo=0.5+ggx-conductor:alpha=0.25,f0=0.5,0.25,1");
}

TEST_CASE("fragment functions reflect what they shade, by n.l") {
  // theta_in 60, theta_out 30, opposite: h lies 15 degrees from n, r 30 degrees from v; n.l = 1/2.
  const DirectionPair at = opposite(60, 30);
  BlinnPhong blinn;
  blinn.kd = Double3(0.25), blinn.ks = Double3(0.5), blinn.glossiness = 10;
  CHECK(model_value(blinn, at).x == doctest::Approx(0.25 + 0.5 * std::pow(cos_degrees(15), 10) / 0.5).epsilon(1e-14));
  Phong phong;
  phong.kd = Double3(0.25), phong.ks = Double3(0.5), phong.glossiness = 10;
  CHECK(model_value(phong, at).x == doctest::Approx(0.25 + 0.5 * std::pow(cos_degrees(30), 10) / 0.5).epsilon(1e-14));
}

TEST_CASE("below the horizon nothing is reflected, and on it nothing is infinite") {
  for_each_model([](const auto& model) {
    for (const double theta : {90.0, 120.0, 180.0}) {
      CHECK(model_value(BrdfModel(model), opposite(theta, 30)) == Rgb<double>(0));
      CHECK(model_value(BrdfModel(model), opposite(30, theta)) == Rgb<double>(0));
    }
    const Rgb<double> grazing = model_value(BrdfModel(model), opposite(89.999, 89.999));
    CHECK(std::isfinite(grazing.x));
    CHECK(grazing.x >= 0);
  });
}
