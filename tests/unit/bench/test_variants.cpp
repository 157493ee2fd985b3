#include "bench/measure/scene_bench.h"
#include "bench/workloads/built_in.h"
#include "bench/workloads/variants.h"
#include "scene/shapes.h"
#include "scenes/synthesis/merl_synthesis.h"

#include <doctest/doctest.h>

#include <numeric>

using namespace refraster;
using namespace refraster::bench;

namespace {

/// A ball for each of these models, side by side, lit by a point light and a direction light.
Scene balls(const std::vector<Model>& models) {
  Scene scene = built_in_scene();
  scene.camera.position = {0, 0, 6};
  scene.direction_lights.push_back({});
  scene.objects.clear();
  const auto mesh = std::make_shared<Mesh>(sphere_mesh(16, 8));
  for (std::size_t i = 0; i < models.size(); ++i) {
    Object& object = scene.objects.emplace_back();
    object.mesh = mesh;
    object.position = {2.1 * (static_cast<double>(i) - 0.5 * static_cast<double>(models.size() - 1)), 0, 0};
    object.material.model = models[i];
  }
  return scene;
}

Model measured(MerlLookup lookup) {
  static const std::shared_ptr<const MerlTable> table(
      new MerlTable(merl_table_from(find_brdf_preset("nylon-like")->brdf)));
  return Merl{table, lookup, MerlAngles::closed};
}

SceneTask small_task(Scene scene) {
  return {.name = "balls",
          .scene = std::move(scene),
          .width = 96,
          .height = 54,
          .rungs = {"double", "float"},
          .threads = {1, 2}};
}

SceneResult quickly(const SceneTask& task) {
  const PinnedTeams teams;
  return bench_scene(task, {.warm_up = 1, .least = 2, .seconds = 0}, teams);
}

double sum(const Split& split) {
  double all = 0;
  for (const auto& [name, part] : split_parts) all += split.*part;
  return all;
}

} // namespace

TEST_CASE("one more light is the last one again") {
  Scene scene = balls({Phong{}});
  CHECK(lights(scene) == 2);
  CHECK(lights(without_lights(scene)) == 0);
  CHECK(with_one_more_light(scene).direction_lights.size() == 2);
  scene.direction_lights.clear();
  CHECK(with_one_more_light(scene).point_lights.size() == 2);
  CHECK(lights(with_one_more_light(without_lights(scene))) == 1);
}

TEST_CASE("textures are taken off, or put on, where they show") {
  Scene scene = balls({Phong{}, measured(MerlLookup::trilinear)});
  CHECK_FALSE(has_textures(scene));
  CHECK(shows_textures(scene));
  const Scene textured = with_textures(scene);
  CHECK(has_textures(textured));
  CHECK(textured.objects[0].material.texture);
  CHECK_FALSE(textured.objects[1].material.texture);
  CHECK_FALSE(has_textures(without_textures(textured)));
  CHECK_FALSE(shows_textures(balls({measured(MerlLookup::nearest)})));
}

TEST_CASE("a scene's functions are told once each; a measured BRDF also in the two usual ways") {
  const Scene scene = balls({BlinnPhong{}, Phong{}, BlinnPhong{}, measured(MerlLookup::trilinear_log)});
  std::vector<std::string> names;
  for (const Function& function : functions_of(scene)) names.push_back(bench::name_of(function));
  CHECK(names ==
        std::vector<std::string>{"blinn_phong", "phong", "merl trilinear-log", "merl nearest", "merl trilinear"});
  CHECK(only(scene, {BlinnPhong::name, {}}).objects.size() == 2);
  const Scene nearest = only(scene, {Merl::name, MerlLookup::nearest});
  REQUIRE(nearest.objects.size() == 1);
  CHECK(std::get<Merl>(nearest.objects[0].material.model).lookup == MerlLookup::nearest);
}

TEST_CASE("a result for each rung and number of threads, marginal costs for the first; parts add up to the frame") {
  const SceneTask task = small_task(balls({Phong{}, measured(MerlLookup::trilinear)}));
  const SceneResult result = quickly(task);
  CHECK(result.lights == 2);
  CHECK(result.rounds == 2);
  CHECK(result.opengl.empty());
  CHECK(result.counts.shaded > 300);
  REQUIRE(result.rungs.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const RungResult& rung = result.rungs[i];
    CHECK(rung.rung == (i < 2 ? "double" : "float"));
    CHECK(rung.threads == (i % 2 == 0 ? 1 : 2));
    CHECK(rung.frame_ms.min > 0);
    CHECK(rung.frame_ms.max >= rung.frame_ms.min);
    // Two rounds: the middle half is both, and its mean their median.
    CHECK(sum(rung.split_ns) == doctest::Approx(rung.frame_ms.median * 1e6 / result.shaded()));
    CHECK(rung.split_ns.visibility > 0);
    CHECK(rung.split_ns.interpolation > 0);
    CHECK(rung.marginal.has_value() == (i % 2 == 0));
    REQUIRE(rung.functions.size() == (i % 2 == 0 ? 3 : 0)); // phong, merl trilinear, merl nearest
    for (const FunctionCost& cost : rung.functions) {
      CHECK(cost.fragments > 100);
      CHECK(cost.fragments < result.counts.fragments); // the other ball's are not among them
    }
  }
}

TEST_CASE("nothing is measured that a scene does not have") {
  const SceneTask dark = small_task(without_lights(balls({Phong{}})));
  const SceneResult result = quickly(dark);
  CHECK(result.rungs[0].functions.empty());
  CHECK(result.rungs[0].marginal->texture);
  SceneTask measured_only = small_task(balls({measured(MerlLookup::nearest)}));
  measured_only.samples = 16;
  const SceneResult merl = quickly(measured_only);
  CHECK_FALSE(merl.rungs[0].marginal->texture);        // a measured BRDF shows none
  CHECK_FALSE(merl.rungs[0].marginal->double_samples); // there are no 32
  SceneTask bare = small_task(balls({Phong{}}));
  bare.marginals = Marginals::left_out;
  CHECK_FALSE(quickly(bare).rungs[0].marginal);
}
