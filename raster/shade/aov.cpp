#include "raster/shade/shade_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace refraster {

namespace {

using T = DoublePrecision::Number;
using Triangle = AttributeSetup<double>;

// The colour a surface would be called by: what it reflects of white light from the front.
template <class SomeFunction>
Rgb<T> albedo(const SomeFunction& function, const PacketSurface<T>& surface) {
  if constexpr (requires { function.kd; }) {
    return as<T>(function.kd) * surface.texture;
  } else {
    // f at normal incidence and exitance, times pi: for a Lambertian surface, its reflectance.
    const Vec3<T> up(T(0), T(0), T(1));
    const Fragment<T> at{up, up, up, Rgb<T>(T(1)), nullptr};
    return function(at, Incident<T>{up, Rgb<T>(T(std::numbers::pi))});
  }
}

} // namespace

void write_aov(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs, Aov aov,
               Image<float>& image) {
  const PixelRect& tile = visible.tile;
  const auto pixel = [&](int x, int y) {
    return image.at(tile.x - context.region.x + x, tile.y - context.region.y + y);
  };
  if (aov == Aov::depth)
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) pixel(x, y)[0] = 1;

  // A pixel shows the triangle of its first fragment, evaluated at the pixel's centre.
  std::vector<FragmentRun> shown;
  for (const FragmentRun& run : runs)
    if (shown.empty() || shown.back().x != run.x || shown.back().y != run.y) shown.push_back(run);

  TileAttributes<double> setups;
  std::vector<std::array<int, 2>> place(setups.collect(context, visible.triangles, shown));
  for (const FragmentRun& run : shown)
    for (int i = 0; i < run.length; ++i) place[run.first_fragment + static_cast<std::size_t>(i)] = {run.x + i, run.y};

  UndefinedCounts uncounted; // shading has counted these
  for (const auto& group : setups.groups()) {
    const Material& material = context.scene.objects[group.object].material;
    for_each_packet<T>(setups, group, tile, [&](const Packet<T>& packet, std::uint32_t first) {
      const UndefinedTally<T> tally(uncounted, first_lanes<double, NumberTraits<T>::lanes>(packet.count));
      const PacketData<T, Triangles::many> data(packet);
      const auto surface = [&] { return packet_surface(context, material, data, tally); };
      // Pixel centres beside a triangle may make any number of it; and a finite double may lie beyond a float.
      constexpr double largest = std::numeric_limits<float>::max();
      const auto put = [&](int channel, auto&& value) {
        for (int lane = 0; lane < packet.count; ++lane) {
          const auto [x, y] = place[first + static_cast<std::size_t>(lane)];
          const auto v = static_cast<double>(value(lane));
          pixel(x, y)[channel] = std::isnan(v) ? 0 : static_cast<float>(std::clamp(v, -largest, largest));
        }
      };
      const auto triangle = [&](int lane) -> const Triangle& { return packet.triangle(lane); };
      const auto put3 = [&](const Vec3<T>& v) {
        for (int c = 0; c < 3; ++c) put(c, [&](int lane) { return v[c][lane]; });
      };
      switch (aov) {
      case Aov::depth:
        put(0, [&](int lane) {
          const auto [x, y] = place[first + static_cast<std::size_t>(lane)];
          int s = 0; // the first fragment of a pixel is that of its first covered sample
          while (visible.visibility.nearest(s, x, y) == nothing) ++s;
          return visible.visibility.depth(s, x, y) * 0.5 + 0.5;
        });
        break;
      case Aov::triangle:
        put(0, [&](int lane) {
          return triangle(lane).number - context.geometry.first_triangle[triangle(lane).object] + 1;
        });
        break;
      case Aov::object:
        put(0, [&](int lane) { return triangle(lane).object + 1; });
        break;
      case Aov::uv: {
        const PacketBarycentrics<T> at = barycentrics<Derivatives::no>(data);
        for (int c = 0; c < 2; ++c) {
          const T fraction = interpolated_uv(data, c, at);
          put(c, [&](int lane) {
            return fraction[lane] + whole_repeats(context, triangle(lane).number)[static_cast<std::size_t>(c)];
          });
        }
        break;
      }
      case Aov::normal:
        put3(surface().normal);
        break;
      case Aov::position:
        put3(surface().position);
        break;
      case Aov::albedo:
        put3(std::visit([&](const auto& function) { return albedo(function, surface()); }, material.fragment_function));
        break;
      case Aov::count_:
        break;
      }
    });
  }
}

} // namespace refraster
