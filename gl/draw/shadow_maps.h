#pragma once
// The depth maps of lights, drawn by OpenGL.

#include "gl/context/gl_api.h"
#include "raster/shadow/map/light_view.h"

#include <span>

namespace refraster {

/// Draws all maps, into layers of one array of GL_DEPTH_COMPONENT32F: each into the lower left corner of layers as
/// large as the largest map, whose other texels hold 1. Binds it to shadow_unit, where it is read as it is, and to
/// compared_shadow_unit, where a sampler compares with GL_LEQUAL and has GL_LINEAR. Afterwards the framebuffer and the
/// viewport are those from before. Throws NoOpenGl where this OpenGL has no textures of that size, or not so many
/// layers.
void draw_shadow_maps(const GlApi& gl, const Scene& scene, std::span<const LightView> views);

} // namespace refraster
