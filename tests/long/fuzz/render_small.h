#pragma once
// What was accepted is drawn.

#include <refraster/scene.h>

#include <cstdint>

namespace refraster::fuzz {

/// Renders the scene at 8 x 8 pixels with every aov, and requires the invariants of a frame. `variant` chooses the
/// precision and the number of samples.
void render_small(const Scene& scene, std::size_t variant);

/// A scene that looks at the mesh from the front, lit and, if there is one, with the texture.
Scene showing(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Texture> texture, TextureFilter filter);

} // namespace refraster::fuzz
