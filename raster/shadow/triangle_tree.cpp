#include "raster/shadow/triangle_tree.h"

#include "raster/parallel.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>

namespace refraster {
namespace {

using Floats = Wide<float, 4>; // x, y, z, and something that is never looked at

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float largest_float = std::numeric_limits<float>::max();

struct Box {
  Floats least{infinite}, greatest{-infinite};

  void add(const Box& other) { least = min(least, other.least), greatest = max(greatest, other.greatest); }
  /// Half of its surface, or something else that is not finite.
  float half_area() const {
    const Floats d = greatest - least;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

/// A triangle's box and its number, in two registers. The number's halves stand in the significands of numbers near 1,
/// so that no arithmetic on registers meets a subnormal, which takes a hundred times as long.
struct BoxedTriangle {
  Floats least, greatest;

  static constexpr std::uint32_t one = 0x3f800000, half = 0xffff;

  static BoxedTriangle of(const Box& box, std::uint32_t number) {
    BoxedTriangle result{box.least, box.greatest};
    result.least.set(3, std::bit_cast<float>(one | (number & half)));
    result.greatest.set(3, std::bit_cast<float>(one | number >> 16));
    return result;
  }
  std::uint32_t number() const {
    return (std::bit_cast<std::uint32_t>(least[3]) & half) | (std::bit_cast<std::uint32_t>(greatest[3]) & half) << 16;
  }
  Box box() const { return {least, greatest}; }
  /// A quarter of the sum of both ends, which is finite, and so is the difference of two.
  Floats middle() const {
    const Floats far(largest_float);
    return max(least, -far) * Floats(0.25f) + min(greatest, far) * Floats(0.25f);
  }
};

/// The float before f, which is finite, without libm.
float before(float f) {
  if (f == 0) return -std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(f) + (f > 0 ? -1 : 1));
}

/// The largest float that is not above x, and the smallest that is not below.
float rounded_down(double x) {
  constexpr double largest = static_cast<double>(largest_float);
  const auto f = static_cast<float>(std::clamp(x, -largest, largest));
  return static_cast<double>(f) > x ? before(f) : f;
}
float rounded_up(double x) {
  return -rounded_down(-x);
}

bool is_finite(const WorldTriangle& triangle) {
  double sum = 0; // 0, or not a number
  for (const Double3& p : triangle) sum += 0 * p.x + 0 * p.y + 0 * p.z;
  return sum == 0;
}

Box box_of(const WorldTriangle& t) {
  Box box{Floats(0.0f), Floats(0.0f)};
  for (int c = 0; c < 3; ++c) {
    box.least.set(c, rounded_down(std::min({t[0][c], t[1][c], t[2][c]})));
    box.greatest.set(c, rounded_up(std::max({t[0][c], t[1][c], t[2][c]})));
  }
  return box;
}

/// A part of all triangles, and the boxes of them and of their middles.
struct Part {
  std::size_t begin = 0, end = 0;
  Box box, middles;
  int depth = 0;

  std::size_t count() const { return end - begin; }
};

/// Above this depth of splits in two, parts are halved: so no more than 31 splits follow.
constexpr int max_depth = 48;

} // namespace

/// Splits parts in two, twice for each node.
class TriangleTreeBuilder {
public:
  TriangleTreeBuilder(TriangleTree& tree, const WorldMesh& mesh, int threads)
      : tree_(tree), mesh_(mesh), threads_(threads) {}

  void build() {
    const Part all = box_triangles();
    tree_.nodes_.clear();
    tree_.number_.resize_uninitialized(all.count());
    if (all.count() == 0) return;
    // The upper nodes one after the other, and what is below them in parallel. A part of it is so small that all
    // threads are through at about the same time.
    constexpr std::size_t parts_of_thread = 16, min_part = 4096;
    small_ = threads_ == 1 ? all.count()
                           : std::max(min_part, all.count() / (parts_of_thread * static_cast<std::size_t>(threads_)));
    std::vector<Node>& top = tree_.nodes_;
    std::vector<Task> tasks;
    add_node(all, top, &tasks);
    std::vector<std::vector<Node>> below(tasks.size());
    parallel_for(threads_, tasks.size(), [&](std::size_t i, int) { add_node(tasks[i].part, below[i], nullptr); });
    append(top, tasks, below);
    for_pieces(all.count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) tree_.number_[i] = triangles_[i].number();
    });
  }

private:
  using Node = TriangleTree::Node;
  using Child = TriangleTree::Child;

  /// A node that is made later, and where its number goes.
  struct Task {
    Part part;
    std::size_t node = 0;
    int child = 0;
  };

  void for_pieces(std::size_t count, const auto& body) const {
    constexpr std::size_t piece = 1 << 14;
    parallel_for(threads_, (count + piece - 1) / piece,
                 [&](std::size_t i, int) { body(i * piece, std::min(count, (i + 1) * piece)); });
  }

  /// Fills triangles_: first all, each in its place, then without those that are not finite.
  Part box_triangles() {
    const std::size_t count = mesh_.triangle.size();
    triangles_.resize_uninitialized(count);
    std::atomic<bool> any_left_out{false};
    for_pieces(count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const WorldTriangle t = mesh_.at(i);
        Box box; // without points
        if (is_finite(t)) [[likely]]
          box = box_of(t);
        else any_left_out = true;
        triangles_[i] = BoxedTriangle::of(box, static_cast<std::uint32_t>(i));
      }
    });
    BoxedTriangle* const first = triangles_.data();
    BoxedTriangle* last = first + count;
    if (any_left_out)
      last = std::remove_if(first, last, [](const BoxedTriangle& t) { return t.least[0] > t.greatest[0]; });
    return bounded(0, static_cast<std::size_t>(last - first), 0);
  }

  Part bounded(std::size_t begin, std::size_t end, int depth) const {
    Part part{begin, end, {}, {}, depth};
    for (std::size_t i = begin; i < end; ++i) {
      const Floats middle = triangles_[i].middle();
      part.box.add(triangles_[i].box()), part.middles.add({middle, middle});
    }
    return part;
  }

  /// Adds the node of a part, and those below; where `later`, what is small is left for that.
  std::uint32_t add_node(const Part& part, std::vector<Node>& nodes, std::vector<Task>* later) {
    const auto number = nodes.size();
    nodes.emplace_back();
    Part parts[TriangleTree::width];
    int count = 0;
    const auto put = [&](const Part& p) { parts[count++] = p; };
    const auto put_halves = [&](const Part& p) {
      if (p.count() <= TriangleTree::max_leaf) return put(p);
      const auto [left, right] = split(p);
      put(left), put(right);
    };
    if (part.count() <= TriangleTree::max_leaf) {
      put(part);
    } else {
      const auto [left, right] = split(part);
      put_halves(left), put_halves(right);
    }
    for (int i = 0; i < TriangleTree::width; ++i) {
      const Part& p = parts[i];
      for (int c = 0; c < 3; ++c) {
        nodes[number].bound[0][c][i] = p.box.least[c];
        nodes[number].bound[1][c][i] = p.box.greatest[c];
      }
      Child child{Child::leaf + static_cast<std::uint32_t>(p.begin), static_cast<std::uint32_t>(p.count())};
      if (p.count() > TriangleTree::max_leaf) {
        if (later && p.count() <= small_) later->push_back({p, number, i});
        else child = {add_node(p, nodes, later), 0};
      }
      nodes[number].child[i] = child;
    }
    return static_cast<std::uint32_t>(number);
  }

  /// Two parts of one of at least two triangles; neither is empty.
  std::pair<Part, Part> split(const Part& part) {
    if (part.depth < max_depth)
      if (const auto parts = split_by_bins(part)) return *parts;
    const std::size_t middle = part.begin + part.count() / 2;
    return {bounded(part.begin, middle, part.depth + 1), bounded(middle, part.end, part.depth + 1)};
  }

  /// Of the cheapest of the planes between bins. Nothing where all middles are in one place, or boxes are too large for
  /// their areas to be told.
  std::optional<std::pair<Part, Part>> split_by_bins(const Part& part) {
    constexpr int bins = 16;
    const Floats extent = part.middles.greatest - part.middles.least;
    Floats factor(0.0f);
    constexpr float min_extent = 0x1p-100f;
    for (int c = 0; c < 3; ++c)
      if (extent[c] > min_extent) factor.set(c, (bins * (1 - 0x1p-20f)) / extent[c]);
    using Ints = VectorOf<std::int32_t, 4>;
    const auto bins_of = [&](const BoxedTriangle& t) {
      return __builtin_convertvector(((t.middle() - part.middles.least) * factor).v, Ints);
    };
    struct Bin {
      Box box;
      std::uint32_t count = 0;
    };
    Bin bin[3][bins];
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const BoxedTriangle& t = triangles_[i];
      const Ints at = bins_of(t);
      for (int c = 0; c < 3; ++c) {
        Bin& of = bin[c][at[c]];
        of.box.add(t.box()), ++of.count;
      }
    }
    float cheapest = infinite;
    int axis = -1, first_right = 0;
    for (int c = 0; c < 3; ++c) {
      if (!(extent[c] > min_extent)) continue;
      float right_cost[bins];
      Box box;
      std::uint32_t count = 0;
      for (int b = bins - 1; b > 0; --b) {
        box.add(bin[c][b].box), count += bin[c][b].count;
        right_cost[b] = count == 0 ? 0 : box.half_area() * static_cast<float>(count);
      }
      box = {}, count = 0;
      for (int b = 1; b < bins; ++b) {
        box.add(bin[c][b - 1].box), count += bin[c][b - 1].count;
        if (count == 0 || count == part.count()) continue;
        const float cost = box.half_area() * static_cast<float>(count) + right_cost[b];
        if (cost < cheapest) cheapest = cost, axis = c, first_right = b;
      }
    }
    if (axis < 0) return std::nullopt;

    Part left{part.begin, part.begin, {}, {}, part.depth + 1}, right{part.end, part.end, {}, {}, part.depth + 1};
    while (left.end < right.begin) {
      const BoxedTriangle t = triangles_[left.end];
      const Floats middle = t.middle();
      Part& to = bins_of(t)[axis] < first_right ? left : right;
      to.box.add(t.box()), to.middles.add({middle, middle});
      if (&to == &left) ++left.end;
      else std::swap(triangles_[left.end], triangles_[--right.begin]);
    }
    return std::pair{left, right};
  }

  /// Puts the nodes of the tasks behind those that wait for them.
  static void append(std::vector<Node>& nodes, std::span<const Task> tasks, std::vector<std::vector<Node>>& below) {
    std::size_t total = nodes.size();
    for (const auto& some : below) total += some.size();
    nodes.reserve(total);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(nodes.size());
      nodes[tasks[i].node].child[tasks[i].child] = {first, 0};
      for (Node& node : below[i]) {
        for (Child& child : node.child)
          if (!child.is_leaf()) child.first += first;
        nodes.push_back(node);
      }
      below[i] = {};
    }
  }

  TriangleTree& tree_;
  const WorldMesh& mesh_;
  int threads_;
  std::size_t small_ = 0;
  Buffer<BoxedTriangle> triangles_;
};

void TriangleTree::build(const WorldMesh& mesh, int threads) {
  TriangleTreeBuilder(*this, mesh, threads).build();
}

std::uint64_t TriangleTree::bytes_to_build(std::uint64_t triangles) {
  // Leaves hold two triangles and more, and nodes three leaves.
  return triangles * (sizeof(BoxedTriangle) + sizeof(Node) / 4 + sizeof(std::uint32_t));
}

std::uint64_t TriangleTree::bytes_held() const {
  return nodes_.capacity() * sizeof(Node) + number_.size() * sizeof(std::uint32_t);
}

} // namespace refraster
