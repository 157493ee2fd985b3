#include "raster/shade_tile.h"

#include <numbers>

namespace refraster {

namespace {

using T = DoubleRung::Number;
using Triangle = SurfaceTriangle<double>;

// The colour a surface would be called by: what it reflects of white light from the front.
template <class Model>
Rgb<T> albedo(const Model& model, const PacketSurface<T>& surface) {
  if constexpr (requires { model.kd; }) {
    return as<T>(model.kd) * surface.texture;
  } else {
    // f at normal incidence and exitance, times pi: for a Lambertian surface, its reflectance.
    const Vec3<T> up(T(0), T(0), T(1));
    const Fragment<T> at{up, up, up, Rgb<T>(T(1)), nullptr};
    return model(at, Incident<T>{up, Rgb<T>(T(std::numbers::pi))});
  }
}

} // namespace

void write_aov(const FrameContext& context, const VisibleTile& visible, std::span<const TileFragment> fragments,
               Aov aov, Image<float>& image) {
  const Crop& tile = visible.tile;
  const auto pixel = [&](int x, int y) {
    return image.at(tile.x - context.region.x + x, tile.y - context.region.y + y);
  };
  if (aov == Aov::depth)
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) pixel(x, y)[0] = 1;

  // A pixel shows the triangle of its first fragment, evaluated at the pixel's centre.
  std::vector<TileFragment> shown;
  for (const TileFragment& fragment : fragments)
    if (shown.empty() || shown.back().x != fragment.x || shown.back().y != fragment.y) shown.push_back(fragment);

  TileSurfaces<double> surfaces;
  surfaces.collect(context, visible, shown);
  UndefinedCounts uncounted; // shading has counted these
  for (const auto& group : surfaces.groups()) {
    const Material& material = context.scene.objects[group.object].material;
    for_each_packet<T>(
        surfaces, tile, shown, group.fragments, [&](const auto& packet, std::span<const std::uint32_t> indices) {
          const UndefinedTally<T> tally(uncounted, first_lanes<double, NumberTraits<T>::lanes>(packet.count));
          const auto put = [&](int channel, auto&& value) {
            for (std::size_t lane = 0; lane < indices.size(); ++lane) {
              const TileFragment& fragment = shown[indices[lane]];
              pixel(fragment.x, fragment.y)[channel] = static_cast<float>(value(lane));
            }
          };
          const auto put3 = [&](const Vec3<T>& v) {
            for (int c = 0; c < 3; ++c) put(c, [&](std::size_t lane) { return v[c][static_cast<int>(lane)]; });
          };
          switch (aov) {
          case Aov::depth:
            for (std::size_t lane = 0; lane < indices.size(); ++lane) {
              const TileFragment& f = shown[indices[lane]];
              pixel(f.x, f.y)[0] = static_cast<float>(visible.visibility.depth(0, f.x, f.y) * 0.5 + 0.5);
            }
            break;
          case Aov::triangle:
            put(0, [&](std::size_t lane) {
              const Triangle& t = *packet.triangle[lane];
              return t.number - context.geometry.first_triangle[t.object] + 1;
            });
            break;
          case Aov::object:
            put(0, [&](std::size_t lane) { return packet.triangle[lane]->object + 1; });
            break;
          case Aov::uv: {
            const PacketBarycentrics<T> at = barycentrics(packet, Derivatives::no);
            for (std::size_t c = 0; c < 2; ++c) {
              const T fraction = interpolate(
                  packet, at.at, [](const Triangle& t) -> const auto& { return t.uv; }, c);
              put(static_cast<int>(c), [&](std::size_t lane) {
                return fraction[static_cast<int>(lane)] + packet.triangle[lane]->uv_whole[c];
              });
            }
            break;
          }
          case Aov::normal:
            put3(packet_surface(context.scene, context.geometry, material, packet, tally).normal);
            break;
          case Aov::position:
            put3(packet_surface(context.scene, context.geometry, material, packet, tally).position);
            break;
          case Aov::albedo: {
            const PacketSurface<T> surface = packet_surface(context.scene, context.geometry, material, packet, tally);
            put3(std::visit([&](const auto& model) { return albedo(model, surface); }, material.model));
            break;
          }
          case Aov::count_:
            break;
          }
        });
  }
}

} // namespace refraster
