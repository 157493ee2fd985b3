#pragma once
// Scenes that differ in one number.

#include <refraster/scene.h>

#include <string>
#include <string_view>
#include <vector>

namespace refraster::bench {

/// What grows.
///   triangles  a sheet that fills the image, cut into ever smaller triangles
///   pixels     the built-in sphere in a square image
///   lights     point lights around the built-in sphere
///   overdraw   layers that fill the image, drawn from the farthest to the nearest, and the other way
///   threads    the built-in sphere, drawn by more threads
enum class Growth { triangles, pixels, lights, overdraw, threads };
inline constexpr std::pair<Growth, std::string_view> growth_names[] = {{Growth::triangles, "triangles"},
                                                                       {Growth::pixels, "pixels"},
                                                                       {Growth::lights, "lights"},
                                                                       {Growth::overdraw, "overdraw"},
                                                                       {Growth::threads, "threads"}};
std::string_view name_of(Growth growth);

enum class LayerOrder { back_to_front, front_to_back };
constexpr std::string_view name_of(LayerOrder order) {
  return order == LayerOrder::back_to_front ? "back to front" : "front to back";
}

/// One point of a curve: how to make its scene when its turn has come, since all at once might not fit.
struct ScalingPoint {
  double n = 0; // of what grows
  int width = 0, height = 0, threads = 1;
  LayerOrder order = LayerOrder::back_to_front; // of overdraw
};

struct ImageSize {
  int width = 1280, height = 720;
};

/// The points of a curve in rising order, n at most `most`; at least one. `size` is that of images where pixels do not
/// grow, `threads` the number of threads where threads do not, `cpus` the most threads.
std::vector<ScalingPoint> scaling_points(Growth growth, double most, const ImageSize& size, int threads, int cpus);

Scene scaling_scene(Growth growth, const ScalingPoint& point);

} // namespace refraster::bench
