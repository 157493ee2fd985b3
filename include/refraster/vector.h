#pragma once
// Vectors and colours: GLM's types. Functions on them that a formula may use are in the fragment kit (math/vec.h).

#define GLM_FORCE_XYZW_ONLY // plain members: no swizzle unions for numbers that GLM does not know
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace refraster {

template <class T>
using Vec2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
template <class T>
using Vec4 = glm::vec<4, T, glm::defaultp>;
/// Linear red, green, blue. The same type as Vec3: products are per channel.
template <class T>
using Rgb = Vec3<T>;

using Double2 = Vec2<double>;
using Double3 = Vec3<double>;
using Double4 = Vec4<double>;
using Float2 = Vec2<float>;
using Float3 = Vec3<float>;
using Float4 = Vec4<float>;
using Double3x3 = glm::dmat3; // column-major, as in GLM and GLSL: m[column][row]
using Double4x4 = glm::dmat4;

} // namespace refraster
