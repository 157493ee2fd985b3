#pragma once
// Scenes for the program, small enough to read.

#include <string>

namespace refraster {

/// A lit sphere before a slanted plane. Scene files may have comments.
inline const std::string ball_scene = R"({
  // a ball on a floor
  "scene": {
  "camera": {"position": "0 1 4", "target": "0 0 0", "fov_y": 40},
  "background": "0.1 0.2 0.3",
  "point_lights": [{"position": [2, 3, 4], "radiance": [8, 8, 8], "constant": 1, "linear": 0, "quadratic": 0.2}],
  "direction_lights": [{"direction": "-1 -1 -1", "radiance": "0.4 0.3 0.2"}],
  "objects": [
    {"mesh": {"sphere": {"segments": 24, "rings": 12}}, "fragment_function": "phong", "position": "0 0 0",
     "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
     "material": {"ka": "0.05 0.05 0.05", "kd": "0.7 0.4 0.2", "ks": "0.5 0.5 0.5", "glossiness": 20}},
    {"mesh": {"plane": {"segments": 2}}, "fragment_function": "blinn_phong", "position": "0 -1 0",
     "rotate_x": 0, "rotate_y": 30, "rotate_z": 0, "scale": "3 1 3",
     "material": {"ka": "0.02 0.02 0.02", "kd": "0.3 0.5 0.3", "ks": "0.2 0.2 0.2", "glossiness": 50}}
  ]}
})";

/// The same, with the file m.obj for the sphere.
inline std::string ball_from_file() {
  std::string scene = ball_scene;
  const std::string sphere = R"("mesh": {"sphere": {"segments": 24, "rings": 12}})";
  return scene.replace(scene.find(sphere), sphere.size(), R"("obj_file_path": "m.obj")");
}

/// Valid, with nothing to see.
inline const std::string empty_scene = R"({"scene": {
  "camera": {"position": "0 0 5"}, "background": "0.2 0.4 0.6", "point_lights": [], "direction_lights": [], "objects": []
}})";

} // namespace refraster
