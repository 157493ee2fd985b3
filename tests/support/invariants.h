#pragma once
// What holds of every scene that a reader accepted, and of every frame: asked by the fuzz targets and by the soak.

#include <refraster/render.h>

#include <string>

namespace refraster::test {

// Each says what is wrong, "" if nothing is.

/// Numbers are finite, lists as long as they must be, indices in range, every vertex used.
std::string fault_of(const Mesh& mesh);
/// Levels halve down to 1 x 1 or there is one; every value is in [0, full_scale].
std::string fault_of(const Texture& texture);
/// What scene.h says of each member, and the above for what the objects share.
std::string fault_of(const Scene& scene);
/// Images of the size asked for; radiance finite and not negative; depth in [0, 1], indices those of the scene; each
/// triangle has one fate, and no more pixels are shaded than there are.
std::string fault_of(const Frame& frame, const Scene& scene, const RenderOptions& options);

/// All aovs, in the order of the enum.
std::vector<Aov> all_aovs();

/// "" if both frames hold the same bits in every image, and the same counts; else what differs.
std::string difference(const Frame& a, const Frame& b);

} // namespace refraster::test
