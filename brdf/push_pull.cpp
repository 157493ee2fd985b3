#include "brdf/push_pull.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

using Index = std::array<std::size_t, 3>;

std::size_t place(const GapGrid& grid, const Index& at) {
  return (at[0] * grid.size[1] + at[1]) * grid.size[2] + at[2];
}

template <class Use>
void for_each_point(const GapGrid& grid, const Use& use) {
  for (Index at{}; at[0] < grid.size[0]; ++at[0])
    for (at[1] = 0; at[1] < grid.size[1]; ++at[1])
      for (at[2] = 0; at[2] < grid.size[2]; ++at[2]) use(at);
}

GapGrid coarser(const GapGrid& fine) {
  GapGrid coarse;
  for (std::size_t axis = 0; axis < 3; ++axis) coarse.size[axis] = (fine.size[axis] + 1) / 2;
  coarse.values.assign(3 * coarse.points(), 0);
  coarse.weights.assign(coarse.points(), 0);
  for_each_point(fine, [&](const Index& at) {
    const std::size_t from = place(fine, at), to = place(coarse, {at[0] / 2, at[1] / 2, at[2] / 2});
    for (std::size_t c = 0; c < 3; ++c) coarse.values[3 * to + c] += fine.weights[from] * fine.values[3 * from + c];
    coarse.weights[to] += fine.weights[from];
  });
  for (std::size_t k = 0; k < coarse.points(); ++k) {
    if (coarse.weights[k] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) coarse.values[3 * k + c] /= coarse.weights[k];
    coarse.weights[k] = std::min(coarse.weights[k], 1.0);
  }
  return coarse;
}

/// The two points of the coarse axis that a fine one lies between, and its way from the first to the second.
struct Between {
  std::size_t first, second;
  double fraction;
};

Between between(std::size_t fine, std::size_t coarse_size, bool goes_round) {
  const double at = (static_cast<double>(fine) + 0.5) / 2 - 0.5;
  const double floor = std::floor(at);
  const auto wrapped = [&](double k) {
    const auto size = static_cast<double>(coarse_size);
    if (goes_round) return static_cast<std::size_t>(k < 0 ? k + size : k >= size ? k - size : k);
    return static_cast<std::size_t>(std::clamp(k, 0.0, size - 1));
  };
  return {wrapped(floor), wrapped(floor + 1), at - floor};
}

/// What the coarse grid says at a point of the fine one.
std::array<double, 3> interpolated(const GapGrid& coarse, const Index& at) {
  std::array<Between, 3> axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) axes[axis] = between(at[axis], coarse.size[axis], axis == 2);
  std::array<double, 3> sum{};
  for (int corner = 0; corner < 8; ++corner) {
    Index from{};
    double weight = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool second = (corner >> axis & 1) != 0;
      from[axis] = second ? axes[axis].second : axes[axis].first;
      weight *= second ? axes[axis].fraction : 1 - axes[axis].fraction;
    }
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * coarse.values[3 * place(coarse, from) + c];
  }
  return sum;
}

} // namespace

void fill_gaps(GapGrid& grid) {
  if (grid.points() <= 1) return;
  GapGrid coarse = coarser(grid);
  fill_gaps(coarse);
  for_each_point(grid, [&](const Index& at) {
    const std::size_t k = place(grid, at);
    const double weight = grid.weights[k];
    if (weight == 1) return;
    const std::array<double, 3> around = interpolated(coarse, at);
    for (std::size_t c = 0; c < 3; ++c)
      grid.values[3 * k + c] = weight * grid.values[3 * k + c] + (1 - weight) * around[c];
  });
}

} // namespace refraster
