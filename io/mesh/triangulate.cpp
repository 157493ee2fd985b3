#include "io/mesh/obj_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

/// Twice the signed area: positive where a, b, c turn left.
double turn(const Double2& a, const Double2& b, const Double2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon along the axis that its normal is nearest to, turning left. For a polygon without area: any axis.
void flatten(std::span<const Float3> polygon, std::span<Double2> flat) {
  // As area_vector has it, which would need the polygon in double.
  const Double3 origin(polygon[0]);
  Double3 n(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    n += cross(Double3(polygon[i]) - origin, Double3(polygon[i + 1]) - origin);
  int axis = std::abs(n.x) > std::abs(n.y) ? 0 : 1;
  if (std::abs(n.z) >= std::abs(n[axis])) axis = 2;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3; // right-handed: u x v points along the axis
  const bool turned = n[axis] < 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Float3& p = polygon[i];
    flat[i] = turned ? Double2(p[v], p[u]) : Double2(p[u], p[v]);
  }
}

/// Ear clipping: Meisters, "Polygons have ears", 1975; what a clipped ear changes is only its two neighbours, O'Rourke,
/// "Computational geometry in C", 1998, section 1.6.
class EarClipper {
public:
  EarClipper(std::vector<Double2> points, std::uint64_t max_steps) : at_(std::move(points)), steps_left_(max_steps) {
    const std::uint32_t n = size();
    before_.resize(n), next_.resize(n), is_ear_.resize(n), is_reflex_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) before_[i] = (i + n - 1) % n, next_[i] = (i + 1) % n;
    for (std::uint32_t i = 0; i < n; ++i)
      if ((is_reflex_[i] = !convex(i))) reflex_.push_back(i);
    std::sort(reflex_.begin(), reflex_.end(), [&](auto a, auto b) { return at_[a].x < at_[b].x; });
    for (std::uint32_t i = 0; i < n; ++i) is_ear_[i] = ear(i);
  }

  /// Empty if the steps did not suffice.
  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::uint32_t left = size();
    triangles.reserve(left - 2);
    // From the second corner onward, so that a convex polygon becomes the fan of the first.
    for (std::uint32_t i = 1; left > 3; --left) {
      std::uint32_t tried = 0;
      for (; !is_ear_[i] && tried < left; ++tried) i = next_[i];
      spend(tried);
      if (!is_ear_[i]) i = min_bad(i, left);
      if (steps_left_ == 0) return {};
      triangles.push_back({before_[i], i, next_[i]});
      i = clip(i);
    }
    // The rest begins at its lowest corner, so that the fan keeps its first corner first.
    std::uint32_t first = triangles.empty() ? 0 : triangles.back()[0];
    for (const std::uint32_t other : {next_[first], before_[first]}) first = std::min(first, other);
    triangles.push_back({first, next_[first], before_[first]});
    return triangles;
  }

  std::uint64_t steps_left() const { return steps_left_; }

private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(at_.size()); }
  void spend(std::uint64_t steps) { steps_left_ -= std::min(steps, steps_left_); }
  bool convex(std::uint32_t i) const { return turn(at_[before_[i]], at_[i], at_[next_[i]]) > 0; }

  /// A convex corner whose triangle holds no other corner: only a reflex one can be in it. A corner at the same point
  /// as one of the triangle's, where a polygon touches itself (a hole with its bridge), does not count.
  bool ear(std::uint32_t i) {
    if (!convex(i) || steps_left_ == 0) return false;
    const Double2 a = at_[before_[i]], b = at_[i], c = at_[next_[i]];
    const double left = std::min({a.x, b.x, c.x}), right = std::max({a.x, b.x, c.x});
    auto near = std::lower_bound(reflex_.begin(), reflex_.end(), left, [&](auto r, double x) { return at_[r].x < x; });
    for (; near != reflex_.end() && at_[*near].x <= right; ++near) {
      spend(1);
      if (!is_reflex_[*near]) continue;
      const Double2 p = at_[*near];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  /// Without an ear the polygon touches or crosses itself, or has no area left: the corner that turns left the most.
  std::uint32_t min_bad(std::uint32_t start, std::uint32_t left) {
    spend(left);
    std::uint32_t best = start;
    double most = -HUGE_VAL;
    for (std::uint32_t tried = 0, i = start; tried < left; ++tried, i = next_[i])
      if (const double area = turn(at_[before_[i]], at_[i], at_[next_[i]]); area > most) most = area, best = i;
    return best;
  }

  /// Takes a corner out; returns the one behind it.
  std::uint32_t clip(std::uint32_t i) {
    if (is_reflex_[i]) no_longer_reflex(i);
    next_[before_[i]] = next_[i];
    before_[next_[i]] = before_[i];
    for (const std::uint32_t side : {before_[i], next_[i]})
      if (is_reflex_[side] && convex(side)) no_longer_reflex(side);
    for (const std::uint32_t side : {before_[i], next_[i]}) is_ear_[side] = ear(side);
    return next_[i];
  }

  /// The list is made anew whenever half of it is of no more use: what lies in a wide ear is then found without a walk
  /// past corners that have long become convex.
  void no_longer_reflex(std::uint32_t i) {
    is_reflex_[i] = false;
    if (2 * ++stale_ < reflex_.size()) return;
    std::erase_if(reflex_, [&](std::uint32_t r) { return !is_reflex_[r]; });
    stale_ = 0;
  }

  std::vector<Double2> at_;
  std::vector<std::uint32_t> before_, next_;
  std::vector<std::uint32_t> reflex_; // by x
  std::size_t stale_ = 0;             // how many of them are no longer reflex
  std::vector<char> is_ear_, is_reflex_;
  std::uint64_t steps_left_;
};

} // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Float3> polygon, std::uint64_t& steps_left) {
  const std::uint64_t free = 64 * std::uint64_t{polygon.size()};
  std::vector<Double2> flat(polygon.size());
  flatten(polygon, flat);
  EarClipper clipper(std::move(flat), free + steps_left);
  auto triangles = clipper.run();
  steps_left = std::min(steps_left, clipper.steps_left());
  return triangles;
}

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Float3> polygon) {
  std::uint64_t any_cut = std::numeric_limits<std::uint64_t>::max() / 2;
  return triangulate(polygon, any_cut);
}

bool is_fan(std::span<const Float3> polygon) {
  const std::size_t n = polygon.size();
  std::array<Double2, 8> flat;
  if (n > flat.size()) return false;
  flatten(polygon, std::span(flat).first(n));
  // Without a reflex corner every convex one is an ear; and so is the second, third … once those before are clipped.
  for (std::size_t i = 0; i < n; ++i)
    if (!(turn(flat[(i + n - 1) % n], flat[i], flat[(i + 1) % n]) > 0)) return false;
  for (std::size_t i = 2; i + 2 < n; ++i)
    if (!(turn(flat[0], flat[i], flat[i + 1]) > 0)) return false;
  return true;
}

} // namespace refraster
