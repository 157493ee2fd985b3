#pragma once
// Shaders that are legal GLSL and ask for what refraster does not give, or that are not quite legal: what is said of
// each.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

struct OddShader {
  std::string name;
  std::string vertex, fragment;                 // empty: ours
  std::vector<std::string> warnings{};          // N stands for any number in those that count pixels or samples
  std::optional<std::array<float, 3>> colour{}; // in the middle of the image, where something certain is seen
  int exit_code = 0;
  std::string error{}; // words of it
};

/// Each is drawn as a ball named "ball" before a background of (0.25, 0.5, 0.75), of the fragment function phong, under
/// one direction light.
const std::vector<OddShader>& odd_shaders();

} // namespace refraster
