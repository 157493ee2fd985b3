#include "verify/explain/readings.h"

#include "verify/explain/traced.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace refraster {
namespace {

double weight_of(const Traced& x, std::size_t number) {
  for (const auto& [read, weight] : x.weights())
    if (read == number) return weight;
  return 0;
}

} // namespace

std::vector<Texel> texels_read(const TextureMap& map, const Double2& uv, const Double2& right, const Double2& down) {
  const Texture& texture = *map.texture;
  ReadLog log;
  const auto place = [&](const Double2& p) { return Vec2<Traced>(Traced(p.x, log), Traced(p.y, log)); };
  const Rgb<Traced> colour = sample(map, place(uv), place(right), place(down));
  std::vector<Texel> texels;
  for (std::size_t number = 0; number < log.reads.size(); ++number) {
    const ReadLog::Read& read = log.reads[number];
    std::size_t level = 0;
    while (texture.levels[level].rgb.data() != read.grid) ++level;
    const Rgb<double> stored = texels_of<double>(texture.levels[level])(read.i, read.j, 0);
    // The filter divides by the full scale at its end.
    texels.push_back({static_cast<int>(level), read.i, read.j, weight_of(colour.x, number) * texture.full_scale,
                      stored / texture.full_scale});
  }
  // The order of reading is the compiler's.
  std::sort(texels.begin(), texels.end(),
            [](const Texel& a, const Texel& b) { return std::tie(a.level, a.j, a.i) < std::tie(b.level, b.j, b.i); });
  return texels;
}

std::vector<MerlTap> taps_read(const MerlTable& table, MerlLookup lookup, const MerlPoint<double>& at) {
  ReadLog log;
  const MerlPoint<Traced> place{Traced(at.u, log), Traced(at.v, log), Traced(at.w, log)};
  const MerlValue<Traced> value = merl_value(table, lookup, place);
  std::vector<MerlTap> taps;
  // The weights of what was interpolated add up to 1: a logarithm that is undone afterwards multiplies them all alike.
  // In a channel that was clamped to 0 nothing is left of them.
  const auto sum_of = [&](const Traced& x) {
    double sum = 0;
    for (const auto& [read, weight] : x.weights()) sum += weight;
    return sum;
  };
  const Traced* channel = &value.f.x;
  for (const Traced* const other : {&value.f.y, &value.f.z})
    if (std::abs(sum_of(*other)) > std::abs(sum_of(*channel))) channel = other;
  const double sum = sum_of(*channel);
  for (std::size_t number = 0; number < log.reads.size(); ++number) {
    const ReadLog::Read& read = log.reads[number];
    const Rgb<double> f = table.sample(read.i, read.j, read.k);
    const double weight = weight_of(*channel, number);
    taps.push_back({read.i, read.j, read.k, sum != 0 ? weight / sum : 0, f, min(f.x, min(f.y, f.z)) < 0});
  }
  std::sort(taps.begin(), taps.end(), [](const MerlTap& a, const MerlTap& b) {
    return std::tie(a.theta_h, a.theta_d, a.phi_d) < std::tie(b.theta_h, b.theta_d, b.phi_d);
  });
  return taps;
}

} // namespace refraster
