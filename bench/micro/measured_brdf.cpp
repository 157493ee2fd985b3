// A measured BRDF: from directions to a point in the table, and each way to read the table there.

#include "bench/micro/micro.h"
#include "bench/micro/table.h"
#include "shading/merl_lookup.h"

#include <array>

namespace refraster::micro {
namespace {

struct Pair {
  Double3 n, l, v;
};

/// Anywhere above a surface: nothing of the table stays in a cache from one to the next.
std::vector<Pair> random_pairs() {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> z(0, 1), azimuth(0, 6.283185307179586);
  const auto direction = [&] {
    const double up = z(random), phi = azimuth(random), out = std::sqrt(1 - up * up);
    return normalize(Double3(out * std::cos(phi), out * std::sin(phi), up));
  };
  std::vector<Pair> pairs(many);
  for (Pair& pair : pairs) pair = {{0, 0, 1}, direction(), direction()};
  return pairs;
}

/// The pixels of a sphere, 256 by 256, row by row: neighbours read neighbouring samples.
std::vector<Pair> sphere_pairs() {
  std::vector<Pair> pairs;
  const Double3 light = normalize(Double3(0.4, 0.5, 1));
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const double a = (x + 0.5) / 183 - 0.7, b = (y + 0.5) / 183 - 0.7;
      pairs.push_back({normalize(Double3(a, b, std::sqrt(std::max(0.0, 1 - a * a - b * b)))), light, {0, 0, 1}});
    }
  return pairs;
}

template <class F>
Vectors<F> table_points(const std::vector<Pair>& pairs) {
  Vectors<F> points(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const MerlPoint<double> point = merl_point(half_difference(MerlAngles::closed, pairs[i].n, pairs[i].l, pairs[i].v));
    points.set(i, {point.u, point.v, point.w});
  }
  return points;
}

template <class T>
void add_angles(const std::string& number, const std::vector<Pair>& pairs) {
  using F = RealOf<T>;
  std::array<Vectors<F>, 3> vectors{Vectors<F>(few), Vectors<F>(few), Vectors<F>(few)};
  for (std::size_t i = 0; i < few; ++i)
    vectors[0].set(i, pairs[i].n), vectors[1].set(i, pairs[i].l), vectors[2].set(i, pairs[i].v);
  for (const auto& [method, name] : EnumNames<MerlAngles>::names)
    add("merl/angles/" + std::string(name) + "/" + number, few, [vectors, chosen = method] {
      for_each_packet_of<T>(few, [&](std::size_t i) {
        return merl_point(half_difference(chosen, vectors[0].template at<T>(i), vectors[1].template at<T>(i),
                                          vectors[2].template at<T>(i)));
      });
    });
}

template <class T, class Stored>
void add_lookup(const std::string& name, MerlLookup lookup, const Vectors<RealOf<T>>& points) {
  add(name, points.x.size(), [points, lookup, table = synthetic_table()] {
    for_each_packet_of<T>(points.x.size(), [&](std::size_t i) {
      const Vec3<T> at = points.template at<T>(i);
      return merl_value<T, Stored>(*table, lookup, MerlPoint<T>{at.x, at.y, at.z}).f;
    });
  });
}

template <class T>
void add_lookups(const std::string& number, const char* order, const std::vector<Pair>& pairs) {
  const Vectors<RealOf<T>> points = table_points<RealOf<T>>(pairs);
  const std::string where = std::string("/") + order + "/" + number;
  for (const auto& [lookup, name] : EnumNames<MerlLookup>::names)
    add_lookup<T, RealOf<T>>("merl/" + std::string(name) + where, lookup, points);
  if constexpr (std::is_same_v<RealOf<T>, float>) {
    add_lookup<T, Half>("merl/nearest in halves" + where, MerlLookup::nearest, points);
    add_lookup<T, Half>("merl/trilinear in halves" + where, MerlLookup::trilinear, points);
  }
}

} // namespace

void add_measured_brdf() {
  for_each_number([random = random_pairs(), sphere = sphere_pairs()]<class T>(const std::string& number) {
    add_angles<T>(number, random);
    add_lookups<T>(number, "sphere", sphere);
    add_lookups<T>(number, "random", random);
  });
}

} // namespace refraster::micro
