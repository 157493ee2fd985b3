// Lit in stages, light by light for many packets, or one fragment after the other by the formula: the same bits.

#include "shading/sum_light.h"
#include "tests/unit/shading/laws.h"

#include <doctest/doctest.h>

#include <memory>

using namespace refraster;

namespace {

template <class T>
constexpr int lanes = NumberTraits<T>::lanes;

/// Surfaces of which some have no normal, or the eye or a light at them.
template <class T>
void make_surfaces(std::mt19937_64& random, PacketBatch<T>& batch, const std::vector<PointLight>& lights) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(batch.packets); ++p)
    for (int lane = 0; lane < lanes<T>; ++lane) {
      const int k = static_cast<int>(random() % 40);
      const Situation s = random_situation(random, k % 10);
      const auto put = [lane](Vec3<T>& to, const Double3& from) {
        for (int c = 0; c < 3; ++c) to[c].set(lane, static_cast<RealOf<T>>(from[c]));
      };
      const Double3 position = k == 11 && !lights.empty() ? lights[0].position : s.l * uniform(random, 0, 3);
      put(batch.surface[p].position, position), put(batch.surface[p].normal, s.n);
      put(batch.surface[p].to_eye, s.v), put(batch.surface[p].texture, s.texture);
      put(batch.maps[p].specular, s.texture), put(batch.maps[p].emission, s.radiance);
    }
  for (std::size_t p = 0; p < static_cast<std::size_t>(batch.packets); ++p)
    batch.in_use[p] = first_lanes<RealOf<T>, lanes<T>>(1 + static_cast<int>(random() % lanes<T>));
}

/// As the formula has it: one light after the other, for each packet.
template <Maps has_maps, class T, class Function>
void sum_by_formula(const std::vector<PointLight>& points, const std::vector<DirectionLight>& directions,
                    const Function& function, PacketBatch<T>& batch, UndefinedCounts& counts) {
  batch.template for_each<has_maps>(counts, [&](std::size_t p, const Fragment<T>& at, const UndefinedTally<T>& tally) {
    Rgb<T> sum = ambient(function, at);
    if constexpr (has_maps == Maps::yes) sum += at.maps->emission;
    const double* row = batch.visibility.rows;
    const auto add = [&](const auto& light) {
      Incident<T> incident = arriving(prepared_light(light), at);
      if (light.shadow != Shadow::none) {
        T visibility(0);
        for (int lane = 0; lane < lanes<T>; ++lane)
          visibility.set(lane, static_cast<RealOf<T>>(row[p * lanes<T> + static_cast<std::size_t>(lane)]));
        incident.radiance = incident.radiance * visibility;
        row += batch.visibility.stride;
      }
      sum += reflected(function, at, incident);
    };
    for (const PointLight& light : points) add(light);
    for (const DirectionLight& light : directions) add(light);
    batch.sum[p] = finite(sum, tally);
  });
}

template <class T, Maps has_maps, class Function>
void check_stages(const Function& function, std::mt19937_64& random) {
  std::vector<PointLight> points;
  std::vector<DirectionLight> directions;
  const auto colour = [&] { return Double3(uniform(random, 0, 2), uniform(random, 0, 2), 0); };
  const auto coefficient = [&] { return random() % 2 ? uniform(random, 0, 2) : 0; };
  for (std::size_t k = random() % 4; k > 0; --k) {
    const double constant = coefficient(), linear = coefficient(), quadratic = coefficient();
    points.push_back({random_direction(random) * 2.0, colour(), constant, linear, quadratic});
  }
  for (std::size_t k = random() % 3; k > 0; --k) directions.push_back({random_direction(random), colour()});
  std::mt19937_64 own(points.size() + 4 * directions.size()); // of shadows: no other number is drawn for them
  for (PointLight& light : points) light.shadow = own() % 2 ? own() % 2 ? Shadow::exact : Shadow::map : Shadow::none;
  for (DirectionLight& light : directions)
    light.shadow = own() % 2 ? own() % 2 ? Shadow::exact : Shadow::map : Shadow::none;

  const auto staged = std::make_unique<PacketBatch<T>>(), plain = std::make_unique<PacketBatch<T>>();
  staged->packets = 1 + static_cast<int>(random() % PacketBatch<T>::capacity);
  make_surfaces(random, *staged, points);
  const std::size_t stride = PacketBatch<T>::fragment_of(PacketBatch<T>::capacity) + 3;
  std::vector<double> visible(stride * (points.size() + directions.size()) + 64);
  for (double& one : visible) one = static_cast<double>(own() % 4) / 3;
  staged->visibility = {visible.data(), stride};
  *plain = *staged;
  UndefinedCounts counts, plain_counts;
  const LightSpans lights{points, directions};
  sum_light<has_maps>(lights, function, *staged, counts);
  sum_by_formula<has_maps>(points, directions, function, *plain, plain_counts);
  for (std::size_t p = 0; p < static_cast<std::size_t>(staged->packets); ++p)
    for (int c = 0; c < 3; ++c)
      for (int lane = 0; lane < lanes<T>; ++lane)
        REQUIRE(bits_of(staged->sum[p][c][lane]) == bits_of(plain->sum[p][c][lane]));
  CHECK(counts.counts == plain_counts.counts);
}

} // namespace

TEST_CASE_TEMPLATE("light in stages has the bits of the formula, and counts what it counts", T, DoublePrecision::Number,
                   FloatPrecision::Number, Wide<float, 4>, Wide<double, 2>) {
  std::mt19937_64 random(17);
  for (const SpecularGate gate : {SpecularGate::open, SpecularGate::cut_below_horizon})
    for (const double glossiness : {0.0, 0.5, 1.0, 2.0, 7.5, 31.0, 32.0, 1000.0, 1921.0, 1922.0, 1e6})
      for (const Double3& ks : {Double3(0), Double3(0.4, 0, 1)}) {
        CAPTURE(glossiness);
        const PhongParameters parameters{{0.1, 0.2, 0}, {0.5, 0.3, 0.7}, ks, glossiness, gate};
        for (int k = 0; k < 6; ++k) {
          check_stages<T, Maps::no>(Phong{parameters}, random);
          check_stages<T, Maps::yes>(Phong{parameters}, random);
          check_stages<T, Maps::no>(BlinnPhong{parameters}, random);
          check_stages<T, Maps::yes>(BlinnPhong{parameters}, random);
        }
      }
}
