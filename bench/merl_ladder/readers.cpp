#include "bench/merl_ladder/readers.h"

#include "raster/stopwatch.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace refraster::ladder {

namespace {

constexpr int passes = 9;

/// As many pairs as there are lanes; the last one repeated where there are no more.
template <class T>
struct Packet {
  Vec3<T> n, i, o;
};

template <class T>
std::vector<Packet<T>> packets(const std::vector<SurfacePair>& pairs) {
  constexpr std::size_t lanes = NumberTraits<T>::lanes;
  std::vector<Packet<T>> result((pairs.size() + lanes - 1) / lanes);
  for (std::size_t k = 0; k < result.size() * lanes; ++k) {
    const SurfacePair& pair = pairs[std::min(k, pairs.size() - 1)];
    const auto set = [&](Vec3<T>& to, const Double3& from) {
      const int lane = static_cast<int>(k % lanes);
      to.x.set(lane, static_cast<RealOf<T>>(from.x));
      to.y.set(lane, static_cast<RealOf<T>>(from.y));
      to.z.set(lane, static_cast<RealOf<T>>(from.z));
    };
    Packet<T>& packet = result[k / lanes];
    set(packet.n, pair.n), set(packet.i, pair.i), set(packet.o, pair.o);
  }
  return result;
}

template <class T, class Stored>
[[gnu::flatten, gnu::noinline]] void read_all(const MerlTable& table, MerlLookup lookup,
                                              const std::vector<Packet<T>>& from, std::vector<Rgb<T>>& to) {
  for (std::size_t k = 0; k < from.size(); ++k)
    to[k] = merl_value<T, Stored>(table, lookup,
                                  merl_point(half_difference(MerlAngles::closed, from[k].n, from[k].i, from[k].o)))
                .f;
}

template <class T, class Stored>
std::vector<Rgb<double>> read(const MerlTable& table, MerlLookup lookup, const std::vector<SurfacePair>& pairs) {
  const std::vector<Packet<T>> from = packets<T>(pairs);
  std::vector<Rgb<T>> to(from.size());
  read_all<T, Stored>(table, lookup, from, to);
  std::vector<Rgb<double>> values(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Rgb<T>& all = to[k / NumberTraits<T>::lanes];
    const int lane = static_cast<int>(k % NumberTraits<T>::lanes);
    values[k] = {static_cast<double>(all.x[lane]), static_cast<double>(all.y[lane]), static_cast<double>(all.z[lane])};
  }
  return values;
}

template <class T, class Stored>
double seconds(const MerlTable& table, MerlLookup lookup, const std::vector<SurfacePair>& pairs) {
  const std::vector<Packet<T>> from = packets<T>(pairs);
  std::vector<Rgb<T>> to(from.size());
  read_all<T, Stored>(table, lookup, from, to); // makes the copy of the table
  double least = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < passes; ++pass) {
    const Stopwatch stopwatch(TimeOf::thread);
    read_all<T, Stored>(table, lookup, from, to);
    least = std::min(least, stopwatch.seconds());
  }
  return least;
}

template <class Stored>
constexpr Format format(std::string_view name) {
  return {name, 3 * MerlTable::samples * sizeof(Stored)};
}
template <class Stored>
constexpr Format format_of = format<double>("double");
template <>
constexpr Format format_of<float> = format<float>("float");
template <>
constexpr Format format_of<Half> = format<Half>("half");

template <class Precision, class Stored>
Reader reader(bool is_the_precisions) {
  using T = typename Precision::Number;
  return {Precision::name,   format_of<Stored>, format_of<RealOf<T>>,
          is_the_precisions, read<T, Stored>,   seconds<T, Stored>};
}

} // namespace

std::vector<Reader> readers() {
  std::vector<Reader> all;
  std::apply(
      [&](auto... precision) {
        (all.push_back(reader<decltype(precision), TableRealOf<typename decltype(precision)::Number>>(true)), ...);
      },
      LanePrecisions{});
  all.push_back(reader<FloatPrecision, Half>(false));
  return all;
}

} // namespace refraster::ladder
