#pragma once
// A tree of boxes over the triangles of a scene: which of them a ray may cross.

#include <refraster/memory.h>

#include "raster/buffer.h"
#include "raster/lanes.h"
#include "raster/shadow/shadow_ray.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace refraster {

/// Triangles in the world.
struct WorldMesh {
  Buffer<Double3> position;
  Buffer<std::array<std::uint32_t, 3>> triangle; // of positions

  static std::uint64_t bytes(std::uint64_t positions, std::uint64_t triangles) {
    return positions * sizeof(Double3) + triangles * sizeof(std::array<std::uint32_t, 3>);
  }
  WorldTriangle at(std::size_t i) const {
    const auto& t = triangle[i];
    return {position[t[0]], position[t[1]], position[t[2]]};
  }
};

/// Four boxes by the surface area heuristic, and four in each of them, down to a few triangles. A box holds its
/// triangles whatever was rounded, and a ray that crosses one of them meets the box: so what a ray crosses does not
/// depend on the tree. Nodes lie in memory as they were built, which the number of threads has a part in.
///
/// Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007: bins along each axis.
class TriangleTree {
public:
  /// Over the triangles of `mesh` with finite corners, at most 2^31 - 1, which are not kept: what is needed is copied.
  /// Takes time in proportion to n log n, in parallel.
  void build(const WorldMesh& mesh, int threads);

  /// What building needs beside the mesh, at its peak.
  static std::uint64_t bytes_to_build(std::uint64_t triangles);
  /// What it has of that from before.
  std::uint64_t bytes_held() const;

  /// Whether the ray crosses any triangle but number `own`.
  bool any_crosses(const WorldMesh& mesh, const ShadowRay& ray, std::optional<std::uint32_t> own) const {
    return visit(ray, [&](std::uint32_t number) { return (!own || number != *own) && ray.crosses(mesh.at(number)); });
  }

  /// The lowest number of those that it crosses, but for `own`.
  std::optional<std::uint32_t> first_crossed(const WorldMesh& mesh, const ShadowRay& ray,
                                             std::optional<std::uint32_t> own) const {
    std::optional<std::uint32_t> first;
    visit(ray, [&](std::uint32_t number) {
      if ((!own || number != *own) && (!first || number < *first) && ray.crosses(mesh.at(number))) first = number;
      return false;
    });
    return first;
  }

  /// Calls body(number) for each triangle whose box the ray meets, and for some others, until it returns true. Whether
  /// it did.
  template <class Body>
  bool visit(const ShadowRay& ray, Body&& body) const;

private:
  friend class TriangleTreeBuilder;

  static constexpr int width = 4; // boxes of a node
  static constexpr int max_leaf = 4;

  /// What is in one of a node's boxes: a node, or triangles first, first + 1 … of `number_`.
  struct Child {
    static constexpr std::uint32_t leaf = std::uint32_t{1} << 31;
    std::uint32_t first = leaf; // a node's number; or that of a triangle, plus `leaf`
    std::uint32_t triangles = 0;

    bool is_leaf() const { return first & leaf; }
  };
  struct Node {
    float bound[2][3][width]; // least and greatest x, y, z; of a box without triangles the least is infinite
    Child child[width];
  };
  static_assert(sizeof(Node) == 128);

  /// What a ray meets boxes with.
  struct Slabs;

  std::vector<Node> nodes_;      // the first is the root; none without triangles
  Buffer<std::uint32_t> number_; // of triangles, in the order of leaves
};

/// Per axis, t where the ray passes a plane: (plane - origin) factor. The origin is moved by what it may be off, toward
/// where boxes become larger.
///
/// t is off by four roundings, of the difference, the direction, its reciprocal and the product, and by less than the
/// smallest normal number: `stretch` and `tiny` are more than that of two. Where the reciprocal is no normal number the
/// axis says nothing: not a number, which loses all comparisons.
struct TriangleTree::Slabs {
  using T = Wide<double, width>;
  struct Axis {
    int near_side = 0; // which bound is passed first
    double near_origin = 0, far_origin = 0, factor = 0;
  };
  static constexpr double stretch = 1 + 16 * unit_roundoff, tiny = std::numeric_limits<double>::min();

  std::array<Axis, 3> axis;
  double end;

  explicit Slabs(const ShadowRay& ray) : end(ray.end()) {
    for (int k = 0; k < 3; ++k) {
      const double d = ray.direction()[k], size = abs(d), low = ray.origin()[k] - ray.error(),
                   high = ray.origin()[k] + ray.error();
      Axis& a = axis[static_cast<std::size_t>(k)];
      const bool forward = d >= 0;
      a.near_side = forward ? 0 : 1;
      a.near_origin = forward ? high : low, a.far_origin = forward ? low : high;
      if (size == 0) a.factor = std::numeric_limits<double>::infinity();
      else if (size >= 0x1p-1000 && size <= 0x1p1000) a.factor = 1 / d;
      else a.factor = std::numeric_limits<double>::quiet_NaN();
    }
  }

  /// Which boxes the ray meets: a bit each.
  std::uint32_t met(const Node& node) const {
    T first(0.0), last(end);
    for (std::size_t k = 0; k < 3; ++k) {
      const Axis& a = axis[k];
      const auto plane = [&](int side) {
        const auto bounds = load_lanes<VectorOf<float, width>>(node.bound[side][k]);
        return T(__builtin_convertvector(bounds, typename T::Lanes));
      };
      const T enters = (plane(a.near_side) - T(a.near_origin)) * T(a.factor);
      const T leaves = (plane(1 - a.near_side) - T(a.far_origin)) * T(a.factor);
      first = max(enters, first), last = min(leaves, last); // what is not a number counts for nothing
    }
    return lane_set(first <= last * T(stretch) + T(tiny));
  }
};

template <class Body>
bool TriangleTree::visit(const ShadowRay& ray, Body&& body) const {
  if (nodes_.empty() || !ray.is_defined()) return false;
  const Slabs slabs(ray);
  // Three children of each node wait while the fourth is looked into. Nodes are at most half as deep as the splits of
  // the builder: max_depth there.
  std::uint32_t waiting[128];
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[waiting[--count]];
    for (std::uint32_t met = slabs.met(node); met != 0; met &= met - 1) {
      const Child& child = node.child[std::countr_zero(met)];
      if (!child.is_leaf()) {
        waiting[count++] = child.first;
        continue;
      }
      const std::uint32_t begin = child.first - Child::leaf;
      for (std::uint32_t i = begin; i < begin + child.triangles; ++i)
        if (body(number_[i])) return true;
    }
  }
  return false;
}

} // namespace refraster
