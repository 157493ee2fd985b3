// An entry that is added to a declared list is seen by every reader of that list. What cannot follow by itself is named
// here: a formula that takes no notice of it, and generators and checks of the tests that do not know it.

#include <refraster/render.h>

#include "tests/support/invariants.h"
#include "tests/support/precisions.h"
#include "tests/support/scenes/declared_scenes.h"
#include "tests/support/scenes/random_scene.h"

#include <doctest/doctest.h>

#include <limits>
#include <map>

namespace refraster {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

void change_mesh(Scene& scene, auto&& change) {
  declared_detail::change_mesh(scene, change);
}

/// In a scene with one object: calls body(name, spoil), where spoil makes a part of it that the lists declare wrong.
void for_each_spoiled(auto&& body) {
  for (const DeclaredEntry& entry : declared_entries()) {
    Scene scene = entry.with;
    for_each_light_list(scene, [](auto& lights) {
      for (auto& light : lights) light.radiance.x = not_a_number;
    });
    if (entry.name.ends_with("lights")) body(entry.name, scene);
  }
  const Scene sound = half_textured(TextureFilter::bilinear);
  for (const TextureSlot& slot : texture_slots) {
    Scene scene = sound;
    (scene.objects[0].material.*slot.map).texture = std::make_shared<const Texture>();
    body("the texture " + std::string(slot.name), scene);
  }
  for_each_vertex_attribute([&]<class Value>(const VertexAttribute<Value>& attribute) {
    Scene scene = sound;
    change_mesh(scene, [&](Mesh& mesh) {
      (mesh.*attribute.values).resize(mesh.positions.size(), Value(0.5f));
      (mesh.*attribute.values).back()[0] = std::numeric_limits<float>::infinity();
    });
    body(std::string(attribute.words), scene);
  });
}

} // namespace

TEST_CASE("every type of light, texture slot and vertex attribute changes the picture, in every precision") {
  for (const DeclaredEntry& entry : declared_entries())
    for (const Precision precision : test::every_precision) {
      RenderOptions options;
      options.width = 24, options.height = 16;
      options.precision = precision;
      CHECK_MESSAGE(render(entry.with, options).rgb8.values != render(entry.without, options).rgb8.values,
                    "no formula takes notice of " << entry.name);
    }
}

TEST_CASE("what is wrong with any of them is found by validate() and by the invariants of the tests") {
  for_each_spoiled([](const std::string& name, const Scene& scene) {
    CHECK_MESSAGE(validate(scene).size() == (name.ends_with("lights") ? 2 : 1), name);
    CHECK_MESSAGE(test::fault_of(scene) != "", "tests/support/invariants.cpp does not look at " << name);
  });
}

TEST_CASE("random scenes have every type of light, texture and vertex attribute, and lack it too") {
  std::map<std::string, int> scenes_with;
  const auto count = [&](const std::string& name, bool has) { scenes_with[name] += has ? 1 : 0; };
  constexpr int scenes = 200;
  for (int i = 0; i < scenes; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Scene scene = test::random_scene(random);
    for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
      count(std::string(Light::names.words), !lights.empty());
    });
    count("lights with exact shadows", has_shadows(scene, Shadow::exact));
    count("lights with shadow maps", has_shadows(scene, Shadow::map));
    const auto any_object = [&](auto&& has) { return std::any_of(scene.objects.begin(), scene.objects.end(), has); };
    for (const TextureSlot& slot : texture_slots)
      count("the texture " + std::string(slot.name),
            any_object([&](const Object& object) { return (object.material.*slot.map).texture != nullptr; }));
    for_each_vertex_attribute([&](const auto& attribute) {
      count(std::string(attribute.words),
            any_object([&](const Object& object) { return !(object.mesh.get()->*attribute.values).empty(); }));
    });
  }
  for (const auto& with : scenes_with)
    CHECK_MESSAGE((with.second > 0 && with.second < scenes),
                  "tests/support/scenes/random_scene.cpp makes none of " << with.first);
}

} // namespace refraster
