// Texture filters on an image of 1024 x 1024, about a texel a pixel.

#include "bench/micro/micro.h"
#include "shading/texture.h"

#include <memory>

namespace refraster::micro {
namespace {

constexpr int side = 1024;

std::shared_ptr<const Texture> noise() {
  auto texture = std::make_shared<Texture>();
  TextureLevel level{side, side, {}};
  std::mt19937_64 random(5);
  for (std::size_t i = 0; i < std::size_t{3} * side * side; ++i)
    level.rgb.push_back(static_cast<float>(random() % 256));
  texture->levels.push_back(std::move(level));
  build_mip_levels(*texture);
  return texture;
}

template <class F>
struct Places {
  Values<F> u, v;
};

/// 256 x 256 pixels row by row, turned by 30 degrees.
template <class F>
Places<F> walk() {
  Places<F> places;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      places.u.push_back(static_cast<F>((0.866 * x - 0.5 * y) / side));
      places.v.push_back(static_cast<F>((0.5 * x + 0.866 * y) / side));
    }
  return places;
}

template <class T>
void add_filters(const std::string& number, const char* order, const Places<RealOf<T>>& places,
                 const std::shared_ptr<const Texture>& texture) {
  for (const auto& [filter, name] : EnumNames<TextureFilter>::names)
    add("texture/" + std::string(name) + "/" + order + "/" + number, many, [texture, places, chosen = filter] {
      const Vec2<T> right(as<T>(1.3 * 0.866 / side), as<T>(1.3 * 0.5 / side)); // between level 0 and level 1
      const Vec2<T> down(as<T>(-1.3 * 0.5 / side), as<T>(1.3 * 0.866 / side));
      for_each_packet_of<T>(many, [&](std::size_t i) {
        return sample(*texture, chosen, Vec2<T>(loaded<T>(&places.u[i]), loaded<T>(&places.v[i])), right, down);
      });
    });
}

} // namespace

void add_textures() {
  for_each_number([texture = noise()]<class T>(const std::string& number) {
    using F = RealOf<T>;
    add_filters<T>(number, "walk", walk<F>(), texture);
    add_filters<T>(number, "random", {random_values<F>(many, 0, 1, 1), random_values<F>(many, 0, 1, 2)}, texture);
  });
}

} // namespace refraster::micro
