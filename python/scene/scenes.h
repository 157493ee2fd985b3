#pragma once
// refraster.Scene and what it is made of. Python has objects that refer to each other; a Scene of the library is made
// of them when it is needed, in which only meshes and textures are shared.

#include <refraster/render.h>
#include <refraster/scene.h>

#include "io/scene/scene_source.h"
#include "python/scene/lights.h"
#include "python/scene/materials.h"
#include "python/scene/meshes.h"

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace refraster::python {

/// refraster.CameraFit
struct LiveCameraFit {
  CameraFit fit;
  /// All but the distance, which may be none: an attribute of its own.
  static void fields(auto& self, const auto& use) {
    fit_keys(self.fit, ValueKeys{[&](std::string_view name, auto& value, const Range& range, std::string_view meaning) {
               if (name != "distance") use(name, value, range, meaning);
             }});
  }
};

/// refraster.Camera
struct LiveCamera {
  Camera camera;
  std::shared_ptr<LiveCameraFit> fit; ///< null: it stands where `camera` says

  static void fields(auto& self, const auto& use) {
    SceneView view; // its fit has attributes of its own
    camera_keys(self.camera, view,
                ValueKeys{[&](std::string_view name, auto& value, const Range& range, std::string_view meaning) {
                  const bool is_of_window = name == "movement_speed" || name == "mouse_sensitivity";
                  if (!is_of_window) use(name, value, range, meaning);
                }});
  }
};

/// refraster.Object
struct LiveObject {
  ObjectText text; ///< of it, where and how the mesh stands
  std::shared_ptr<LiveMesh> mesh;
  std::shared_ptr<LiveMaterial> material = {};
  py::list materials; ///< of the mesh's runs, by their number

  static void fields(auto& self, const auto& use) {
    object_keys(self.text, ValueKeys{[&]<class Value>(std::string_view name, Value& value, const Range& range,
                                                      std::string_view meaning) {
                  if constexpr (!std::is_same_v<Value, VertexColours>) use(name, value, range, meaning); // of a file
                }});
  }
};

/// Renders the frames of a scene, and keeps its memory from one to the next.
struct SceneRenderer {
  std::mutex mutex;
  Renderer renderer;
};

/// refraster.Scene
struct LiveScene {
  std::shared_ptr<LiveCamera> camera = std::make_shared<LiveCamera>();
  Double3 background{0};
  std::vector<py::list> lights; ///< in the order of light_lists
  py::list objects;
  Picture picture;
  std::string path = {};               ///< of the file that it was read from; empty: none
  std::vector<std::string> notes = {}; ///< on what was read
  std::shared_ptr<SceneRenderer> renderer = std::make_shared<SceneRenderer>();

  LiveScene();
  static void fields(auto& self, const auto& use) {
    using namespace std::string_view_literals;
    use("background"sv, self.background, Range{}, "linear colour where there is no surface"sv);
    use("samples"sv, self.picture.samples, Range{1, 16}, "a pixel, where render is not asked for another number"sv);
    use("srgb"sv, self.picture.transfer, Range{}, "whether 8-bit images have the sRGB curve"sv);
  }
};

/// As the library has it. Throws ArgumentError for what is no object, light or material.
SceneSource source_of(const LiveScene& scene);

/// As Python has it. Objects share meshes and textures as those of the source do; each has a material of its own.
std::shared_ptr<LiveScene> live_scene(SceneSource source);

/// refraster.load
std::shared_ptr<LiveScene> load_scene(const std::string& path, const SceneOptions& options,
                                      const std::vector<SceneEdit>& edits);

} // namespace refraster::python
