#pragma once
// What a pixel's colour is, far beyond the precision of any rung.

#include "math/twofold.h"
#include "raster/scene.h"

#include <array>
#include <memory>
#include <optional>

namespace refraster {

/// A pixel of the image and what it shows, as the renderer decided (exactly, and the same for all rungs): object and
/// triangle in its mesh, counted from 0.
struct SeenPixel {
  int x = 0, y = 0;
  std::size_t object = 0, triangle = 0;
};

/// The radiance of single pixels in 60 digits. Given are the scene's numbers as they are (doubles; floats in meshes,
/// textures and tables), which triangle the pixel shows, and where its corners stand in the window: on the lattice of
/// 1/256 pixel, or as the vertex stage has them in double. Everything else is worked out from the formulas of
/// docs/conventions.md, by other arithmetic than the renderer's: matrices, interpolation, textures, lights, fragment
/// functions, MERL lookups.
class PixelOracle {
public:
  /// `scene` must outlive it.
  PixelOracle(const Scene& scene, int width, int height);
  ~PixelOracle();
  PixelOracle(const PixelOracle&) = delete;

  /// Red, green and blue, each to 106 bits. Nothing where it cannot follow the renderer: no normal, a direction that
  /// the mathematics leaves undefined, a fragment function whose formula it does not have.
  std::optional<std::array<Twofold<double>, 3>> radiance(const SeenPixel& pixel) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace refraster
