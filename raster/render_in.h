#pragma once
// A frame in any Number without lanes: the same formulas as every precision, its colours as they are. For verification
// and measuring; compiles all of shading for the number.

#include "raster/shade/sample_data.h"
#include "raster/shade/shade_tile.h"

namespace refraster {

// The number has another name in the libraries of another level of x86-64, which the loader may take: who is built
// beside such has the template of its own (bench/CMakeLists.txt).
#ifndef REFRASTER_OWN_EXACT_SHADING
extern template class TileShadingOf<Exact>; // raster/shade/precisions/exact.cpp
#endif

/// Shades the pixels that `request` wants in T, and gives each that shows a surface to request.take. Of `options`, the
/// images wanted and the precision are not read. Returns the frame's counts.
template <Number T>
  requires(!NumberTraits<T>::has_lanes)
FrameCounts shade_in(const Scene& scene, const RenderOptions& options, const SampleRequest<T>& request) {
  RenderOptions plain = options;
  plain.want_rgb8 = plain.want_radiance = plain.want_radiance_double = false;
  plain.aovs.clear();
  Frame frame;
  render_with(
      scene, plain, [&] { return std::make_unique<TileShadingOf<T>>(request); }, frame);
  return frame.counts;
}

/// The radiance of a frame in T: 3 channels, of the crop or the whole image; the background where no surface is seen.
/// request.take is not called.
template <Number T>
  requires(!NumberTraits<T>::has_lanes)
Image<T> render_in(const Scene& scene, const RenderOptions& options, SampleRequest<T> request = {}) {
  const PixelRect region = rendered_region(options);
  Image<T> radiance(region.width, region.height, 3);
  const auto put = [&](int x, int y, const Rgb<T>& rgb) {
    for (int c = 0; c < 3; ++c) radiance.at(x - region.x, y - region.y)[c] = rgb[c];
  };
  for (int y = 0; y < region.height; ++y)
    for (int x = 0; x < region.width; ++x) put(region.x + x, region.y + y, as<T>(scene.background));
  request.take = put;
  shade_in(scene, options, request);
  return radiance;
}

} // namespace refraster
