#include "gl/program/glsl_types.h"

#include <cstdio>
#include <map>

namespace refraster {
namespace {

using Types = std::map<GLenum, GlslType>;

void add_numbers(Types& types) {
  struct Numbers {
    GlslBase base;
    const char *scalar, *vector;
    GLenum enums[4];
  };
  constexpr Numbers numbers[] = {
      {GlslBase::float_, "float", "vec", {GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4}},
      {GlslBase::int_, "int", "ivec", {GL_INT, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4}},
      {GlslBase::uint_,
       "uint",
       "uvec",
       {GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4}},
      {GlslBase::bool_, "bool", "bvec", {GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4}},
      {GlslBase::double_, "double", "dvec", {GL_DOUBLE, GL_DOUBLE_VEC2, GL_DOUBLE_VEC3, GL_DOUBLE_VEC4}},
  };
  for (const Numbers& row : numbers)
    for (int n = 1; n <= 4; ++n) {
      const GLenum type = row.enums[n - 1];
      types[type] = {type, n == 1 ? row.scalar : row.vector + std::to_string(n), GlslKind::number, row.base, 1, n};
    }

  struct Matrix {
    int columns, rows;
    GLenum of_float, of_double;
  };
  constexpr Matrix matrices[] = {
      {2, 2, GL_FLOAT_MAT2, GL_DOUBLE_MAT2},     {2, 3, GL_FLOAT_MAT2x3, GL_DOUBLE_MAT2x3},
      {2, 4, GL_FLOAT_MAT2x4, GL_DOUBLE_MAT2x4}, {3, 2, GL_FLOAT_MAT3x2, GL_DOUBLE_MAT3x2},
      {3, 3, GL_FLOAT_MAT3, GL_DOUBLE_MAT3},     {3, 4, GL_FLOAT_MAT3x4, GL_DOUBLE_MAT3x4},
      {4, 2, GL_FLOAT_MAT4x2, GL_DOUBLE_MAT4x2}, {4, 3, GL_FLOAT_MAT4x3, GL_DOUBLE_MAT4x3},
      {4, 4, GL_FLOAT_MAT4, GL_DOUBLE_MAT4},
  };
  for (const Matrix& m : matrices) {
    const std::string name =
        "mat" + std::to_string(m.columns) + (m.rows == m.columns ? "" : "x" + std::to_string(m.rows));
    types[m.of_float] = {m.of_float, name, GlslKind::number, GlslBase::float_, m.columns, m.rows};
    types[m.of_double] = {m.of_double, "d" + name, GlslKind::number, GlslBase::double_, m.columns, m.rows};
  }
}

/// What samplers and images read, by its words in GLSL: of floats, ints, unsigned ints, and with comparison.
void add_samplers_and_images(Types& types) {
  struct Shape {
    const char* name;
    GLenum target;
    GLenum sampler[3], shadow, image[3];
  };
  constexpr Shape shapes[] = {
      {"1D",
       GL_TEXTURE_1D,
       {GL_SAMPLER_1D, GL_INT_SAMPLER_1D, GL_UNSIGNED_INT_SAMPLER_1D},
       GL_SAMPLER_1D_SHADOW,
       {GL_IMAGE_1D, GL_INT_IMAGE_1D, GL_UNSIGNED_INT_IMAGE_1D}},
      {"2D",
       GL_TEXTURE_2D,
       {GL_SAMPLER_2D, GL_INT_SAMPLER_2D, GL_UNSIGNED_INT_SAMPLER_2D},
       GL_SAMPLER_2D_SHADOW,
       {GL_IMAGE_2D, GL_INT_IMAGE_2D, GL_UNSIGNED_INT_IMAGE_2D}},
      {"3D",
       GL_TEXTURE_3D,
       {GL_SAMPLER_3D, GL_INT_SAMPLER_3D, GL_UNSIGNED_INT_SAMPLER_3D},
       GL_NONE,
       {GL_IMAGE_3D, GL_INT_IMAGE_3D, GL_UNSIGNED_INT_IMAGE_3D}},
      {"Cube",
       GL_TEXTURE_CUBE_MAP,
       {GL_SAMPLER_CUBE, GL_INT_SAMPLER_CUBE, GL_UNSIGNED_INT_SAMPLER_CUBE},
       GL_SAMPLER_CUBE_SHADOW,
       {GL_IMAGE_CUBE, GL_INT_IMAGE_CUBE, GL_UNSIGNED_INT_IMAGE_CUBE}},
      {"2DRect",
       GL_TEXTURE_RECTANGLE,
       {GL_SAMPLER_2D_RECT, GL_INT_SAMPLER_2D_RECT, GL_UNSIGNED_INT_SAMPLER_2D_RECT},
       GL_SAMPLER_2D_RECT_SHADOW,
       {GL_IMAGE_2D_RECT, GL_INT_IMAGE_2D_RECT, GL_UNSIGNED_INT_IMAGE_2D_RECT}},
      {"1DArray",
       GL_TEXTURE_1D_ARRAY,
       {GL_SAMPLER_1D_ARRAY, GL_INT_SAMPLER_1D_ARRAY, GL_UNSIGNED_INT_SAMPLER_1D_ARRAY},
       GL_SAMPLER_1D_ARRAY_SHADOW,
       {GL_IMAGE_1D_ARRAY, GL_INT_IMAGE_1D_ARRAY, GL_UNSIGNED_INT_IMAGE_1D_ARRAY}},
      {"2DArray",
       GL_TEXTURE_2D_ARRAY,
       {GL_SAMPLER_2D_ARRAY, GL_INT_SAMPLER_2D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D_ARRAY},
       GL_SAMPLER_2D_ARRAY_SHADOW,
       {GL_IMAGE_2D_ARRAY, GL_INT_IMAGE_2D_ARRAY, GL_UNSIGNED_INT_IMAGE_2D_ARRAY}},
      {"CubeArray",
       GL_TEXTURE_CUBE_MAP_ARRAY,
       {GL_SAMPLER_CUBE_MAP_ARRAY, GL_INT_SAMPLER_CUBE_MAP_ARRAY, GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY},
       GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW,
       {GL_IMAGE_CUBE_MAP_ARRAY, GL_INT_IMAGE_CUBE_MAP_ARRAY, GL_UNSIGNED_INT_IMAGE_CUBE_MAP_ARRAY}},
      {"Buffer",
       GL_TEXTURE_BUFFER,
       {GL_SAMPLER_BUFFER, GL_INT_SAMPLER_BUFFER, GL_UNSIGNED_INT_SAMPLER_BUFFER},
       GL_NONE,
       {GL_IMAGE_BUFFER, GL_INT_IMAGE_BUFFER, GL_UNSIGNED_INT_IMAGE_BUFFER}},
      {"2DMS",
       GL_TEXTURE_2D_MULTISAMPLE,
       {GL_SAMPLER_2D_MULTISAMPLE, GL_INT_SAMPLER_2D_MULTISAMPLE, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE},
       GL_NONE,
       {GL_IMAGE_2D_MULTISAMPLE, GL_INT_IMAGE_2D_MULTISAMPLE, GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE}},
      {"2DMSArray",
       GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
       {GL_SAMPLER_2D_MULTISAMPLE_ARRAY, GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY,
        GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY},
       GL_NONE,
       {GL_IMAGE_2D_MULTISAMPLE_ARRAY, GL_INT_IMAGE_2D_MULTISAMPLE_ARRAY, GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY}},
  };
  constexpr GlslBase bases[] = {GlslBase::float_, GlslBase::int_, GlslBase::uint_};
  constexpr const char* prefixes[] = {"", "i", "u"};
  for (const Shape& shape : shapes) {
    for (int i = 0; i < 3; ++i) {
      const std::string sampler = std::string(prefixes[i]) + "sampler" + shape.name;
      const std::string image = std::string(prefixes[i]) + "image" + shape.name;
      types[shape.sampler[i]] = {shape.sampler[i], sampler, GlslKind::sampler, bases[i], 1, 1, shape.target};
      types[shape.image[i]] = {shape.image[i], image, GlslKind::image, bases[i], 1, 1, shape.target};
    }
    if (shape.shadow != GL_NONE)
      types[shape.shadow] = {
          shape.shadow, std::string("sampler") + shape.name + "Shadow", GlslKind::sampler, GlslBase::depth, 1, 1,
          shape.target};
  }
}

Types all_types() {
  Types types;
  add_numbers(types);
  add_samplers_and_images(types);
  types[GL_UNSIGNED_INT_ATOMIC_COUNTER] = {GL_UNSIGNED_INT_ATOMIC_COUNTER, "atomic_uint", GlslKind::atomic_counter,
                                           GlslBase::uint_};
  return types;
}

} // namespace

const GlslType& glsl_type(GLenum type) {
  static Types types = all_types();
  const auto [entry, is_new] = types.try_emplace(type);
  if (is_new) {
    char name[32];
    std::snprintf(name, sizeof name, "type 0x%X", type);
    entry->second.type = type;
    entry->second.name = name;
  }
  return entry->second;
}

std::string array_name(const std::string& name) {
  return name.ends_with("[0]") ? name.substr(0, name.size() - 3) : name;
}

std::string declaration(const std::string& name, GLenum type, GLint size) {
  const std::string length = size > 1 || name.ends_with("[0]") ? "[" + std::to_string(size) + "]" : "";
  return glsl_type(type).name + " " + array_name(name) + length;
}

std::string array_type_name(const std::string& name, GLenum type, GLint size) {
  return glsl_type(type).name + (size > 1 || name.ends_with("[0]") ? "[" + std::to_string(size) + "]" : "");
}

} // namespace refraster
