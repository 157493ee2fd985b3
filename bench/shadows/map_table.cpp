// refraster_shadow_map_table SCENE [SIDE [THREADS]]: what shadow maps cost, and how often they are wrong, as the tables
// of docs/shadow-maps.md. The scene's lights with a shadow are taken one by one, by maps of several sizes, filters and
// biases, in an image of SIDE pixels a side. A pixel is wrong where more than half of the light is missing that exact
// shadows let through, or is there that they keep back. Times are the least of five, of THREADS threads.

#include <refraster/files.h>
#include <refraster/render.h>

#include "raster/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace refraster {
namespace {

struct Images {
  int side = 720, threads = 2;

  Image<double> operator()(const Scene& scene) const {
    RenderOptions options = plain();
    options.want_radiance_double = true;
    return render(scene, options).radiance_double;
  }
  /// Seconds of a frame.
  double seconds(const Scene& scene) const {
    Renderer renderer;
    Frame frame;
    double least = 1e300;
    for (int i = 0; i < 6; ++i) { // of which the first takes memory
      const Stopwatch wall;
      renderer.render(scene, plain(), frame);
      if (i > 0) least = std::min(least, wall.seconds());
    }
    return least;
  }

private:
  RenderOptions plain() const {
    RenderOptions options;
    options.width = options.height = side;
    options.threads = threads;
    return options;
  }
};

/// The scene with none of its lights but one, with that shadow.
template <class Light>
Scene with_light(const Scene& scene, const Light& light, const CastShadow& shadow) {
  Scene result = scene;
  for_each_light_list(result, []<class List>(List& list) { list.clear(); });
  Light copy = light;
  copy.shadow = shadow;
  if constexpr (requires { light.position; }) result.point_lights = {copy};
  else result.direction_lights = {copy};
  return result;
}

struct Wrong {
  std::size_t pixels = 0, dark = 0, lit = 0; // of those that the light shines on

  Wrong(const Image<double>& base, const Image<double>& full, const Image<double>& exact, const Image<double>& map) {
    for (std::size_t i = 1; i < base.values.size(); i += 3) { // green
      const double all = full.values[i] - base.values[i];
      if (!(all > 1e-3)) continue; // facing away
      ++pixels;
      const double off = (map.values[i] - exact.values[i]) / all;
      dark += off<-0.5, lit += off> 0.5;
    }
  }
};

void print(const char* light, const ShadowMap& map, const Wrong& wrong) {
  const auto part = [&](std::size_t count) {
    return 100 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(wrong.pixels, 1));
  };
  std::printf("| %s | %d | %s | %g | %g | %.2f %% | %.2f %% |\n", light, map.size,
              std::string(name_of(map.filter)).c_str(), map.bias, map.slope_bias, part(wrong.dark), part(wrong.lit));
  std::fflush(stdout);
}

template <class Light>
void errors_of(const Scene& scene, const Light& light, const char* name, const Images& images) {
  Scene none = scene;
  for_each_light_list(none, []<class List>(List& list) { list.clear(); });
  const Image<double> base = images(none), full = images(with_light(scene, light, Shadow::none)),
                      exact = images(with_light(scene, light, Shadow::exact));
  const auto row = [&](int size, ShadowFilter filter, double bias, double slope_bias) {
    ShadowMap map = light.shadow.map;
    map.size = size, map.filter = filter, map.bias = bias, map.slope_bias = slope_bias;
    print(name, map, Wrong(base, full, exact, images(with_light(scene, light, map))));
  };
  constexpr std::array<std::array<double, 2>, 6> biases{{{0, 0}, {1, 0}, {0, 1}, {0.5, 1}, {0.5, 3}, {8, 3}}};
  for (const int size : {256, 1024, 4096})
    for (const auto& [bias, slope_bias] : biases) row(size, ShadowFilter::nearest, bias, slope_bias);
  for (const int size : {256, 1024, 4096}) {
    row(size, ShadowFilter::two_by_two, 0.5, 2);
    row(size, ShadowFilter::pcf3, 0.5, 3);
  }
}

template <class Light>
void costs_of(const Scene& scene, const Light& light, const char* name, const Images& images) {
  const double pixels = static_cast<double>(images.side) * images.side;
  const double without = images.seconds(with_light(scene, light, Shadow::none));
  const auto row = [&](const char* kind, const CastShadow& shadow, double fixed) {
    const double more = images.seconds(with_light(scene, light, shadow)) - without;
    std::printf("| %s | %s | %.1f | %.0f |\n", name, kind, fixed * 1e3, (more - fixed) * 1e9 / pixels);
    std::fflush(stdout);
  };
  // What is done once: a frame of one pixel has hardly anything else.
  Images one = images;
  one.side = 1;
  const auto once = [&](const CastShadow& shadow) {
    return one.seconds(with_light(scene, light, shadow)) - one.seconds(with_light(scene, light, Shadow::none));
  };
  row("exact", Shadow::exact, once(Shadow::exact));
  for (const ShadowFilter filter : {ShadowFilter::nearest, ShadowFilter::two_by_two, ShadowFilter::pcf3})
    for (const int size : {512, 2048}) {
      ShadowMap map = light.shadow.map;
      map.size = size, map.filter = filter;
      row(("map " + std::to_string(size) + ", " + std::string(name_of(filter))).c_str(), map, once(map));
    }
}

int run(const std::string& path, const Images& images) {
  const Scene scene = read_scene(path);
  const auto for_each_shadowed = [&](const auto& body) {
    for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
      const std::string name(Light::names.words.substr(0, Light::names.words.size() - 1));
      for (const Light& light : lights)
        if (light.shadow != Shadow::none) body(light, name.c_str());
    });
  };
  std::puts("| light | texels | filter | bias | slope_bias | wrongly dark | wrongly lit |");
  std::puts("|---|---|---|---|---|---|---|");
  for_each_shadowed([&](const auto& light, const char* name) { errors_of(scene, light, name, images); });
  std::puts("\n| light | shadow | once, ms | ns a pixel |");
  std::puts("|---|---|---|---|");
  for_each_shadowed([&](const auto& light, const char* name) { costs_of(scene, light, name, images); });
  return 0;
}

} // namespace
} // namespace refraster

int main(int count, char** words) {
  if (count < 2) {
    std::fputs("usage: refraster_shadow_map_table SCENE [SIDE [THREADS]]\n", stderr);
    return 2;
  }
  refraster::Images images;
  if (count > 2) images.side = std::atoi(words[2]);
  if (count > 3) images.threads = std::atoi(words[3]);
  return refraster::run(words[1], images);
}
