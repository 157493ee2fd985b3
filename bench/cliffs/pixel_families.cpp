#include "bench/cliffs/shapes.h"

#include <cmath>

namespace refraster::cliffs {
namespace {

constexpr double first = 1 << 18; // pixels

Work plain(double size) {
  return filled(size, object_of(Mesh{}).material);
}
Work empty(double size) {
  Work work = plain(size);
  work.scene.objects.clear();
  work.layers = 0;
  return work;
}
/// 16,384 pixels long.
Work one_row(double size) {
  Work work = plain(size);
  work.options.width = 16384, work.options.height = static_cast<int>(std::lround(size / 16384));
  return work;
}
Work one_column(double size) {
  Work work = plain(size);
  work.options.width = static_cast<int>(std::lround(size / 16384)), work.options.height = 16384;
  return work;
}
Work a_crop(double size) {
  Work work = plain(64 * first);
  const int side = static_cast<int>(std::lround(std::sqrt(size)));
  work.options.crop = PixelRect{work.options.width / 2, work.options.height / 2, side, side};
  return work;
}
Work small_tiles(double size) {
  Work work = plain(size);
  work.options.tile_size = 8;
  return work;
}

template <int samples>
Work several_samples(double size) {
  Work work = plain(size);
  work.options.samples = samples;
  return work;
}
/// As many triangles as a quarter of the pixels.
template <int samples>
Work small_triangles(double size) {
  Work work = several_samples<samples>(size);
  work.scene.objects[0] = object_of(wall(size / 4));
  return work;
}

Work all_aovs(double size) {
  Work work = plain(size);
  for (int i = 0; i < static_cast<int>(Aov::count_); ++i) work.options.aovs.push_back(static_cast<Aov>(i));
  return work;
}
Work aovs_of_samples(double size) {
  Work work = all_aovs(size);
  work.options.samples = 4, work.options.aov_filter = AovFilter::resolve;
  return work;
}
Work srgb_levels(double size) {
  Work work = plain(size);
  work.options.transfer = Transfer::srgb;
  return work;
}
Work floats_too(double size) {
  Work work = plain(size);
  work.options.want_radiance = work.options.want_radiance_double = true;
  return work;
}

constexpr std::string_view many_images = "ten images, 17 numbers a pixel, in double";

constexpr Family families[] = {
    {"a wall of few triangles", Grows::pixels, first, plain},
    {"nothing but the background", Grows::pixels, 4 * first, empty},
    {"images 16,384 pixels wide", Grows::pixels, first, one_row},
    {"images 16,384 pixels high", Grows::pixels, first, one_column},
    {"a part of an image 4,096 pixels wide", Grows::pixels, first, a_crop},
    {"tiles of 8 x 8", Grows::pixels, first, small_tiles},
    {"4 samples", Grows::pixels, first, several_samples<4>},
    {"16 samples", Grows::pixels, first, several_samples<16>},
    {"4 samples of small triangles", Grows::pixels, first, small_triangles<4>},
    {"16 samples of small triangles", Grows::pixels, first, small_triangles<16>},
    {"all AOVs", Grows::pixels, first, all_aovs, many_images},
    {"all AOVs of 4 samples", Grows::pixels, first, aovs_of_samples, many_images},
    {"levels by the curve of sRGB", Grows::pixels, first, srgb_levels},
    {"images of floats and doubles too", Grows::pixels, first, floats_too},
};

} // namespace

std::span<const Family> pixel_families() {
  return families;
}

} // namespace refraster::cliffs
