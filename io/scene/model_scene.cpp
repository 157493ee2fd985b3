#include "io/scene/model_scene.h"

#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/json/json.h"
#include "io/scene/not_a_scene.h"
#include "io/scene/scene_edits.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

namespace refraster {
namespace {
namespace fs = std::filesystem;

// Three lights, as photographers set them: the key from the upper left models the shape, the fill from the right and
// the viewer's side shows what it leaves dark, the rim from behind parts the outline from the background. They add up
// to about 1 on a surface that faces the viewer, so that textures keep their colours.
constexpr const char* lights = R"([
    {"space": "camera", "direction": "0.5 -0.7 -1", "radiance": "0.8 0.8 0.8"},
    {"space": "camera", "direction": "-1 -0.1 -0.9", "radiance": "0.28 0.28 0.3"},
    {"space": "camera", "direction": "-0.4 -0.8 1", "radiance": "0.35 0.35 0.35"}
  ])";

} // namespace

bool is_model(const std::string& path) {
  std::error_code error;
  return extension(path) == "obj" && fs::is_regular_file(path, error) && !holds_json(path);
}

std::string model_scene_text(const std::string& obj_file_path) {
  return R"({"scene": {
  "camera": {"fit": {"azimuth": 30, "elevation": 20, "margin": 0.05}, "up": "0 1 0", "fov_y": 30},
  "background": "0.1 0.1 0.11",
  "point_lights": [],
  "direction_lights": )" +
         std::string(lights) + R"(,
  "objects": [{
    "obj_file_path": )" +
         json_string(obj_file_path) + R"(,
    "vertex_colors": "srgb",
    "fragment_function": "blinn_phong",
    "material": "from_file",
    "two_sided": true,
    "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1"
  }],
  "picture": {"width": 1280, "height": 720, "samples": 8, "srgb": true}
}}
)";
}

std::string scene_text_of_model(const std::string& path) {
  if (auto fault = file_fault(path, "an OBJ file", std::numeric_limits<std::uint64_t>::max()))
    throw InputError(std::move(*fault));
  const std::string name = fs::path(path).filename().string();
  if (as_utf8(name) != name)
    throw InputError(InputFault{path, 0, 0, "", "a file name that is no UTF-8",
                                "one that a scene can hold: rename the file"});
  return model_scene_text(name);
}

std::string scene_text(const std::string& path, const MemoryBudget& memory) {
  if (is_model(path)) return scene_text_of_model(path);
  if (auto error = not_a_scene(path)) throw std::move(*error);
  memory.need(2 * std::min<std::uint64_t>(file_size_bytes(path), JsonDocument::max_bytes), path);
  return read_file(path, extension(path) == "obj" ? "an OBJ file" : "a scene file", JsonDocument::max_bytes);
}

} // namespace refraster
