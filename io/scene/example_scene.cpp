#include "io/scene/example_scene.h"

namespace refraster {

std::string example_scene() {
  return R"({"scene": {
  "camera": {"position": "0 0 5", "fov_y": 30},
  "point_lights": [],
  "direction_lights": [
    {"direction": "-1 -1.5 -1", "radiance": "0.9 0.9 0.85"},
    {"direction": "1 0.3 -0.5", "radiance": "0.15 0.18 0.25"}
  ],
  "objects": [{
    "mesh": {"sphere": {}},
    "fragment_function": "phong",
    "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
    "material": {"ka": "0.1 0.1 0.1", "kd": "0.7 0.7 0.7", "ks": "0.2 0.2 0.2", "glossiness": 30}
  }]
}}
)";
}

} // namespace refraster
