#pragma once
// Scenes built in code, no files: between them they run every path that makes a pixel.

#include <refraster/scene.h>

#include <string>
#include <vector>

namespace refraster::test {

struct HashedScene {
  std::string name;
  Scene scene;
  int samples = 1;
};

/// The sides are odd and no multiples of a tile or of a register, so that every tile size leaves a rest.
inline constexpr int hashed_width = 149, hashed_height = 107;

/// The same scenes, bit for bit, on every machine.
std::vector<HashedScene> hashed_scenes();

} // namespace refraster::test
