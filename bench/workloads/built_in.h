#pragma once
// A scene for those who name none.

#include <refraster/scene.h>

namespace refraster::bench {

/// A Blinn-Phong sphere of about 20,000 triangles under one light, seen from so near that it fills the image whatever
/// its shape: each pixel is shaded.
Scene built_in_scene();
inline constexpr const char* built_in_name = "built-in sphere";

} // namespace refraster::bench
