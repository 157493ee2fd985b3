#pragma once
// Which objects of a scene are seen in a cluster of pixels.

#include <refraster/compare.h>
#include <refraster/image.h>
#include <refraster/scene.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// Which object each pixel sees, and which triangle of it.
struct SeenObjects {
  std::vector<std::string> names; // of the scene's objects: object_labels()
  Image<std::uint32_t> object;    // 1 + the index into names; 0: none. 1 channel
  Image<std::uint32_t> triangle;  // 1 + the index in its object's mesh; 0: none. 1 channel
};

/// The names of a scene's objects. Where several have one name, or one has none, their numbers stand behind it, counted
/// from 1 as in the AOV `object`: "cube (object 3)".
std::vector<std::string> object_labels(const Scene& scene);

/// Numbers of an AOV (object, triangle) as whole numbers; what is none becomes 0.
Image<std::uint32_t> ids_of(const Image<float>& aov);

/// What the pixels of an image of this size see at their centres: a frame of the scene, of which nothing is shaded.
/// Throws as render() does.
SeenObjects seen_objects(const Scene& scene, int width, int height, const MemoryBudget& memory = {});

/// Names and their numbers of pixels.
using ObjectCounts = std::vector<std::pair<std::string, std::uint64_t>>;

/// What is seen in a cluster of these marks, most pixels first; pixels that see no object are counted as "background".
ObjectCounts cluster_objects(const Image<std::uint8_t>& marked, const Cluster& cluster, const SeenObjects& seen);

} // namespace refraster
