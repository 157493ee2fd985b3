#include "raster/shade/shade_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refraster {

namespace {

using T = DoublePrecision::Number;
using Triangle = AttributeSetup<double>;

} // namespace

void write_aovs(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs,
                const TileAttributes<double>* shaded, std::span<Image<float>> images) {
  const std::vector<Aov>& aovs = context.options.aovs;
  if (aovs.empty()) return;
  const PixelRect& tile = visible.tile;
  const auto pixel = [&](Image<float>& image, int x, int y) {
    return image.at(tile.x - context.region.x + x, tile.y - context.region.y + y);
  };
  const bool wants_surface = std::any_of(aovs.begin(), aovs.end(), [](Aov aov) {
    return aov == Aov::normal || aov == Aov::position || aov == Aov::albedo;
  });
  for (std::size_t i = 0; i < aovs.size(); ++i)
    for (int y = 0; aovs[i] == Aov::depth && y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) pixel(images[i], x, y)[0] = 1;

  // A pixel shows the triangle of its first fragment, evaluated at the pixel's centre. With one sample a pixel there
  // are no others.
  std::vector<FragmentRun> first_runs;
  TileAttributes<double> own;
  if (!shaded) {
    for (const FragmentRun& run : runs)
      if (first_runs.empty() || first_runs.back().x != run.x || first_runs.back().y != run.y) first_runs.push_back(run);
    own.collect(context, visible.triangles, first_runs);
    runs = first_runs;
  }
  const TileAttributes<double>& setups = shaded ? *shaded : own;
  std::size_t fragments = 0;
  for (const auto& group : setups.groups()) fragments += group.fragments;
  std::vector<std::array<int, 2>> position(fragments); // of each, in the tile
  for (const FragmentRun& run : runs)
    for (int i = 0; i < run.length; ++i)
      position[run.first_fragment + static_cast<std::size_t>(i)] = {run.x + i, run.y};

  UserShading<T> user_shading;
  UndefinedCounts uncounted; // shading has counted these
  for (const auto& group : setups.groups()) {
    const Material& material = *group.material;
    for_each_packet<T>(setups, group, tile, [&](const Packet<T>& packet, std::uint32_t first) {
      const UndefinedTally<T> tally(uncounted, first_lanes<double, NumberTraits<T>::lanes>(packet.count));
      const PacketData<T, Triangles::many> data(packet);
      PacketSurface<T> surface;
      if (wants_surface) surface = packet_surface(context, material, data, tally);
      for (std::size_t i = 0; i < aovs.size(); ++i) {
        // Pixel centres beside a triangle may make any number of it; and a finite double may lie beyond a float.
        constexpr double largest = NumberTraits<float>::largest;
        const auto put = [&](int channel, auto&& value) {
          for (int lane = 0; lane < packet.count; ++lane) {
            const auto [x, y] = position[first + static_cast<std::size_t>(lane)];
            const auto v = static_cast<double>(value(lane));
            pixel(images[i], x, y)[channel] = std::isnan(v) ? 0 : static_cast<float>(std::clamp(v, -largest, largest));
          }
        };
        const auto triangle = [&](int lane) -> const Triangle& { return packet.triangle(lane); };
        const auto put3 = [&](const Vec3<T>& v) {
          for (int c = 0; c < 3; ++c) put(c, [&](int lane) { return v[c][lane]; });
        };
        switch (aovs[i]) {
        case Aov::depth:
          put(0, [&](int lane) {
            const auto [x, y] = position[first + static_cast<std::size_t>(lane)];
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
          put3(surface.normal);
          break;
        case Aov::position:
          put3(surface.position);
          break;
        case Aov::albedo:
          if (material.user_function) put3(user_shading.albedo(*material.user_function, surface));
          else
            put3(std::visit([&](const auto& function) { return albedo<T>(function, surface.texture); },
                            material.fragment_function));
          break;
        case Aov::count_:
          break;
        }
      }
    });
  }
}

} // namespace refraster
