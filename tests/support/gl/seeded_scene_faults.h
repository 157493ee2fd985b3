#pragma once
// Faults that are planted in the scene that OpenGL draws, and in images; for seeded_faults.cpp.

#include "tests/support/gl/seeded_faults.h"

namespace refraster {

std::vector<SeededFault> seeded_scene_faults();
std::vector<SeededFault> seeded_map_faults();
std::vector<SeededFault> seeded_image_faults();

} // namespace refraster
