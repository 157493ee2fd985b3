// Comparisons that are open are followed each way.

#include "math/bounds/affine_functions.h"
#include "math/bounds/device_arithmetic.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace refraster {
namespace {

std::vector<int> paths_of(int decisions, bool& complete) {
  std::vector<int> paths;
  Forks forks;
  do {
    int path = 1; // and behind it a bit for each decision
    for (int i = 0; i < decisions; ++i) path = path * 2 + (Forks::decided() == Certainty::yes ? 1 : 0);
    paths.push_back(path);
  } while (forks.next());
  complete = forks.is_complete();
  return paths;
}

} // namespace

TEST_CASE("every path is followed once, where there are few") {
  bool complete = false;
  CHECK(paths_of(0, complete) == std::vector{1});
  CHECK(complete);
  std::vector<int> paths = paths_of(3, complete);
  CHECK(complete);
  std::sort(paths.begin(), paths.end());
  CHECK(paths == std::vector{8, 9, 10, 11, 12, 13, 14, 15});
  CHECK(paths_of(4, complete).size() == 16);
  CHECK(complete);
  CHECK(paths_of(5, complete).size() == 16);
  CHECK(!complete);
}

TEST_CASE("a path that decides less ends where it ends") {
  std::vector<int> counts;
  Forks forks;
  do {
    int met = 1;
    if (Forks::decided() == Certainty::yes) {
      Forks::decided(), ++met;
      Forks::decided(), ++met;
    }
    counts.push_back(met);
  } while (forks.next());
  CHECK(counts == std::vector{3, 3, 3, 3, 1});
}

TEST_CASE("where no path is followed comparisons stay open, and are counted") {
  using T = Affine<DeviceArithmetic>;
  DeviceArithmetic::use({});
  const std::uint64_t before = Forks::open_comparisons();
  const T around_zero(-1, 1);
  CHECK((around_zero < T(0)) == Certainty::unknown);
  CHECK(Forks::open_comparisons() == before + 1);
  CHECK((T(1) < T(2)) == Certainty::yes);
  CHECK(max(around_zero, T(0)).lo == 0); // decides nothing
  CHECK(Forks::open_comparisons() == before + 1);
}

TEST_CASE("a step is one of its sides on each path, and both without any") {
  using T = Affine<DeviceArithmetic>;
  DeviceArithmetic::use({});
  const auto step = [] { return select(T(-1, 1) > T(0), T(5), T(0)); };
  CHECK(step().lo == 0);
  CHECK(step().hi == 5);
  std::vector<double> values;
  Forks forks;
  do {
    CHECK(step().is_point());
    values.push_back(step().lo); // decided again: a comparison of its own
  } while (forks.next());
  CHECK(values == std::vector<double>{5, 0, 5, 0});
}

TEST_CASE("of cells that jump one is read on each path") {
  using T = Affine<DeviceArithmetic>;
  DeviceArithmetic::use({});
  const std::array<GridAxis, 1> axes = {GridAxis{GridAxis::Beyond::clamped, 10}};
  const auto read = [](const std::array<Cell<T>, 1>& cell) { return T(cell[0].index * 2); };
  const std::array place = {T(3.5, 5.5)};
  const T all = read_nearest(place, axes, read);
  CHECK(all.lo == 6);
  CHECK(all.hi == 10);
  std::vector<double> values;
  Forks forks;
  do values.push_back(read_nearest(place, axes, read).hi);
  while (forks.next());
  CHECK(values == std::vector<double>{6, 8, 10});
}

} // namespace refraster
