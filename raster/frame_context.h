#pragma once
// What the stages of a frame have in common.

#include <refraster/render.h>
#include <refraster/scene.h>
#include <refraster/vector.h>

#include "raster/samples.h"

#include <span>

namespace refraster {

struct Geometry;    // raster/vertex/transform.h
struct Bins;        // raster/visibility/bin.h
class SceneShadows; // raster/shadow/scene_shadows.h

/// The pixels that a frame's images hold: those of the crop, or all.
PixelRect rendered_region(const RenderOptions& options);

/// How many threads render a frame: as many as asked for, or as the machine has processors.
int thread_count(const RenderOptions& options);

/// What any object of a scene has, and what packets of a frame without need not ask for.
struct SceneUses {
  bool two_sided = false;       // an object that is lit from both of its sides
  bool vertex_colours = false;  // a mesh with colours
  bool cut_outs = false;        // a material of which parts may be cut out: Material::has_cut_outs()
  bool tangents = false;        // a mesh with tangents
  bool placed_textures = false; // a texture that is scaled, moved or clamped: TextureMap::is_placed()
  bool shadows = false;         // a light with a shadow
};

/// Asked once a frame.
SceneUses uses_of(const Scene& scene);

/// From where a frame is seen: from the scene's camera, or from a light.
struct Viewpoint {
  Double4x4 clip_from_world{1};
  double near = 1; // the least w at which anything is drawn; > 0
};

/// The scene's camera, with the image's aspect. Of the vertex stage.
Viewpoint camera_viewpoint(const Scene& scene, const RenderOptions& options);

/// What a frame is made from. Whoever makes one names scene and options, from which the rest follows.
struct FrameInput {
  const Scene& scene;
  const RenderOptions& options;
  PixelRect region = rendered_region(options); // pixels of the full image that the frame's images hold
  std::span<const SamplePosition> samples = sample_pattern(options.samples); // of each pixel
  int threads = thread_count(options);
  SceneUses uses = uses_of(scene);
  Viewpoint viewpoint = camera_viewpoint(scene, options);
};

/// Where there is no surface.
inline Double3 shown_background(const FrameInput& frame) {
  return frame.options.background == Background::transparent ? Double3(0) : frame.scene.background;
}

/// The same, with what the first two stages made of it: everything that stays the same from tile to tile.
struct FrameContext : FrameInput {
  const Geometry& geometry;
  const Bins& bins;
  const SceneShadows* shadows = nullptr; // of a scene with shadows
};

} // namespace refraster
