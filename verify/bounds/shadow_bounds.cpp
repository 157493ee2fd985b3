#include "verify/bounds/shadow_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace refraster {
namespace {

using Bounds = DeviceShadows::Bounds;

/// Of a filter's sum: two products and four sums, or a quotient.
constexpr double filter_roundings = 8;
/// More texels that a place may be in are not looked at one by one.
constexpr int max_cells = 4;

VisibilityRange join(const VisibilityRange& a, const VisibilityRange& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// Faces of a cube that a direction may fall in.
std::vector<std::size_t> faces_of(const Vec3<Bounds>& d) {
  double farthest = 0; // along some axis, for certain
  for (int c = 0; c < 3; ++c) farthest = std::max({farthest, d[c].lo, -d[c].hi});
  std::vector<std::size_t> faces;
  for (int c = 0; c < 3; ++c)
    for (const int sign : {1, -1})
      if (const double most = sign > 0 ? d[c].hi : -d[c].lo; most >= farthest && most >= 0)
        faces.push_back(static_cast<std::size_t>(2 * c + (sign < 0)));
  return faces;
}

enum class TapAnswer { no, yes, either };

/// One lookup in one face of a map.
class MapLookup {
public:
  MapLookup(const DeviceDepthMap& device, const DepthMap& ours, std::size_t face, const ValueRange& depth,
            std::optional<double> our_depth)
      : device_(device), ours_(ours), face_(face), depth_(depth), our_depth_(our_depth) {}

  TapAnswer at(int column, int row) const {
    const int last = device_.view().map.size - 1;
    if (device_.view().kind == LightPlace::Kind::point)
      column = std::clamp(column, 0, last), row = std::clamp(row, 0, last);
    else if (column < 0 || column > last || row < 0 || row > last) return TapAnswer::yes;
    if (our_depth_)
      return *our_depth_ > static_cast<double>(ours_.at(face_, column, row)) ? TapAnswer::no : TapAnswer::yes;
    const ValueRange stored = device_.texel(face_, column, row);
    if (depth_.hi <= stored.lo) return TapAnswer::yes;
    return depth_.lo > stored.hi ? TapAnswer::no : TapAnswer::either;
  }

  /// Of the taps from a texel on.
  VisibilityRange nearest(int column, int row) const {
    const TapAnswer lit = at(column, row);
    return {lit == TapAnswer::yes ? 1.0 : 0.0, lit == TapAnswer::no ? 0.0 : 1.0};
  }
  VisibilityRange pcf3(int column, int row) const {
    int certain = 0, possible = 0;
    for (int j = -1; j < 2; ++j)
      for (int i = -1; i < 2; ++i) {
        const TapAnswer lit = at(column + i, row + j);
        certain += lit == TapAnswer::yes, possible += lit != TapAnswer::no;
      }
    return {certain / 9.0, possible / 9.0};
  }
  /// Fractions from one range and another: what is linear in each is least and greatest at their ends.
  VisibilityRange two_by_two(int column, int row, const ValueRange& fx, const ValueRange& fy) const {
    VisibilityRange sum{1, 0};
    std::array<TapAnswer, 4> lit;
    for (std::size_t i = 0; i < 4; ++i) lit[i] = at(column + static_cast<int>(i & 1), row + static_cast<int>(i >> 1));
    for (const double x : {fx.lo, fx.hi})
      for (const double y : {fy.lo, fy.hi}) {
        VisibilityRange here{0, 0};
        for (std::size_t i = 0; i < 4; ++i) {
          const double weight = (i & 1 ? x : 1 - x) * (i >> 1 ? y : 1 - y);
          if (lit[i] == TapAnswer::yes) here.lo += weight;
          if (lit[i] != TapAnswer::no) here.hi += weight;
        }
        sum = join(sum, here);
      }
    const auto all = [&](TapAnswer one) {
      return std::all_of(lit.begin(), lit.end(), [one](TapAnswer l) { return l == one; });
    };
    return all(TapAnswer::yes) ? VisibilityRange{1, 1} : all(TapAnswer::no) ? VisibilityRange{0, 0} : sum;
  }

private:
  const DeviceDepthMap& device_;
  const DepthMap& ours_;
  std::size_t face_;
  ValueRange depth_;
  std::optional<double> our_depth_; // whose comparisons hold
};

/// Calls body(texel, fractions within it) for those that a place may be in; false for too many.
bool for_each_cell(const ValueRange& place, const auto& body) {
  if (!(place.hi - place.lo < max_cells)) return false;
  for (double cell = std::floor(place.lo); cell <= std::floor(place.hi); ++cell)
    body(static_cast<int>(cell), ValueRange{std::max(place.lo - cell, 0.0), std::min(place.hi - cell, 1.0)});
  return true;
}

/// As a shader cuts places off that are far outside.
ValueRange within_reach(const Bounds& place, double less, int size) {
  const auto cut = [&](double x) { return std::min(std::max(x, -4.0), size + 4.0) - less; };
  return {cut(place.lo), cut(place.hi)};
}

VisibilityRange in_face(const DeviceDepthMap& device, const DepthMap& ours, std::size_t face,
                        const DeviceShadows::At& at, OpenComparisons open) {
  const LightView& view = device.view();
  const ShadowFilter filter = view.map.filter;
  const MapPlace<Bounds> place = map_place<Bounds>(view, face, at.position, at.normal);
  if (!std::isfinite(place.u.lo + place.u.hi + place.v.lo + place.v.hi + place.depth.lo)) return {};
  const MapPlace<double> our_place = map_place<double>(view, face, at.ours.position, at.ours.normal);
  const bool as_ours = open == OpenComparisons::as_ours;
  const MapLookup in_map(device, ours, face, {place.depth.lo, place.depth.hi},
                         as_ours ? std::optional(our_place.depth) : std::nullopt);
  const bool halves = filter == ShadowFilter::two_by_two;
  const double less = halves ? 0.5 : 0;
  const bool as_placed = as_ours && !halves; // of these the texel is a comparison too
  const ValueRange u = within_reach(as_placed ? Bounds(our_place.u) : place.u, less, view.map.size),
                   v = within_reach(as_placed ? Bounds(our_place.v) : place.v, less, view.map.size);
  VisibilityRange result{1, 0};
  bool all = true;
  all &= for_each_cell(u, [&](int column, const ValueRange& fx) {
    all &= for_each_cell(v, [&](int row, const ValueRange& fy) {
      result = join(result, filter == ShadowFilter::nearest ? in_map.nearest(column, row)
                            : halves                        ? in_map.two_by_two(column, row, fx, fy)
                                                            : in_map.pcf3(column, row));
    });
  });
  if (!all) return {};
  const double relative = filter_roundings * DeviceArithmetic::relative;
  if (result.lo > 0 && result.lo < 1) result.lo *= 1 - relative;
  if (result.hi > 0 && result.hi < 1) result.hi = std::min(result.hi * (1 + relative), 1.0);
  return result;
}

} // namespace

DeviceShadows::DeviceShadows(const FrameInput& frame, const Geometry& geometry, const DeviceProfile& profile)
    : casters_(casters_of(frame.scene)) {
  ours_.build(frame, geometry);
  for (const ShadowedLight& light : ours_.lights())
    if (light.kind == Shadow::map)
      maps_.push_back(std::make_unique<DeviceDepthMap>(casters_, ours_.map(light).view(), frame.options, profile));
}

std::span<const VisibilityRange> DeviceShadows::ranges(const At& at, OpenComparisons open,
                                                       std::vector<VisibilityRange>& memory) const {
  memory.clear();
  for (const ShadowedLight& light : ours_.lights()) {
    VisibilityRange& range = memory.emplace_back();
    if (light.kind != Shadow::map) continue;
    const DeviceDepthMap& device = *maps_[light.map];
    const DepthMap& ours = ours_.map(light);
    if (device.view().kind == LightPlace::Kind::direction) {
      range = in_face(device, ours, 0, at, open);
    } else if (open == OpenComparisons::as_ours) {
      range = in_face(device, ours, ours.face_of(at.ours.position), at, open);
    } else {
      const Vec3<Bounds> d = at.position - as<Bounds>(device.view().origin);
      range = {1, 0};
      for (const std::size_t face : faces_of(d)) range = join(range, in_face(device, ours, face, at, open));
    }
    if (device.view().map.filter == ShadowFilter::nearest && range.lo == 0 && range.hi == 1)
      if (const Certainty lit = Forks::decided(); lit != Certainty::unknown)
        range.lo = range.hi = lit == Certainty::yes ? 1 : 0;
  }
  return memory;
}

} // namespace refraster
