#include <refraster/mesh.h>
#include <refraster/scene.h>

#include <doctest/doctest.h>

#include <functional>
#include <limits>

using namespace refraster;

namespace {

using Effect = SceneFault::Effect;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

Scene sound_scene() {
  Scene scene;
  scene.camera.position = {0, 0, 4};
  scene.point_lights.push_back({.position = {1, 2, 3}});
  scene.direction_lights.push_back({});
  auto texture = std::make_shared<Texture>();
  texture->levels.push_back({2, 2, PaddedVector<float>(12, 255.f)});
  build_mip_levels(*texture);
  for (int i = 0; i < 2; ++i) {
    Object object;
    object.mesh = std::make_shared<const Mesh>(sphere_mesh(8, 4));
    object.material.diffuse_map.texture = texture;
    object.material.diffuse_map.filter = TextureFilter::trilinear;
    scene.objects.push_back(object);
  }
  return scene;
}

void change_mesh(Object& object, const std::function<void(Mesh&)>& change) {
  auto mesh = std::make_shared<Mesh>(*object.mesh);
  change(*mesh);
  object.mesh = mesh;
}
void change_texture(Object& object, const std::function<void(Texture&)>& change) {
  auto texture = std::make_shared<Texture>(*object.material.diffuse_map.texture);
  change(*texture);
  object.material.diffuse_map.texture = texture;
}

} // namespace

TEST_CASE("a sound scene has no fault, nor has an empty one") {
  CHECK(validate(sound_scene()).empty());
  CHECK(validate(Scene{}).empty());
}

TEST_CASE("each fault is told by the key, what was found and what was expected") {
  struct Row {
    std::function<void(Scene&)> spoil;
    const char* text;
    Effect effect;
  };
  const Row rows[] = {
      {[](Scene& s) { s.camera.position.x = not_a_number; },
       "camera/position: found nan, 0, 4, expected finite numbers", Effect::refused},
      {[](Scene& s) { s.camera.fov_y_degrees = 180; },
       "camera/fov_y: found 180, expected finite numbers above 0 and below 180", Effect::refused},
      {[](Scene& s) { s.camera.near = 0; }, "camera/near: found 0, expected finite numbers above 0", Effect::refused},
      {[](Scene& s) { s.camera.far = 0.1; }, "camera/far: found 0.1, expected more than near, 0.1", Effect::refused},
      {[](Scene& s) { s.objects[1].rotate_degrees.y = not_a_number; },
       "objects/1/rotate_y: found nan, expected finite numbers", Effect::refused},
      {[](Scene& s) { s.camera.target = s.camera.position; },
       "camera/target: found 0, 0, 4, expected another point than position", Effect::refused},
      {[](Scene& s) {
         s.camera.up = {0, 0, 0};
       },
       "camera/up: found 0, 0, 0, expected a direction", Effect::refused},
      {[](Scene& s) { s.background.y = -1; }, "background: found 0, -1, 0, expected finite numbers from 0",
       Effect::drawn},
      {[](Scene& s) { s.point_lights[0].radiance.z = infinite; },
       "point_lights/0/radiance: found 1, 1, inf, expected finite numbers from 0", Effect::refused},
      {[](Scene& s) { s.point_lights[0].linear = -1; },
       "point_lights/0/linear: found -1, expected finite numbers from 0", Effect::drawn},
      {[](Scene& s) {
         s.direction_lights[0].direction = {0, 0, 0};
       },
       "direction_lights/0/direction: found 0, 0, 0, expected a direction", Effect::refused},
      {[](Scene& s) { s.objects[1].scale.x = infinite; }, "objects/1/scale: found inf, 1, 1, expected finite numbers",
       Effect::refused},
      {[](Scene& s) { s.objects[1].mesh = nullptr; }, "objects/1/mesh: found null, expected a mesh", Effect::refused},
      {[](Scene& s) { change_mesh(s.objects[1], [](Mesh& m) { m.normals.pop_back(); }); },
       "objects/1/mesh/normals: found 42 normals, expected 43 normals: one a position", Effect::refused},
      {[](Scene& s) { change_mesh(s.objects[1], [](Mesh& m) { m.uvs.resize(46); }); },
       "objects/1/mesh/uvs: found 46 texture coordinates, expected at most one a position: 43 of them",
       Effect::refused},
      {[](Scene& s) { change_mesh(s.objects[1], [](Mesh& m) { m.triangles[7][2] = 45; }); },
       "objects/1/mesh/triangles/7: found vertex 45, expected an index below 43 vertices", Effect::refused},
      {[](Scene& s) { change_mesh(s.objects[1], [](Mesh& m) { m.positions[3].y = static_cast<float>(infinite); }); },
       "objects/1/mesh/positions/3: found inf, expected finite numbers", Effect::drawn},
      {[](Scene& s) { std::get<Phong>(s.objects[1].material.fragment_function).glossiness = not_a_number; },
       "objects/1/material/glossiness: found nan, expected finite numbers from 0", Effect::refused},
      {[](Scene& s) { s.objects[1].material.fragment_function = Merl{}; },
       "objects/1/material/table: found null, expected a measured table", Effect::refused},
      {[](Scene& s) { change_texture(s.objects[1], [](Texture& t) { t.levels.clear(); }); },
       "objects/1/material/texture/levels: found no level, expected at least one", Effect::refused},
      {[](Scene& s) { change_texture(s.objects[1], [](Texture& t) { t.levels[0].rgb.pop_back(); }); },
       "objects/1/material/texture/levels/0: found 11 values, expected 12 values: three a texel", Effect::refused},
      {[](Scene& s) { change_texture(s.objects[1], [](Texture& t) { t.levels[0].width = 0; }); },
       "objects/1/material/texture/levels/0: found 0 x 2 texels, expected 1 to 65536 texels a side", Effect::refused},
      {[](Scene& s) { change_texture(s.objects[1], [](Texture& t) { t.levels[0].rgb[4] = 256; }); },
       "objects/1/material/texture/levels/0/4: found 256, expected a number from 0 to 255", Effect::drawn},
      {[](Scene& s) { change_texture(s.objects[1], [](Texture& t) { t.levels.pop_back(); }); },
       "objects/1/material/texture: found 1 levels, expected levels down to 1 x 1 texel, for trilinear filtering",
       Effect::drawn},
  };
  for (const Row& row : rows) {
    Scene scene = sound_scene();
    row.spoil(scene);
    const std::vector<SceneFault> faults = validate(scene);
    CAPTURE(row.text);
    REQUIRE(!faults.empty());
    CHECK(faults[0].text() == row.text);
    CHECK(faults[0].effect == row.effect);
  }
}

TEST_CASE("all faults are told, and a mesh that several objects share once") {
  Scene scene = sound_scene();
  scene.camera.near = -1;
  scene.objects[0].scale.y = not_a_number;
  change_mesh(scene.objects[0], [](Mesh& m) { m.triangles[0][0] = 1000; });
  scene.objects[1].mesh = scene.objects[0].mesh;
  CHECK(validate(scene).size() == 3);
}
