#include "tests/support/gl/seeded_scene_faults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace refraster {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// With a camera whose image is `taller` times as high in the plane at distance 1: negative turns it round.
Scene with_half_height(Scene scene, double half_height) {
  scene.camera.fov_y_degrees = 2 * std::atan(std::abs(half_height)) * degrees;
  if (half_height < 0) scene.camera.up = -scene.camera.up;
  return scene;
}

double half_height(const Scene& scene) {
  return std::tan(scene.camera.fov_y_degrees / 2 / degrees);
}

Scene in_radians(Scene scene, const FaultImageSize&) {
  const double angle = scene.camera.fov_y_degrees / 2;
  return with_half_height(std::move(scene), std::tan(angle));
}

Scene horizontal(Scene scene, const FaultImageSize& size) {
  const double half = half_height(scene) * size.height / size.width;
  return with_half_height(std::move(scene), half);
}

Scene half_angle(Scene scene, const FaultImageSize&) {
  scene.camera.fov_y_degrees /= 2;
  return scene;
}

Scene near_far_off(Scene scene, const FaultImageSize&) {
  scene.camera.near *= 10;
  return scene;
}

Scene far_too_near(Scene scene, const FaultImageSize&) {
  scene.camera.far /= 10;
  return scene;
}

/// Of equal depths the last is seen.
Scene last_first(Scene scene, const FaultImageSize&) {
  std::reverse(scene.objects.begin(), scene.objects.end());
  for (Object& object : scene.objects) {
    Mesh mesh = *object.mesh;
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  return scene;
}

Scene without_culling(Scene scene, const FaultImageSize&) {
  for (Object& object : scene.objects) object.cull = Cull::none;
  return scene;
}

Scene without_last_object(Scene scene, const FaultImageSize&) {
  if (!scene.objects.empty()) scene.objects.pop_back();
  return scene;
}

Scene without_last_light(Scene scene, const FaultImageSize&) {
  if (!scene.direction_lights.empty()) scene.direction_lights.pop_back();
  else if (!scene.point_lights.empty()) scene.point_lights.pop_back();
  return scene;
}

Scene without_attenuation(Scene scene, const FaultImageSize&) {
  for (PointLight& light : scene.point_lights) light.constant = 1, light.linear = light.quadratic = 0;
  return scene;
}

Scene mip_mapped(Scene scene, const FaultImageSize&) {
  for (Object& object : scene.objects) {
    if (!object.material.diffuse_map.texture) continue;
    Texture texture = *object.material.diffuse_map.texture;
    if (texture.levels.size() == 1) build_mip_levels(texture);
    object.material.diffuse_map.texture = std::make_shared<const Texture>(std::move(texture));
    object.material.diffuse_map.filter = TextureFilter::trilinear;
  }
  return scene;
}

/// A table of another material: a mirror's is narrower.
Scene with_other_table(Scene scene, const FaultImageSize&) {
  for (Object& object : scene.objects) {
    Merl* const merl = std::get_if<Merl>(&object.material.fragment_function);
    if (!merl) continue;
    PaddedVector<double> rgb(3 * MerlTable::samples);
    std::size_t at = 0;
    for (int h = 0; h < MerlTable::theta_h_bins; ++h)
      for (int d = 0; d < MerlTable::theta_d_bins; ++d)
        for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
          const Rgb<double> f = merl->table->sample(std::min(h + h / 8 + 1, MerlTable::theta_h_bins - 1), d, p);
          for (int c = 0; c < 3; ++c) rgb[at++] = f[c] < 0 ? f[c] : f[c] * (1 + 0.1 * std::sin(0.3 * h + 0.1 * d));
        }
    merl->table = std::make_shared<const MerlTable>(std::move(rgb));
  }
  return scene;
}

/// value(x, y, c) for all of an image as large as `right`.
template <class Value>
Image<float> image_of(const Image<float>& right, const Value& value) {
  Image<float> result(right.width, right.height, right.channels);
  for (int y = 0; y < right.height; ++y)
    for (int x = 0; x < right.width; ++x)
      for (int c = 0; c < right.channels; ++c) result.at(x, y)[c] = static_cast<float>(value(x, y, c));
  return result;
}

/// Each value by itself.
template <class Map>
Image<float> mapped(const Image<float>& right, const Map& map) {
  return image_of(right, [&](int x, int y, int c) { return map(static_cast<double>(right.at(x, y)[c])); });
}

/// From the nearest place in the image.
float from(const Image<float>& right, int x, int y, int c) {
  return right.at(std::clamp(x, 0, right.width - 1), std::clamp(y, 0, right.height - 1))[c];
}

Image<float> srgb_added(const Image<float>& right) {
  return mapped(right, [](double v) {
    const double x = std::clamp(v, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  });
}
Image<float> srgb_removed(const Image<float>& right) {
  return mapped(right, [](double v) {
    const double x = std::clamp(v, 0.0, 1.0);
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  });
}
Image<float> upside_down(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) { return from(right, x, right.height - 1 - y, c); });
}
Image<float> mirrored(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) { return from(right, right.width - 1 - x, y, c); });
}
Image<float> red_blue(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) { return from(right, x, y, 2 - c); });
}
Image<float> shifted(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) { return from(right, x - 3, y + 2, c); });
}
Image<float> video_range(const Image<float>& right) {
  return mapped(right, [](double v) { return (16 + 219 * std::clamp(v, 0.0, 1.0)) / 255; });
}
Image<float> video_range_removed(const Image<float>& right) {
  return mapped(right, [](double v) { return (255 * v - 16) / 219; });
}
Image<float> darker(const Image<float>& right) {
  return mapped(right, [](double v) { return 0.7 * v; });
}
Image<float> enlarged(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) { return from(right, x / 2 * 2, y / 2 * 2, c); });
}
Image<float> blurred(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) {
    float sum = 0;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) sum += from(right, x + i, y + j, c);
    return sum / 9;
  });
}
Image<float> noisy(const Image<float>& right) {
  return image_of(right, [&](int x, int y, int c) {
    const double seed = std::sin(12.9898 * x + 78.233 * y + 37.719 * c) * 43758.5453;
    return static_cast<double>(right.at(x, y)[c]) + 0.06 * (seed - std::floor(seed) - 0.5);
  });
}

} // namespace

std::vector<SeededFault> seeded_scene_faults() {
  return {
      {"the field of view in radians", {"fov_in_radians"}, {}, in_radians},
      {"the field of view is the horizontal one", {"fov_horizontal"}, {}, horizontal},
      {"half the field of view", {"fov_half"}, {}, half_angle},
      {"the near plane too far", {"near_plane_farther"}, {}, near_far_off},
      {"the far plane too near", {"far_plane_nearer"}, {}, far_too_near},
      {"the depth test LEQUAL", {"depth_lequal"}, {}, last_first},
      {"nothing culled", {"culling_off"}, {}, without_culling},
      {"an object missing", {"object_missing"}, {}, without_last_object},
      {"a light missing", {"light_missing"}, {}, without_last_light},
      {"lights without attenuation", {"attenuation_missing"}, {}, without_attenuation},
      {"a mip chain where none is asked for", {"texture_trilinear"}, {}, mip_mapped},
      {"another material's table", {}, {}, with_other_table},
  };
}

std::vector<SeededFault> seeded_image_faults() {
  return {
      {"the sRGB curve on the image", {"srgb_curve_added", "gamma_encoded"}, {}, nullptr, srgb_added},
      {"the inverse sRGB curve on the image", {"srgb_curve_missing", "gamma_decoded"}, {}, nullptr, srgb_removed},
      {"the image upside down", {"upside_down"}, {}, nullptr, upside_down},
      {"the image mirrored", {"mirrored"}, {}, nullptr, mirrored},
      {"the image's red and blue exchanged", {"red_blue_exchanged"}, {}, nullptr, red_blue},
      {"the image shifted", {"shifted"}, {}, nullptr, shifted},
      {"the image in video range", {"video_range"}, {}, nullptr, video_range},
      {"the image stretched from video range", {"video_range_removed"}, {}, nullptr, video_range_removed},
      {"the image darker", {"scaled"}, {}, nullptr, darker},
      {"the image of every second pixel, enlarged", {"every_second_pixel"}, {}, nullptr, enlarged},
      {"the image blurred", {}, {}, nullptr, blurred},
      {"noise on the image", {}, {}, nullptr, noisy},
  };
}

} // namespace refraster
