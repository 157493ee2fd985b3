#pragma once
// What fragment functions are measured on.

#include "shading/light.h"

#include <random>
#include <span>
#include <string>
#include <string_view>

namespace refraster::precision {

/// Where a fragment function's directions come from.
enum class Path {
  directions,     // n, l, v are given, as the number holds them; C is the light's radiance
  point_light,    // the whole path: position, unnormalised normal, eye, a point light with attenuation
  direction_light // the same with a direction light of any length
};

/// One light on one point of a surface, in one channel. A Path uses some of the members.
struct Inputs {
  Path path = Path::directions;
  Double3 n{0}, l{0}, v{0};
  Double3 position{0}, normal{0}, eye{0};
  PointLight point;
  DirectionLight direction;
  double kd = 1, ks = 1, texture = 1, radiance = 1, glossiness = 8;
};

/// The inputs as numbers of F hold them: every value rounded, and n, l, v rounded as normalize leaves them. The oracle
/// is given the result.
template <class F>
Inputs held(Inputs in) {
  const auto number = [](double& x) { x = static_cast<double>(static_cast<F>(x)); };
  const auto vector = [&](Double3& a) { number(a.x), number(a.y), number(a.z); };
  for (Double3* a : {&in.n, &in.l, &in.v}) *a = Double3(normalize(Vec3<F>(*a)));
  for (Double3* a : {&in.position, &in.normal, &in.eye, &in.point.position, &in.direction.direction}) vector(*a);
  for (double* x : {&in.point.constant, &in.point.linear, &in.point.quadratic, &in.kd, &in.ks, &in.texture,
                    &in.radiance, &in.glossiness})
    number(*x);
  in.point.radiance = in.direction.radiance = Double3(in.radiance);
  return in;
}

/// A fragment and the light that arrives there, computed as the renderer does.
template <class F>
struct Lit {
  Fragment<F> at;
  Incident<F> light;
};
template <class F>
Lit<F> lit(const Inputs& in) {
  const Rgb<F> texture = as<F>(Double3(in.texture));
  if (in.path == Path::directions)
    return {{Vec3<F>(F(0)), as<F>(in.n), as<F>(in.v), texture, nullptr}, {as<F>(in.l), as<F>(Double3(in.radiance))}};
  const Vec3<F> position = as<F>(in.position);
  const Fragment<F> at{position, normalize(as<F>(in.normal)), normalize(as<F>(in.eye) - position), texture, nullptr};
  return {at, in.path == Path::point_light ? arriving(in.point, at) : arriving(in.direction, at)};
}

/// All members that the path and `glossy` functions use, by name, in hexadecimal.
enum class Glossiness { used, unused };
std::string text(const Inputs& in, Glossiness glossiness);

/// A named way to make inputs. Which family a point comes from says what to expect of it.
struct Family {
  std::string_view name, meaning;
  /// `decades`: how many powers of ten huge and tiny numbers may be away from 1.
  Inputs (*make)(std::mt19937_64& random, double decades);
};

/// 30 for float, 150 for double: squares of such numbers overflow and underflow.
template <class F>
inline constexpr double decades = sizeof(F) == 4 ? 30 : 150;

std::span<const Family> phong_families();
std::span<const Family> merl_families();
/// In one of the two lists; the name must be there.
const Family& family(std::span<const Family> families, std::string_view name);

} // namespace refraster::precision
