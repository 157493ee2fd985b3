#include "raster/vertex/outside.h"

#include "math/precisions.h"
#include "raster/lanes.h"
#include "raster/parallel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace refraster {

namespace {

// Fewer are transformed as quickly as a box is tried.
constexpr std::size_t min_vertices = 64;

struct Box {
  Double3 low{0}, high{0};
  bool is_finite = false;
};

// Positions are taken as one row of numbers x y z x y z …, three registers at a time: each lane is always of the same
// component.
Box box_of(const std::vector<Float3>& positions) {
  using Row = Native<float>;
  constexpr std::size_t lanes = NumberTraits<Row>::lanes;
  static_assert(sizeof(Float3) == 3 * sizeof(float));
  const float* const numbers = &positions.front().x;
  const std::size_t count = 3 * positions.size();
  std::array<Row, 3> low, high, nothing; // nothing: x - x, which only a finite x leaves at 0
  for (std::size_t r = 0; r < 3; ++r) {
    std::array<float, lanes> first;
    for (std::size_t lane = 0; lane < lanes; ++lane) first[lane] = numbers[(r * lanes + lane) % 3];
    low[r] = high[r] = load_lanes<Row>(first.data());
    nothing[r] = low[r] - low[r];
  }
  std::size_t i = 0;
  for (; i + 3 * lanes <= count; i += 3 * lanes)
    for (std::size_t r = 0; r < 3; ++r) {
      const Row x = load_lanes<Row>(numbers + i + r * lanes);
      low[r] = min(low[r], x), high[r] = max(high[r], x);
      nothing[r] = nothing[r] + (x - x);
    }
  Box box;
  box.low = Double3(std::numeric_limits<double>::infinity()), box.high = -box.low;
  box.is_finite = true;
  const auto add = [&](std::size_t component, float least, float greatest, float difference) {
    const auto c = static_cast<glm::length_t>(component);
    box.low[c] = std::min(box.low[c], static_cast<double>(least));
    box.high[c] = std::max(box.high[c], static_cast<double>(greatest));
    box.is_finite = box.is_finite && difference == 0;
  };
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const int l = static_cast<int>(lane);
      add((r * lanes + lane) % 3, low[r][l], high[r][l], nothing[r][l]);
    }
  for (; i < count; ++i) add(i % 3, numbers[i], numbers[i], numbers[i] - numbers[i]);
  return box;
}

// Whether the vertex stage finds every point of the box on the far side of the same plane.
//
// A vertex is outside the plane where c < -w or c > w, both rounded: c = sum of four terms m_j p_j takes three roundings
// on the way of each term at most (the product, two sums), so it is off by 3u(1 + 3u) sum |m_j p_j|, u = 2^-53; w the
// same. What is computed here, the greatest value of w + c or w - c over the box, takes five: the sum of the two
// coefficients, the product, three sums. Together below 9 u of M = sum (|m_cj| + |m_wj|) max |p_j|, and twice that leaves
// room for the roundings of M itself. Above 2^-1000, M is so large that what products lose by being subnormal, 2^-1074
// each, vanishes beside it; below 2^1020 no sum overflows, so that all clip coordinates are finite.
bool is_outside(const Box& box, const Double4x4& clip_from_object) {
  const Double4x4& m = clip_from_object;
  bool outside = false;
  for (int row = 0; row < 3; ++row) {
    double size = 0;
    std::array<double, 2> greatest{}; // of w + c and of w - c
    for (int j = 0; j < 4; ++j) {
      const double low = j < 3 ? box.low[j] : 1, high = j < 3 ? box.high[j] : 1;
      size += (abs(m[j][row]) + abs(m[j][3])) * max(abs(low), abs(high));
      const std::array<double, 2> slope{m[j][3] + m[j][row], m[j][3] - m[j][row]};
      for (std::size_t side = 0; side < 2; ++side)
        greatest[side] += max(slope[side] * low, slope[side] * high);
    }
    if (!(size >= 0x1p-1000 && size <= 0x1p1020)) return false;
    const double bound = -18 * 0x1p-53 * size;
    outside = outside || greatest[0] < bound || greatest[1] < bound;
  }
  return outside;
}

} // namespace

void find_outside(const FrameInput& input, std::span<const ObjectTransform> transforms, std::vector<Storage>& storage) {
  const std::vector<Object>& objects = input.scene.objects;
  if (objects.size() < 2) return;
  std::unordered_map<const Mesh*, std::size_t> numbers;
  std::vector<const Mesh*> meshes;
  for (const Object& object : objects)
    if (object.mesh->positions.size() >= min_vertices && numbers.emplace(object.mesh.get(), meshes.size()).second)
      meshes.push_back(object.mesh.get());
  std::vector<Box> boxes(meshes.size());
  parallel_for(input.threads, meshes.size(), [&](std::size_t i, int) { boxes[i] = box_of(meshes[i]->positions); });
  for (std::size_t o = 0; o < objects.size(); ++o) {
    const auto number = numbers.find(objects[o].mesh.get());
    if (number == numbers.end()) continue;
    const Box& box = boxes[number->second];
    if (box.is_finite && is_outside(box, transforms[o].clip_from_object)) storage[o] = Storage::outside;
  }
}

} // namespace refraster
