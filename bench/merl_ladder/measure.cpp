#include "bench/merl_ladder/measure.h"

#include <algorithm>
#include <cmath>

namespace refraster::ladder {

namespace {

/// Directions as floats hold them, for every precision: what is compared is how they are used, not what they are.
SurfacePair held(const SurfacePair& pair) {
  const auto rounded = [](const Double3& a) { return Double3(normalize(Vec3<float>(a))); };
  return {rounded(pair.n), rounded(pair.i), rounded(pair.o)};
}

template <class Draw>
std::vector<SurfacePair> many(int pairs, const Draw& draw) {
  std::mt19937_64 random(1);
  std::vector<SurfacePair> result;
  while (result.size() < static_cast<std::size_t>(pairs)) {
    const SurfacePair pair = held(draw(random));
    if (dot(pair.n, pair.i) > 0 && dot(pair.n, pair.o) > 0) result.push_back(pair);
  }
  return result;
}

/// The pixels of a sphere under one light, row by row, as a frame reads them.
std::vector<SurfacePair> sphere() {
  std::vector<SurfacePair> pairs;
  const Double3 light = normalize(Double3(0.4, 0.5, 1)), eye(0, 0, 1);
  constexpr int side = 256;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double a = 1.4 * (x + 0.5) / side - 0.7, b = 1.4 * (y + 0.5) / side - 0.7;
      pairs.push_back(held({normalize(Double3(a, b, std::sqrt(std::max(0.0, 1 - a * a - b * b)))), light, eye}));
    }
  return pairs;
}

Errors errors(const std::vector<Rgb<double>>& read, const std::vector<Rgb<double>>& truth) {
  std::vector<double> each(read.size());
  Errors result;
  for (std::size_t k = 0; k < read.size(); ++k) {
    for (int c = 0; c < 3; ++c)
      each[k] = std::max(each[k], std::abs(read[k][c] - truth[k][c]) / (truth[k][c] + MerlTable::log_epsilon));
    result.mean += each[k] / static_cast<double>(read.size());
  }
  const auto mostly = each.begin() + static_cast<std::ptrdiff_t>(each.size() * 99 / 100);
  std::nth_element(each.begin(), mostly, each.end());
  result.mostly = *mostly;
  result.max = *std::max_element(mostly, each.end());
  return result;
}

std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const auto& [lookup, name] : EnumNames<MerlLookup>::names)
    for (const Reader& reader : readers()) {
      const Way way{lookup, name, reader};
      if (reader.is_the_precisions || &way.format() == &way.reader.values) ways.push_back(way);
    }
  return ways;
}

} // namespace

Material measure_errors(const std::string& name, const AnalyticBrdf& brdf, int pairs) {
  const MerlTable table = merl_table_from(brdf);
  Material material{name, {}};
  for (const Way& way : all_ways()) material.steps.push_back({way, {}, {}});
  const auto measure = [&](const std::vector<SurfacePair>& on, auto family) {
    std::vector<Rgb<double>> truth;
    for (const SurfacePair& at : on)
      truth.push_back(std::visit([&](const auto& formula) { return formula(at.n, at.i, at.o); }, brdf));
    const Reader in_double = readers().front();
    const std::vector<Rgb<double>> trilinear = in_double.read(table, MerlLookup::trilinear, on);
    for (Step& step : material.steps) {
      const std::vector<Rgb<double>> read = step.way.reader.read(table, step.way.lookup, on);
      step.*family = {errors(read, truth), errors(read, trilinear)};
    }
  };
  measure(many(pairs, specular_pair), &Step::specular);
  measure(many(pairs, random_pair), &Step::uniform);
  return material;
}

std::vector<Cost> measure_costs(const AnalyticBrdf& brdf) {
  const MerlTable table = merl_table_from(brdf);
  const std::vector<SurfacePair> near = sphere(), far = many(static_cast<int>(near.size()), random_pair);
  std::vector<Cost> costs;
  for (const Way& way : all_ways()) {
    const auto nanoseconds = [&](const std::vector<SurfacePair>& pairs) {
      return 1e9 * way.reader.seconds(table, way.lookup, pairs) / static_cast<double>(pairs.size());
    };
    costs.push_back({way, nanoseconds(near), nanoseconds(far)});
  }
  return costs;
}

} // namespace refraster::ladder
