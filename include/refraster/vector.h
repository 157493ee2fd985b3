#pragma once
// Vectors and colours: GLM's types. Functions on them that a formula may use are in the fragment kit (math/vec.h).

#define GLM_FORCE_XYZW_ONLY // plain members: no swizzle unions for numbers that GLM does not know
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace refraster {

/// Two numbers, with GLM's operators and functions.
template <class T>
using Vec2 = glm::vec<2, T, glm::defaultp>;
/// Three numbers.
template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
/// Four numbers.
template <class T>
using Vec4 = glm::vec<4, T, glm::defaultp>;
/// Linear red, green, blue. The same type as Vec3: products are per channel.
template <class T>
using Rgb = Vec3<T>;

using Double2 = Vec2<double>; ///< two of double
using Double3 = Vec3<double>; ///< three of double
using Double4 = Vec4<double>; ///< four of double
using Float2 = Vec2<float>;   ///< two of float
using Float3 = Vec3<float>;   ///< three of float
using Float4 = Vec4<float>;   ///< four of float
using Double3x3 = glm::dmat3; ///< column-major, as in GLM and GLSL: m[column][row]
using Double4x4 = glm::dmat4; ///< likewise

} // namespace refraster
