#include "tests/support/invariants.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <variant>

namespace refraster::test {
namespace {

template <class Values>
bool all_finite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](auto value) { return std::isfinite(value); });
}
bool finite(const Double3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
bool at_least_0(const Double3& a) {
  return finite(a) && a.x >= 0 && a.y >= 0 && a.z >= 0;
}
bool is_zero(const Double3& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

std::string fault_of(const Camera& camera) {
  if (!finite(camera.position) || !finite(camera.target) || !finite(camera.up)) return "camera: not finite";
  if (camera.position == camera.target || is_zero(camera.up)) return "camera: no direction";
  if (!(camera.fov_y_degrees > 0 && camera.fov_y_degrees < 180)) return "camera: field of view";
  if (!(0 < camera.near && camera.near < camera.far && std::isfinite(camera.far))) return "camera: depth range";
  return "";
}

/// Each parameter within the range that the fragment function declares.
template <class Function>
std::string function_fault(const Function& function) {
  std::string fault;
  const auto judge = [&](std::string_view name, const auto& value, const Range& range, std::string_view) {
    using Value = std::decay_t<decltype(value)>;
    bool good = true;
    if constexpr (std::is_same_v<Value, double>) good = range.contains(value);
    if constexpr (std::is_same_v<Value, Double3>)
      good = range.contains(value.x) && range.contains(value.y) && range.contains(value.z);
    if (!good && fault.empty()) fault = "material: " + std::string(name);
  };
  Function::fields(function, judge);
  if constexpr (requires { function.table; })
    if (!function.table) return "material: no table";
  return fault;
}

bool within(const Image<float>& image, double low, double high) {
  return std::all_of(image.values.begin(), image.values.end(),
                     [&](float v) { return low <= static_cast<double>(v) && static_cast<double>(v) <= high; });
}

template <class Value>
bool is_shaped(const Image<Value>& image, const PixelRect& region, int channels) {
  return image.width == region.width && image.height == region.height && image.channels == channels &&
         image.values.size() == static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height) *
                                    static_cast<std::size_t>(channels);
}

template <class Value>
bool same_bits(const Image<Value>& a, const Image<Value>& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels && a.values.size() == b.values.size() &&
         (a.values.empty() || std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(Value)) == 0);
}

} // namespace

std::string fault_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return "mesh: no triangle";
  const std::size_t count = mesh.positions.size();
  if (mesh.normals.size() != count) return "mesh: normals";
  if (mesh.uvs.size() > count) return "mesh: uvs";
  if (mesh.colours.size() > count) return "mesh: colours";
  if (mesh.tangents.size() > count) return "mesh: tangents";
  for (std::size_t i = 0; i < count; ++i) {
    const Float3 p = mesh.positions[i], n = mesh.normals[i];
    const Float2 uv = i < mesh.uvs.size() ? mesh.uvs[i] : Float2(0.0f);
    const Float3 c = i < mesh.colours.size() ? mesh.colours[i] : Float3(1.0f);
    const Float4 t = i < mesh.tangents.size() ? mesh.tangents[i] : Float4(0.0f);
    if (!all_finite(std::array{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y, c.x, c.y, c.z, t.x, t.y, t.z, t.w}))
      return "mesh: a vertex is not finite";
  }
  std::vector<char> used(count);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) {
      if (vertex >= count) return "mesh: an index out of range";
      used[vertex] = 1;
    }
  return std::find(used.begin(), used.end(), 0) == used.end() ? "" : "mesh: a vertex of no triangle";
}

std::string fault_of(const Texture& texture) {
  if (texture.full_scale != 255 && texture.full_scale != 65535 && texture.full_scale != 1) return "texture: full scale";
  if (texture.levels.empty()) return "texture: no level";
  for (std::size_t k = 0; k < texture.levels.size(); ++k) {
    const TextureLevel& level = texture.levels[k];
    if (level.width < 1 || level.height < 1) return "texture: size";
    if (k > 0 && (level.width != std::max(1, texture.levels[k - 1].width / 2) ||
                  level.height != std::max(1, texture.levels[k - 1].height / 2)))
      return "texture: levels";
    if (level.rgb.size() != 3 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height))
      return "texture: values";
    for (std::size_t i = 0; i < level.rgb.size(); ++i)
      if (!(level.rgb[i] >= 0 && static_cast<double>(level.rgb[i]) <= texture.full_scale)) return "texture: a value";
  }
  const TextureLevel& last = texture.levels.back();
  return texture.levels.size() == 1 || (last.width == 1 && last.height == 1) ? "" : "texture: levels end early";
}

std::string fault_of(const TextureMap& map) {
  if (std::string fault = fault_of(*map.texture); !fault.empty()) return fault;
  if (!std::isfinite(map.scale.x + map.scale.y) || !std::isfinite(map.offset.x + map.offset.y)) return "texture: place";
  const TextureLevel& level = map.texture->levels.back();
  const bool has_levels = level.width == 1 && level.height == 1;
  return map.filter != TextureFilter::trilinear || has_levels ? "" : "texture: no mip chain";
}

std::string fault_of(const Scene& scene) {
  if (std::string fault = fault_of(scene.camera); !fault.empty()) return fault;
  if (!at_least_0(scene.background)) return "background";
  for (const PointLight& light : scene.point_lights)
    if (!finite(light.position) || !at_least_0(light.radiance) ||
        !at_least_0({light.constant, light.linear, light.quadratic}))
      return "point light";
  for (const DirectionLight& light : scene.direction_lights)
    if (!finite(light.direction) || is_zero(light.direction) || !at_least_0(light.radiance)) return "direction light";
  const Mesh* last_mesh = nullptr;
  for (const Object& object : scene.objects) {
    if (!object.mesh) return "object: no mesh";
    if (!finite(object.position) || !finite(object.rotate_degrees) || !finite(object.scale))
      return "object: transformation";
    if (object.mesh.get() != last_mesh)
      if (std::string fault = fault_of(*object.mesh); !fault.empty()) return fault;
    last_mesh = object.mesh.get();
    const auto judge = [](const auto& function) { return function_fault(function); };
    if (std::string fault = std::visit(judge, object.material.fragment_function); !fault.empty()) return fault;
    if (!at_least_0(object.material.emissive)) return "material: emissive";
    if (!std::isfinite(object.material.normal_scale) || !std::isfinite(object.material.bump_scale))
      return "material: scale of a map";
    std::string of_textures;
    for_each_texture(object.material, [&](const TextureMap& map) {
      if (of_textures.empty()) of_textures = fault_of(map);
    });
    if (!of_textures.empty()) return of_textures;
  }
  return "";
}

std::string fault_of(const Frame& frame, const Scene& scene, const RenderOptions& options) {
  const PixelRect region = options.crop.value_or(PixelRect{0, 0, options.width, options.height});
  if (options.want_rgb8 && !is_shaped(frame.rgb8, region, 3)) return "levels: shape";
  if (options.want_radiance && !is_shaped(frame.radiance, region, 3)) return "radiance: shape";
  for (const float value : frame.radiance.values)
    if (!std::isfinite(value) || value < 0) return "radiance: " + std::to_string(value);
  if (frame.aovs.size() != options.aovs.size()) return "aovs: count";
  std::size_t max_triangles = 0;
  std::uint64_t triangles = 0;
  for (const Object& object : scene.objects) {
    max_triangles = std::max(max_triangles, object.mesh->triangles.size());
    triangles += object.mesh->triangles.size();
  }
  for (std::size_t i = 0; i < options.aovs.size(); ++i) {
    const Aov aov = options.aovs[i];
    const std::string name(kind_of(aov).name);
    if (!is_shaped(frame.aovs[i], region, kind_of(aov).channels)) return name + ": shape";
    if (!all_finite(frame.aovs[i].values)) return name + ": not finite";
    if (aov == Aov::depth && !within(frame.aovs[i], 0, 1)) return "depth: outside [0, 1]";
    if (aov == Aov::alpha && !within(frame.aovs[i], 0, 1)) return "alpha: outside [0, 1]";
    if (aov == Aov::triangle && !within(frame.aovs[i], 0, static_cast<double>(max_triangles))) return "triangle";
    if (aov == Aov::object && !within(frame.aovs[i], 0, static_cast<double>(scene.objects.size()))) return "object";
  }
  const FrameCounts& c = frame.counts;
  if (c.triangles != triangles) return "counts: triangles";
  if (c.not_finite + c.outside + c.degenerate + c.culled + c.between_samples + c.drawn != c.triangles)
    return "counts: each triangle has one fate";
  if (c.clipped > c.drawn) return "counts: clipped";
  if (c.pixels != static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height))
    return "counts: pixels";
  if (c.shaded > c.pixels || c.fragments < c.shaded || c.lane_slots < c.fragments ||
      c.fragments > c.shaded * static_cast<std::uint64_t>(options.samples))
    return "counts: shaded";
  return "";
}

std::vector<Aov> all_aovs() {
  std::vector<Aov> all;
  for (int i = 0; i < static_cast<int>(Aov::count_); ++i) all.push_back(static_cast<Aov>(i));
  return all;
}

std::string difference(const Frame& a, const Frame& b) {
  if (!same_bits(a.rgb8, b.rgb8)) return "levels";
  if (!same_bits(a.radiance, b.radiance)) return "radiance";
  if (!same_bits(a.radiance_double, b.radiance_double)) return "radiance in double";
  if (a.aovs.size() != b.aovs.size()) return "aovs";
  for (std::size_t i = 0; i < a.aovs.size(); ++i)
    if (!same_bits(a.aovs[i], b.aovs[i])) return "aov " + std::to_string(i);
  const FrameCounts &x = a.counts, &y = b.counts;
  const auto drawn = [](const FrameCounts& c) {
    return std::array{c.triangles, c.not_finite, c.outside, c.degenerate, c.culled,   c.between_samples,
                      c.clipped,   c.drawn,      c.pixels,  c.shaded,     c.fragments};
  };
  if (drawn(x) != drawn(y)) return "counts";
  return x.undefined.counts == y.undefined.counts ? "" : "counts of what is undefined";
}

} // namespace refraster::test
