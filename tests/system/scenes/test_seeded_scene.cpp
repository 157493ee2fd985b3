// The random scenes that renderers are verified with.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "tests/support/checksum.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/seeded_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

using namespace refraster;
using test::seeded_scene;
using test::SeededScene;

namespace {

constexpr std::uint64_t seeds = 100;

/// How many of the first scenes have a feature, by its name.
class Features {
public:
  explicit Features(std::uint64_t end) {
    for (std::uint64_t seed = 0; seed < end; ++seed) {
      const Scene scene = seeded_scene(seed).scene;
      std::set<std::string> found;
      for (const Object& object : scene.objects) add(object, scene.camera, found);
      for (const PointLight& light : scene.point_lights)
        found.insert(light.linear > 0 || light.quadratic > 0 ? "attenuated"
                     : light.constant == 0                   ? "without attenuation"
                                                             : "of constant attenuation");
      if (!scene.direction_lights.empty()) found.insert("direction light");
      if (light_count(scene) == 0) found.insert("dark");
      for (const std::string& feature : found) ++counts_[feature];
    }
  }
  int operator[](const std::string& feature) { return counts_[feature]; }

private:
  static void add(const Object& object, const Camera& camera, std::set<std::string>& found) {
    const Material& material = object.material;
    found.insert(std::string(material.function_name()));
    found.insert(material.diffuse_map.texture ? std::string(name_of(material.diffuse_map.filter)) : "white");
    found.insert("cull " + std::string(name_of(object.cull)));
    found.insert("two_sided " + std::string(name_of(object.two_sided)));
    if (const Merl* const merl = material.measured())
      found.insert({"lookup " + std::string(name_of(merl->lookup)), "angles " + std::string(name_of(merl->angles))});
    else
      std::visit(
          [&](const auto& function) {
            if constexpr (requires { function.specular_gate; })
              found.insert("gate " + std::string(name_of(function.specular_gate)));
          },
          material.fragment_function);
    const double determinant = object.scale.x * object.scale.y * object.scale.z;
    found.insert(determinant == 0 ? "flat" : determinant < 0 ? "mirrored" : "upright");
    if (object.position == camera.position) found.insert("through the eye");
    if (!object.mesh->uvs.empty() && object.mesh->uvs.size() < object.mesh->positions.size())
      found.insert("uvs in part");
  }

  std::map<std::string, int> counts_;
};

void add(Checksum& sum, const auto& vector) {
  for (int k = 0; k < vector.length(); ++k) sum.add(vector[k]);
}
void add(Checksum& sum, const Scene& scene) {
  add(sum, scene.camera.position), sum.add(scene.camera.far), add(sum, scene.background);
  for (const PointLight& light : scene.point_lights) add(sum, light.position), sum.add(light.quadratic);
  for (const Object& object : scene.objects) {
    add(sum, object.position), add(sum, object.rotate_degrees), add(sum, object.scale);
    sum.add(static_cast<double>(object.material.fragment_function.index()));
    for (const Float3& position : object.mesh->positions) add(sum, position);
    for (const Float2& uv : object.mesh->uvs) add(sum, uv);
  }
}

} // namespace

// What one compiler finds with a seed is looked for with another one: none may choose in which order numbers are drawn.
TEST_CASE("random numbers, and the scenes made of them, are the same with every compiler and processor") {
  Checksum numbers, seeded, any;
  Random random(1);
  for (int i = 0; i < 1000; ++i) numbers.add(random.hard<double>()), numbers.add(random.hard<float>());
  for (std::uint64_t seed = 0; seed < seeds; ++seed) add(seeded, seeded_scene(seed).scene);
  for (int i = 0; i < 100; ++i)
    add(any, test::random_scene(random)), any.add(static_cast<double>(test::random_options(random).width));
  CHECK(numbers.value() == 1365563357262581323u);
  CHECK(seeded.value() == 4939311622864019288u);
  CHECK(any.value() == 5974795982052179971u);
}

TEST_CASE("a random scene to verify with is valid, and the same for the same seed") {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    const SeededScene made = seeded_scene(seed), again = seeded_scene(seed);
    for (const SceneFault& fault : validate(made.scene)) CHECK(fault.text() == "");
    CHECK(made.width == again.width);
    REQUIRE(made.scene.objects.size() == again.scene.objects.size());
    for (std::size_t i = 0; i < made.scene.objects.size(); ++i) {
      CHECK(made.scene.objects[i].mesh->positions == again.scene.objects[i].mesh->positions);
      CHECK(made.scene.objects[i].scale == again.scene.objects[i].scale);
    }
  }
}

TEST_CASE("the scenes of neighbouring seeds have nothing in common") {
  std::set<double> numbers;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Scene scene = seeded_scene(seed).scene;
    numbers.insert({scene.camera.position.x, scene.camera.far, scene.background.x});
  }
  CHECK(numbers.size() == 3 * seeds);
}

TEST_CASE("a hundred random scenes have everything that there is to verify") {
  Features features(seeds);
  const auto check_all = [&]<class Enum>(const std::string& prefix, Enum) {
    for (const auto& named : EnumNames<Enum>::names) {
      const std::string feature = prefix + std::string(named.second);
      CAPTURE(feature);
      CHECK(features[feature] >= 5);
    }
  };
  check_all("", TextureFilter{});
  check_all("cull ", Cull{});
  check_all("two_sided ", TwoSided{});
  check_all("lookup ", MerlLookup{});
  check_all("angles ", MerlAngles{});
  check_all("gate ", SpecularGate{});
  for (const char* const feature :
       {"phong", "blinn_phong", "merl", "white", "flat", "mirrored", "upright", "through the eye", "uvs in part",
        "attenuated", "without attenuation", "of constant attenuation", "direction light"}) {
    INFO(feature);
    CHECK(features[feature] >= 5);
  }
  CHECK(features["dark"] >= 1);
}

TEST_CASE("most random scenes to verify with show something in a fair part of the image") {
  int shown = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    RenderOptions options{.width = 48, .height = 27, .threads = 1};
    shown += render(seeded_scene(seed).scene, options).counts.shaded > 48 * 27 / 20;
  }
  CHECK(shown >= 80);
}
