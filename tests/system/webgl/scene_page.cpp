// Writes a page that draws a scene with WebGL 2 and puts the pixels into its text:
//     scene_page SCENE WIDTHxHEIGHT TEMPLATE.html OUT.html

#include <refraster/files.h>

#include "gl/draw/uniforms.h"
#include "gl/glsl/own_glsl.h"
#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/json/json_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

namespace {

using namespace refraster;

std::string base64(std::span<const std::byte> bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? std::to_integer<unsigned>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <class Item>
std::string packed(const std::vector<Item>& items) {
  return base64(std::as_bytes(std::span(items)));
}

void write_uniforms(JsonWriter& json, const UniformValues& values) {
  json.object("uniforms", [&] {
    for (const auto& [name, value] : values) {
      json.key(name);
      std::vector<double> numbers;
      const char* setter = "";
      std::visit(
          [&](const auto& x) {
            using X = std::decay_t<decltype(x)>;
            const auto append = [&](const float* from, std::size_t count) { numbers.assign(from, from + count); };
            if constexpr (std::is_same_v<X, float>) setter = "uniform1fv", append(&x, 1);
            else if constexpr (std::is_same_v<X, int>) setter = "uniform1iv", numbers = {static_cast<double>(x)};
            else if constexpr (std::is_same_v<X, Float2>) setter = "uniform2fv", append(&x[0], 2);
            else if constexpr (std::is_same_v<X, Float3>) setter = "uniform3fv", append(&x[0], 3);
            else if constexpr (std::is_same_v<X, Float4>) setter = "uniform4fv", append(&x[0], 4);
            else if constexpr (std::is_same_v<X, Float3x3>) setter = "uniformMatrix3fv", append(&x[0][0], 9);
            else setter = "uniformMatrix4fv", append(&x[0][0], 16);
          },
          value);
      json.array([&] {
        json.value(setter);
        json.value(numbers);
      });
    }
  });
}

void write_texture(JsonWriter& json, const Material& material) {
  json.key("texture");
  if (!material.diffuse_map.texture) return json.null();
  json.object([&] {
    json.member("filter", name_of(material.diffuse_map.filter));
    json.array("levels", [&] {
      for (const TextureLevel& level : material.diffuse_map.texture->levels) {
        std::vector<std::uint8_t> values;
        for (const float value : level.rgb)
          values.push_back(static_cast<std::uint8_t>(
              std::lround(static_cast<double>(value) * 255 / material.diffuse_map.texture->full_scale)));
        json.object([&] {
          json.member("width", level.width);
          json.member("height", level.height);
          json.member("rgb", packed(values));
        });
        if (material.diffuse_map.filter != TextureFilter::trilinear) break;
      }
    });
  });
}

void write_table(JsonWriter& json, const Material& material) {
  json.key("table");
  const Merl* const merl = std::get_if<Merl>(&material.fragment_function);
  if (!merl) return json.null();
  const float* const rgb =
      reads_logarithms(merl->lookup) ? merl->table->log_values<float>() : merl->table->values<float>();
  json.value(base64(std::as_bytes(std::span(rgb, 3 * MerlTable::samples))));
}

std::string scene_json(const Scene& scene, int width, int height) {
  const Double4x4 clip = clip_from_world(scene.camera, static_cast<double>(width) / height);
  JsonWriter json;
  json.object([&] {
    json.member("width", width);
    json.member("height", height);
    json.member("background", std::vector<double>{scene.background.x, scene.background.y, scene.background.z});
    json.array("objects", [&] {
      for (const Object& object : scene.objects) {
        if (!object.materials.empty())
          throw std::runtime_error(object.name + ": the page draws no mesh of several materials");
        if (object.material.has_fragment_maps())
          throw std::runtime_error(object.name + ": the page draws no further textures of a material");
        Material material = object.material;
        if (object.mesh->uvs.empty()) material.diffuse_map.texture = nullptr;
        else if (object.mesh->uvs.size() < object.mesh->positions.size())
          throw std::runtime_error(object.name + ": the page draws no mesh of which only some triangles have a vt");
        json.object([&] {
          json.member("vertex", own_vertex_glsl(*object.mesh, GlslDialect::es_300));
          json.member("fragment", own_fragment_glsl(scene, *object.mesh, material, object.two_sided, MerlFilter::manual,
                                                    GlslDialect::es_300));
          json.member("positions", packed(object.mesh->positions));
          json.member("normals", packed(object.mesh->normals));
          json.member("uvs", packed(object.mesh->uvs));
          json.member("colours", packed(object.mesh->colours));
          json.member("triangles", packed(object.mesh->triangles));
          json.member("cull", object.cull == Cull::back);
          UniformValues values = scene_uniforms(scene, light_views(scene, 1));
          values.merge(object_uniforms(object, clip));
          write_uniforms(json, values);
          write_texture(json, material);
          write_table(json, object.material);
          json.member("tableUnit", merl_unit);
        });
      }
    });
  });
  return json.text();
}

} // namespace

int main(int argc, char** argv) try {
  int width = 0, height = 0;
  if (argc != 5 || std::sscanf(argv[2], "%dx%d", &width, &height) != 2) {
    std::fprintf(stderr, "usage: scene_page SCENE WIDTHxHEIGHT TEMPLATE.html OUT.html\n");
    return 2;
  }
  std::string page = read_file(argv[3], "the page", 1 << 20);
  const std::string mark = "@SCENE@";
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) throw std::runtime_error(std::string(argv[3]) + ": no " + mark);
  write_file(argv[4], page.replace(at, mark.size(),
                                   scene_json(read_scene(argv[1], {.outside = Outside::allowed}), width, height)));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
