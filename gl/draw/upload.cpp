#include "gl/draw/upload.h"

#include "gl/render_gl.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace refraster {
namespace {

template <class Item>
void fill_buffer(const GlApi& gl, GLenum target, const std::vector<Item>& items) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STATIC_DRAW);
}

template <class Item>
void add_attribute(const GlApi& gl, GLuint place, const std::vector<Item>& items) {
  constexpr int components = Item::length();
  static_assert(sizeof(Item) == components * sizeof(float));
  fill_buffer(gl, GL_ARRAY_BUFFER, items);
  gl.VertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(place);
}

GLuint new_texture(const GlApi& gl, GLenum target) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(target, texture);
  return texture;
}

void set(const GlApi& gl, GLenum target, GLenum parameter, GLenum value) {
  gl.TexParameteri(target, parameter, static_cast<GLint>(value));
}

/// The stored values as integers: exact for level 0, rounded for the levels that were computed.
template <class Integer>
void add_level(const GlApi& gl, GLint level, const TextureLevel& image, GLenum format, GLenum type) {
  std::vector<Integer> values(image.rgb.size());
  std::transform(image.rgb.begin(), image.rgb.end(), values.begin(),
                 [](float value) { return static_cast<Integer>(std::lround(value)); });
  gl.TexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(format), image.width, image.height, 0, GL_RGB, type,
                values.data());
}

void add_float_level(const GlApi& gl, GLint level, const TextureLevel& image, double full_scale) {
  std::vector<float> values(image.rgb.size());
  std::transform(image.rgb.begin(), image.rgb.end(), values.begin(),
                 [&](float value) { return static_cast<float>(static_cast<double>(value) / full_scale); });
  gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGB32F, image.width, image.height, 0, GL_RGB, GL_FLOAT, values.data());
}

} // namespace

GLuint upload_mesh(const GlApi& gl, const Mesh& mesh, unsigned attributes) {
  GLuint vertices = 0;
  gl.GenVertexArrays(1, &vertices);
  gl.BindVertexArray(vertices);
  GLuint place = 0;
  for_each_vertex_attribute([&]<class Value>(const VertexAttribute<Value>& attribute) {
    const GLuint here = place++;
    const std::vector<Value>& values = mesh.*attribute.values;
    if ((attributes & 1u << here) == 0 || values.empty()) return;
    if (values.size() == mesh.positions.size()) return add_attribute(gl, here, values);
    std::vector<Value> all = values;
    all.resize(mesh.positions.size(), Value(attribute.otherwise));
    add_attribute(gl, here, all);
  });
  fill_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
  return vertices;
}

GLuint upload_texture(const GlApi& gl, const TextureMap& map) {
  const Texture& texture = *map.texture;
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  const TextureLevel& image = texture.levels.front();
  if (image.width > most || image.height > most)
    throw NoOpenGl("a texture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                   " texels is too large for this OpenGL, whose textures have at most " + std::to_string(most) +
                   " a side");
  const GLuint name = new_texture(gl, GL_TEXTURE_2D);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::size_t levels = map.filter == TextureFilter::trilinear ? texture.levels.size() : 1;
  for (std::size_t level = 0; level < levels; ++level) {
    const auto place = static_cast<GLint>(level);
    if (texture.full_scale != 255 && texture.full_scale != 65535)
      add_float_level(gl, place, texture.levels[level], texture.full_scale);
    else if (texture.full_scale > 255)
      add_level<GLushort>(gl, place, texture.levels[level], GL_RGB16, GL_UNSIGNED_SHORT);
    else add_level<GLubyte>(gl, place, texture.levels[level], GL_RGB8, GL_UNSIGNED_BYTE);
  }
  const GLenum beyond = map.wrap == TextureWrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  set(gl, GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, beyond);
  set(gl, GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, beyond);
  const GLenum within = map.filter == TextureFilter::nearest ? GL_NEAREST : GL_LINEAR;
  set(gl, GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, within);
  set(gl, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : within);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels) - 1);
  return name;
}

GLuint upload_blank(const GlApi& gl, const Double3& colour) {
  auto blank = std::make_shared<Texture>();
  const bool is_white = colour == Double3(1);
  blank->full_scale = is_white ? 255 : 1; // of others no value is to be rounded
  const Float3 values(colour * blank->full_scale);
  blank->levels.push_back({1, 1, {values.x, values.y, values.z}});
  return upload_texture(gl, {.texture = std::move(blank), .filter = TextureFilter::nearest});
}

GLuint upload_table(const GlApi& gl, const MerlTable& table, TableContent content, MerlLookup lookup) {
  const float* const rgb = content == TableContent::values ? table.values<float>() : table.log_values<float>();
  std::vector<float> texels(4 * MerlTable::samples);
  for (std::size_t i = 0; i < MerlTable::samples; ++i) {
    const float* const from = rgb + 3 * i;
    if (std::min({from[0], from[1], from[2]}) < 0) continue; // never measured
    std::copy_n(from, 3, &texels[4 * i]);
    texels[4 * i + 3] = 1;
  }
  const GLuint name = new_texture(gl, GL_TEXTURE_3D);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA32F, MerlTable::phi_d_bins, MerlTable::theta_d_bins, MerlTable::theta_h_bins,
                0, GL_RGBA, GL_FLOAT, texels.data());
  set(gl, GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_REPEAT); // phi_d is periodic
  set(gl, GL_TEXTURE_3D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  set(gl, GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  const GLenum filter = lookup == MerlLookup::nearest ? GL_NEAREST : GL_LINEAR;
  set(gl, GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, filter);
  set(gl, GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
  return name;
}

} // namespace refraster
