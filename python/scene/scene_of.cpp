// Between scenes as Python has them, and as the library does.

#include "python/scene/scenes.h"
#include "python/work.h"

#include <map>

namespace refraster::python {
namespace {

/// Calls visit(list, index) with each list of lights, and its place in light_lists.
void for_each_numbered_list(auto& scene, auto&& visit) {
  std::size_t index = 0;
  for_each_light_list(scene, [&](auto& list) { visit(list, index++); });
}

Object object_of(const py::handle item, const std::string& place) {
  if (!py::isinstance<LiveObject>(item)) refuse_argument(place, item, "a refraster.Object");
  const auto& live = py::cast<const LiveObject&>(item);
  if (!live.mesh) throw ArgumentError(place + "/mesh", "none", "a refraster.Mesh");
  if (!live.material) throw ArgumentError(place + "/material", "none", "a refraster.Material");
  Object object = live.text.object;
  object.mesh = live.mesh->mesh;
  object.material = live.material->material(place + "/material");
  object.materials.clear();
  for (const py::handle material : live.materials) {
    const std::string of = place + "/materials/" + std::to_string(object.materials.size());
    if (!py::isinstance<LiveMaterial>(material)) refuse_argument(of, material, "a refraster.Material");
    object.materials.push_back(py::cast<const LiveMaterial&>(material).material(of));
  }
  return object;
}

/// One Python object for each mesh and each texture, however many objects and materials have it.
class Shared {
public:
  std::shared_ptr<LiveMesh> mesh(const std::shared_ptr<const Mesh>& mesh) {
    auto& entry = meshes_[mesh.get()];
    if (!entry) entry = std::make_shared<LiveMesh>(mesh);
    return entry;
  }
  std::shared_ptr<LiveMaterial> material(const Material& material) {
    auto live = std::make_shared<LiveMaterial>();
    live->function = live_function(material.fragment_function);
    live->text.object.material = material;
    for (std::size_t i = 0; i < texture_slots.size(); ++i) {
      const TextureMap& map = material.*texture_slots[i].map;
      if (!map.texture) continue;
      live->maps[i] = std::make_shared<LiveTextureMap>();
      live->maps[i]->text.map = map;
      live->maps[i]->texture = texture(map.texture);
    }
    return live;
  }

private:
  std::shared_ptr<LiveTexture> texture(const std::shared_ptr<const Texture>& texture) {
    auto& entry = textures_[texture.get()];
    if (!entry) entry = std::make_shared<LiveTexture>(LiveTexture{texture});
    return entry;
  }

  std::map<const Mesh*, std::shared_ptr<LiveMesh>> meshes_;
  std::map<const Texture*, std::shared_ptr<LiveTexture>> textures_;
};

} // namespace

LiveScene::LiveScene() {
  Scene empty;
  for_each_light_list(empty, [&](auto&) { lights.emplace_back(); });
}

SceneSource source_of(const LiveScene& live) {
  SceneSource source;
  Scene& scene = source.scene;
  scene.camera = live.camera->camera;
  if (live.camera->fit) source.view.fit = live.camera->fit->fit;
  scene.background = live.background;
  source.view.picture = live.picture;
  for_each_numbered_list(scene, [&]<class Light>(std::vector<Light>& list, std::size_t index) {
    for (const py::handle item : live.lights[index]) {
      const std::string place = std::string(Light::names.key) + "/" + std::to_string(list.size());
      if (!py::isinstance<LiveLight<Light>>(item)) refuse_argument(place, item, "one of the list's own type of light");
      const auto& light = py::cast<const LiveLight<Light>&>(item);
      if (light.space == LightSpace::camera) source.view.moving<Light>().push_back(list.size());
      list.push_back(light.light);
    }
  });
  for (const py::handle item : live.objects)
    scene.objects.push_back(object_of(item, "objects/" + std::to_string(scene.objects.size())));
  return source;
}

std::shared_ptr<LiveScene> live_scene(SceneSource source) {
  auto live = std::make_shared<LiveScene>();
  Scene& scene = source.scene;
  live->camera->camera = scene.camera;
  if (source.view.fit) live->camera->fit = std::make_shared<LiveCameraFit>(LiveCameraFit{*source.view.fit});
  live->background = scene.background;
  live->picture = source.view.picture;
  for_each_numbered_list(scene, [&]<class Light>(std::vector<Light>& list, std::size_t index) {
    std::vector<LightSpace> spaces(list.size(), LightSpace::world);
    for (const std::size_t moving : source.view.moving<Light>()) spaces[moving] = LightSpace::camera;
    for (std::size_t i = 0; i < list.size(); ++i)
      live->lights[index].append(std::make_shared<LiveLight<Light>>(LiveLight<Light>{list[i], spaces[i]}));
  });
  Shared shared;
  for (Object& object : scene.objects) {
    auto one = std::make_shared<LiveObject>();
    one->mesh = shared.mesh(object.mesh);
    one->material = shared.material(object.material);
    for (const Material& material : object.materials) one->materials.append(shared.material(material));
    object.materials.clear();
    one->text.object = std::move(object);
    live->objects.append(one);
  }
  return live;
}

std::shared_ptr<LiveScene> load_scene(const std::string& path, const SceneOptions& options,
                                      const std::vector<SceneEdit>& edits) {
  NoteList notes;
  SceneOptions reading = options;
  reading.notes = &notes;
  SceneSource source;
  run_watched(py::none(), [&](Watch&) { source = read_scene_source(path, reading, edits); });
  auto live = live_scene(std::move(source));
  live->path = path;
  for (const Note& note : notes.notes()) live->notes.push_back(note.text());
  return live;
}

} // namespace refraster::python
