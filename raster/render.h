#pragma once
// The frame: a scene becomes images.

#include "raster/frame.h"
#include "scene/scene.h"

#include <memory>
#include <string_view>

namespace refraster {

/// Renders frame after frame, and keeps its memory from one to the next: where frames are alike, none but the first
/// pays for it. A frame does not depend on the ones before. Not for several threads at once; each may have its own.
class Renderer {
public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Renders the scene into `frame`, whose images are used again if they are of the right size. Options must be within
  /// their ranges (assert). Total: any finite or non-finite vertex, any scale. The same bits for every number of
  /// threads, tile size and crop. Pixels of a cancelled frame are those of this one or of the one before; of
  /// AOVs, those of this one or 0. What a progress function throws, or std::bad_alloc, ends the frame and comes out;
  /// the next frame is not harmed.
  void render(const Scene& scene, const RenderOptions& options, Frame& frame);

private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// How many fragments of a precision are shaded at once, on the instruction set that this library was built for; 0 if
/// there is no precision of that name.
int precision_lanes(std::string_view precision);

/// A single frame.
Frame render(const Scene& scene, const RenderOptions& options);

} // namespace refraster
