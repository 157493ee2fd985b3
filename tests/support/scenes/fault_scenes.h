#pragma once
// Scenes on which the faults of tests/support/gl/seeded_faults.h show, and others.

#include <refraster/scene.h>

#include <string_view>
#include <vector>

namespace refraster {

struct FaultScene {
  std::string_view name;
  Scene scene;
};

/// Plastic things of both formulas with textures of every filter, lights of both types, attenuated or not, things that
/// are stretched, open, culled, in one plane with others, and beyond the depth planes; the same with highlights that
/// the horizon cuts off; measured things, whose table has holes; and things with all other maps. Made once.
const std::vector<FaultScene>& fault_scenes();

} // namespace refraster
