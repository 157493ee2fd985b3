#include <refraster/mesh.h>

#include "bench/measure/scene_bench.h"
#include "bench/workloads/built_in.h"
#include "bench/workloads/variants.h"
#include "scenes/synthesis/merl_synthesis.h"

#include <doctest/doctest.h>

#include <numeric>

using namespace refraster;
using namespace refraster::bench;

namespace {

/// A ball for each of these fragment functions, side by side, lit by a point light and a direction light.
Scene balls(const std::vector<FragmentFunction>& functions) {
  Scene scene = built_in_scene();
  scene.camera.position = {0, 0, 6};
  scene.direction_lights.push_back({});
  scene.objects.clear();
  const auto mesh = std::make_shared<Mesh>(sphere_mesh(16, 8));
  for (std::size_t i = 0; i < functions.size(); ++i) {
    Object& object = scene.objects.emplace_back();
    object.mesh = mesh;
    object.position = {2.1 * (static_cast<double>(i) - 0.5 * static_cast<double>(functions.size() - 1)), 0, 0};
    object.material.fragment_function = functions[i];
  }
  return scene;
}

FragmentFunction measured(MerlLookup lookup) {
  static const std::shared_ptr<const MerlTable> table(
      new MerlTable(merl_table_from(find_brdf_preset("nylon-like")->brdf)));
  return Merl{table, lookup, MerlAngles::closed};
}

SceneTask small_task(Scene scene) {
  return {.name = "balls",
          .scene = std::move(scene),
          .width = 96,
          .height = 54,
          .precisions = {"double", "float"},
          .threads = {1, 2}};
}

SceneResult quickly(const SceneTask& task) {
  const PinnedThreadPool thread_pool;
  return bench_scene(task, {.warm_up = 1, .least = 2, .seconds = 0}, thread_pool);
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
  CHECK(textured.objects[0].material.diffuse_map.texture);
  CHECK_FALSE(textured.objects[1].material.diffuse_map.texture);
  CHECK_FALSE(has_textures(without_textures(textured)));
  CHECK_FALSE(shows_textures(balls({measured(MerlLookup::nearest)})));
}

TEST_CASE("a scene's functions are reported once each; a measured BRDF also in the two usual ways") {
  const Scene scene = balls({BlinnPhong{}, Phong{}, BlinnPhong{}, measured(MerlLookup::trilinear_log)});
  std::vector<std::string> names;
  for (const FragmentFunctionVariant& function : functions_of(scene)) names.push_back(bench::name_of(function));
  CHECK(names ==
        std::vector<std::string>{"blinn_phong", "phong", "merl trilinear-log", "merl nearest", "merl trilinear"});
  CHECK(only(scene, {BlinnPhong::name, {}}).objects.size() == 2);
  const Scene nearest = only(scene, {Merl::name, MerlLookup::nearest});
  REQUIRE(nearest.objects.size() == 1);
  CHECK(std::get<Merl>(nearest.objects[0].material.fragment_function).lookup == MerlLookup::nearest);
}

TEST_CASE(
    "a result for each precision and number of threads, marginal costs for the first; parts add up to the frame") {
  const SceneTask task = small_task(balls({Phong{}, measured(MerlLookup::trilinear)}));
  const SceneResult result = quickly(task);
  CHECK(result.lights == 2);
  CHECK(result.repetitions == 2);
  CHECK(result.opengl.empty());
  CHECK(result.counts.shaded > 300);
  REQUIRE(result.precisions.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const PrecisionResult& precision = result.precisions[i];
    CHECK(precision.precision == (i < 2 ? "double" : "float"));
    CHECK(precision.threads == (i % 2 == 0 ? 1 : 2));
    CHECK(precision.frame_ms.min > 0);
    CHECK(precision.frame_ms.max >= precision.frame_ms.min);
    // Two repetitions: the middle half is both, and its mean their median.
    CHECK(sum(precision.split_ns) == doctest::Approx(precision.frame_ms.median * 1e6 / result.shaded()));
    CHECK(precision.split_ns.visibility > 0);
    CHECK(precision.split_ns.interpolation > 0);
    CHECK(precision.marginal.has_value() == (i % 2 == 0));
    REQUIRE(precision.functions.size() == (i % 2 == 0 ? 3 : 0)); // phong, merl trilinear, merl nearest
    for (const FunctionCost& cost : precision.functions) {
      CHECK(cost.fragments > 100);
      CHECK(cost.fragments < result.counts.fragments); // the other ball's are not among them
    }
  }
}

TEST_CASE("nothing is measured that a scene does not have") {
  const SceneTask dark = small_task(without_lights(balls({Phong{}})));
  const SceneResult result = quickly(dark);
  CHECK(result.precisions[0].functions.empty());
  CHECK(result.precisions[0].marginal->texture);
  SceneTask measured_only = small_task(balls({measured(MerlLookup::nearest)}));
  measured_only.samples = 16;
  const SceneResult merl = quickly(measured_only);
  CHECK_FALSE(merl.precisions[0].marginal->texture);        // a measured BRDF shows none
  CHECK_FALSE(merl.precisions[0].marginal->double_samples); // there are no 32
  SceneTask bare = small_task(balls({Phong{}}));
  bare.marginals = Marginals::left_out;
  CHECK_FALSE(quickly(bare).precisions[0].marginal);
}
