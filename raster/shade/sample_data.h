#pragma once
// One sample of one triangle in any Number: what raster/shade/interpolate.h reads instead of a packet's lanes. For 60
// digits and for bounds. The sample may lie anywhere in a range, if the Number has ranges, and so may the vertices'
// data.

#include "math/bounds/affine_functions.h"
#include "math/exact.h"
#include "raster/shade/corner_values.h"
#include "raster/shade/exact_pieces.h"
#include "raster/shade/interpolate.h"
#include "raster/visibility/snapped_setup.h"

#include <algorithm>
#include <array>
#include <optional>

namespace refraster {

/// How the values of edge functions are computed for T, before they are rounded to it once: from integers, so by a type
/// that holds those. `rounded` gives what T makes of the result. For a T of one's own: in T itself.
template <class T>
struct EdgeArithmetic {
  using Value = T;
  static Value whole(Int128 x) { return T(static_cast<double>(x)); }
  static T rounded(const Value& x) { return x; }
};
template <>
struct EdgeArithmetic<Exact> {
  using Value = Exact;
  static Value whole(Int128 x) {
    constexpr int low_bits = 60;
    const auto low = static_cast<std::int64_t>(x & ((Int128{1} << low_bits) - 1));
    return Exact(static_cast<std::int64_t>(x >> low_bits)) * Exact(0x1p60) + Exact(low);
  }
  static Exact rounded(const Value& x) { return x; }
};
template <class Budget>
struct EdgeArithmetic<Interval<Budget>> {
  using Value = Interval<DoubleArithmetic>;
  static Value whole(Int128 x) {
    const auto nearest = static_cast<double>(x);
    if (static_cast<Int128>(nearest) == x) return Value(nearest);
    return {interval_detail::step_down(nearest), interval_detail::step_up(nearest)};
  }
  static Interval<Budget> rounded(const Value& x) { return Interval<Budget>::computed({x.lo, x.hi}); }
};

template <class Budget>
struct EdgeArithmetic<Affine<Budget>> {
  using Value = Affine<DoubleArithmetic>;
  static Value whole(Int128 x) { return Value(EdgeArithmetic<Interval<DoubleArithmetic>>::whole(x)); }
  static Affine<Budget> rounded(const Value& x) { return x.template rounded_to<Budget>(); }
};
static_assert(first_row_symbol + position_row == static_cast<int>(Symbol::position) &&
              first_row_symbol + normal_row == static_cast<int>(Symbol::normal) &&
              first_row_symbol + uv_row == static_cast<int>(Symbol::uv) &&
              weights_symbol == static_cast<int>(Symbol::inverse_w));

/// What the vertex stage stored of a triangle's corners, as numbers of T.
template <Number T>
struct SampleCorners {
  std::array<Vec3<T>, 3> position, normal; // world space; normals of any length
  std::array<Vec2<T>, 3> uv;               // less whole repeats
  std::array<T, 3> inverse_w;              // of corners on the lattice
};

template <Number T>
class SampleData {
public:
  using Number = T;
  using Edge = EdgeArithmetic<T>;
  using EdgeValue = typename Edge::Value;

  /// Of the triangle of that number in the frame.
  SampleData(const FrameContext& context, std::uint32_t number)
      : context_(context), ref_(TriangleFinder(context.scene, context.geometry).at(number)) {
    const std::array<WindowVertex, 3> window = window_corners(context.geometry, ref_);
    if ((window[0].outcode | window[1].outcode | window[2].outcode) & outcode::unsnapped) {
      projective_ = &context.bins.projective_triangle(number);
      corner_ = projective_->corner;
      set_up_pieces(window);
    } else {
      snapped_ = set_up_snapped(window);
      corner_ = snapped_->corner;
    }
    set_rows(corners(window));
    if (context.uses.two_sided && is_turned(context, ref_, number)) turn_where(T(0) <= T(0));
  }

  /// To the sample at (x, y), in subpixels of the window, and as far from it as dx, dy say.
  void move_to(std::int32_t x, std::int32_t y, const EdgeValue& dx = EdgeValue(0), const EdgeValue& dy = EdgeValue(0)) {
    x_ = x, y_ = y;
    dx_ = dx, dy_ = dy;
  }

  // What a device may do otherwise: for bounds.

  /// From now on, component `r` of an attribute may be off by `error` wherever it is interpolated.
  void add_error(int r, double error) {
    const auto i = static_cast<std::size_t>(r);
    row_[i][0] += T(-error, error);
    error_[i] += error;
  }
  bool is_of_device() const { return block_.has_value(); }
  /// Where the pixel is in its block of 2 x 2, 0 or 1 to the right and down: from now on changes by one pixel are the
  /// differences between any two neighbours in the block, of which OpenGL leaves open which.
  void set_place_in_block(int column, int row) { block_ = {column, row}; }

  /// Whether normals are those of the other side anywhere.
  bool has_turned_normals() const { return turned_ && any(*turned_); }
  /// Of a two-sided object: normals are turned where this says, whatever side our triangle shows.
  void set_turned(const MaskOf<T>& turned) {
    if (turned_) turn_where(*turned_); // back
    turn_where(turned);
  }

  void take_differences(const EdgeValues<T>& edges, PacketBarycentrics<T>& result) const {
    if (!block_) return;
    const auto weights = [&](int column, int row) -> Barycentric<T> {
      const T dx(column - (*block_)[0]), dy(row - (*block_)[1]);
      std::array<T, 3> mu;
      for (std::size_t k = 0; k < 3; ++k)
        mu[k] = (edges.value[k] + dx * edges.right[k] + dy * edges.down[k]) * row_[k][3];
      const T sum = mu[0] + mu[1] + mu[2];
      return {mu[1] / sum, mu[2] / sum};
    };
    const Barycentric<T> at[2][2] = {{weights(0, 0), weights(1, 0)}, {weights(0, 1), weights(1, 1)}};
    const auto either = [](const Barycentric<T>& from1, const Barycentric<T>& to1, const Barycentric<T>& from2,
                           const Barycentric<T>& to2) -> Barycentric<T> {
      return {join(to1.b1 - from1.b1, to2.b1 - from2.b1), join(to1.b2 - from1.b2, to2.b2 - from2.b2)};
    };
    result.right = either(at[0][0], at[0][1], at[1][0], at[1][1]);
    result.down = either(at[0][0], at[1][0], at[0][1], at[1][1]);
  }
  /// The triangle's corners may be moved, so that it is stretched and turned by a matrix that is off from 1 by no more
  /// than this, below 1: from now on, what changes along the axes of the window is, too.
  void set_stretched(double by) { stretched_ = by / (1 - by); }
  void turn(Vec2<T>& right, Vec2<T>& down) const {
    if (stretched_ == 0) return;
    for (int c = 0; c < 2; ++c) {
      const T r = abs(right[c]), d = abs(down[c]);
      const double error = stretched_ * (r.hi + d.hi);
      right[c] += T(-error, error), down[c] += T(-error, error);
    }
  }
  /// Of the difference of two values of a component.
  T difference_error(int r) const {
    const double error = block_ ? 2 * error_[static_cast<std::size_t>(r)] : 0;
    return T(-error, error);
  }

  /// As PacketData's.
  const std::array<T, 4>& row(int r) const { return row_[static_cast<std::size_t>(r)]; }

  /// Of the three edge functions: the value at the sample, and the change by one pixel to the right and down.
  EdgeValues<T> edges() const {
    std::array<EdgeValue, 3> value, right, down;
    if (snapped_) {
      for (std::size_t k = 0; k < 3; ++k) at(snapped_->edge[k], value[k], right[k], down[k]);
    } else {
      projective_edges(value, right, down);
    }
    EdgeValues<T> edges;
    for (std::size_t k = 0; k < 3; ++k) {
      edges.value[k] = Edge::rounded(value[k]);
      edges.right[k] = Edge::rounded(right[k] * EdgeValue(subpixels));
      edges.down[k] = Edge::rounded(down[k] * EdgeValue(subpixels));
    }
    return edges;
  }

  /// What normals are multiplied by, so that no digit of them is lost.
  double normal_factor() const { return normal_factor_; }

  /// Of the triangle.
  std::uint32_t object() const { return ref_.object; }
  /// In the object's mesh.
  std::uint32_t triangle() const { return ref_.triangle; }

  bool may_have_texture_coordinates() const {
    const Mesh& mesh = *context_.scene.objects[ref_.object].mesh;
    return has_uvs(mesh, mesh.triangles[ref_.triangle]);
  }

  /// The triangle's own normal, of any length; 0 where it has none.
  Vec3<T> own_normals(const FrameContext&) const {
    const Mesh& mesh = *context_.scene.objects[ref_.object].mesh;
    const auto corner = [&](std::size_t k) { return as<T>(Double3(mesh.positions[mesh.triangles[ref_.triangle][k]])); };
    const Vec3<T> n = cross(corner(1) - corner(0), corner(2) - corner(0));
    const Double3x3& m = context_.geometry.transforms[ref_.object].world_from_normal;
    const Vec3<T> own = as<T>(m[0]) * n.x + as<T>(m[1]) * n.y + as<T>(m[2]) * n.z;
    return turned_ ? select<T>(*turned_, -own, own) : own;
  }

private:
  struct Piece {
    std::array<EdgeValue, 3> value, a, b;           // of the edge function opposite vertex v, at the sample; its slopes
    std::array<std::array<EdgeValue, 3>, 3> factor; // [v][k]
  };

  template <class SomeEdge>
  void at(const SomeEdge& edge, EdgeValue& value, EdgeValue& a, EdgeValue& b) const {
    a = Edge::whole(edge.a), b = Edge::whole(edge.b);
    value = Edge::whole(edge.at(x_, y_)) + a * dx_ + b * dy_;
  }

  SampleCorners<T> corners(const std::array<WindowVertex, 3>& window) {
    SampleCorners<T> result;
    const Mesh& mesh = *context_.scene.objects[ref_.object].mesh;
    const std::array<WorldVertex, 3> submitted = world_corners(context_.geometry, ref_);
    const std::array<WorldVertex, 3> world{submitted[corner_[0]], submitted[corner_[1]], submitted[corner_[2]]};
    const double scale = normal_factor_ = normal_scale(world[0], world[1], world[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      result.position[k] = as<T>(world[k].position);
      result.normal[k] = as<T>(world[k].normal * scale);
      result.inverse_w[k] = as<T>(window[corner_[k]].inverse_w);
      result.uv[k] = Vec2<T>(T(0));
    }
    if (!may_have_texture_coordinates()) return result;
    const auto& indices = mesh.triangles[ref_.triangle];
    const Repeats repeats = repeats_of(context_, ref_.object, ref_.triangle);
    for (int c = 0; c < 2; ++c) {
      const UvComponent uv =
          uv_component(mesh, {indices[corner_[0]], indices[corner_[1]], indices[corner_[2]]}, c, repeats);
      for (std::size_t k = 0; k < 3; ++k) result.uv[k][c] = as<T>(uv.value[k]);
    }
    return result;
  }

  void turn_where(const MaskOf<T>& turned) {
    for_each_turned_row(*context_.scene.objects[ref_.object].mesh, [&](std::size_t r) {
      for (std::size_t column = 0; column < 3; ++column) {
        T& value = row_[r][column];
        value = select(turned, -value, value);
      }
    });
    turned_ = turned;
  }

  /// The rows of AttributeSetup.
  void set_rows(const SampleCorners<T>& corner) {
    const auto set = [this](int r, const T& f0, const T& f1, const T& f2) {
      row_[static_cast<std::size_t>(r)] = {f0, f1 - f0, f2 - f0, T(0)};
    };
    for (int c = 0; c < 3; ++c) {
      set(position_row + c, corner.position[0][c], corner.position[1][c], corner.position[2][c]);
      set(normal_row + c, corner.normal[0][c], corner.normal[1][c], corner.normal[2][c]);
    }
    for (int c = 0; c < 2; ++c) {
      const auto& uv = corner.uv;
      set(uv_row + c, uv[0][c], uv[1][c], uv[2][c]);
      row_[static_cast<std::size_t>(min_uv_row + c)][3] = min(uv[0][c], min(uv[1][c], uv[2][c]));
      row_[static_cast<std::size_t>(max_uv_row + c)][3] = max(uv[0][c], max(uv[1][c], uv[2][c]));
    }
    const Mesh& mesh = *context_.scene.objects[ref_.object].mesh;
    const auto& indices = mesh.triangles[ref_.triangle];
    for_each_further_attribute(
        mesh, context_.geometry.transforms[ref_.object],
        {indices[corner_[0]], indices[corner_[1]], indices[corner_[2]]}, [&](int row, const auto& value) {
          for (std::size_t c = 0; c < value[0].size(); ++c)
            set(row + static_cast<int>(c), as<T>(value[0][c]), as<T>(value[1][c]), as<T>(value[2][c]));
        });
    // Of projective triangles, edges() bring their weights.
    const std::array<T, 3> weight =
        snapped_ ? perspective_weights(corner.inverse_w) : std::array<T, 3>{T(1), T(1), T(1)};
    for (std::size_t k = 0; k < 3; ++k) {
      row_[k][3] = weight[k];
      // Lanes take no weight below this (attribute_setup.cpp): bounds hold it either way.
      if constexpr (!NumberTraits<T>::decides) {
        constexpr bool is_single = NumberTraits<T>::largest < std::numeric_limits<double>::max();
        row_[k][3] = join(row_[k][3], max(row_[k][3], T(min_weight<std::conditional_t<is_single, float, double>>)));
      }
    }
  }

  void set_up_pieces(const std::array<WindowVertex, 3>& window) {
    if constexpr (std::same_as<T, Exact>) {
      const Mesh& mesh = *context_.scene.objects[ref_.object].mesh;
      std::array<Double4, 3> clip;
      for (std::size_t k = 0; k < 3; ++k)
        clip[k] =
            clip_position(context_.geometry.transforms[ref_.object], mesh.positions[mesh.triangles[ref_.triangle][k]]);
      exact_ = exact_pieces(window, clip, image_shape(context_));
    }
  }

  Piece piece(std::size_t p) const {
    Piece result;
    if constexpr (std::same_as<T, Exact>) {
      const EdgeValue x = EdgeValue(x_) + dx_, y = EdgeValue(y_) + dy_;
      for (std::size_t v = 0; v < 3; ++v) {
        const ExactPiece::Edge& edge = exact_[p].edge[v];
        result.a[v] = edge.a, result.b[v] = edge.b;
        result.value[v] = edge.a * x + edge.b * y + edge.c;
        result.factor[v] = exact_[p].factor[v];
      }
    } else {
      const ProjectivePiece& from = projective_->piece[p];
      for (std::size_t v = 0; v < 3; ++v) {
        at(from.edge[v], result.value[v], result.a[v], result.b[v]);
        // SplitEdge::at rounds its sum of three pieces, and three times within it: four roundings at most.
        if constexpr (requires { result.value[v].widened(0.0); }) result.value[v] = result.value[v].widened(0x1p-51);
        for (std::size_t k = 0; k < 3; ++k)
          result.factor[v][k] = EdgeValue(from.weight[v]) * EdgeValue(from.fraction[v][k]);
      }
    }
    return result;
  }

  /// projective_values (raster/shade/projective_edges.h), scaled by a power of two as there.
  void projective_edges(std::array<EdgeValue, 3>& value, std::array<EdgeValue, 3>& right,
                        std::array<EdgeValue, 3>& down) const {
    const auto sums = [&](const Piece& piece, const std::array<EdgeValue, 3>& of, std::array<EdgeValue, 3>& into) {
      for (std::size_t k = 0; k < 3; ++k) {
        into[k] = EdgeValue(0);
        for (std::size_t v = 0; v < 3; ++v) into[k] += of[v] * piece.factor[v][k];
      }
    };
    const Piece first = piece(0);
    sums(first, first.value, value), sums(first, first.a, right), sums(first, first.b, down);
    if (projective_->pieces == 2) {
      const Piece second = piece(1);
      std::array<EdgeValue, 3> value2, right2, down2;
      sums(second, second.value, value2), sums(second, second.a, right2), sums(second, second.b, down2);
      const bool owns_ties = projective_->piece[0].edge[1].owns_ties();
      const EdgeValue& between = first.value[1];
      const auto in_first = owns_ties ? between >= EdgeValue(0) : between > EdgeValue(0);
      for (std::size_t k = 0; k < 3; ++k) {
        value[k] = select(in_first, value[k], value2[k]);
        right[k] = select(in_first, right[k], right2[k]);
        down[k] = select(in_first, down[k], down2[k]);
      }
    }
    if constexpr (requires { value[0].hi; }) { // bounds: into the range of float, as lanes are
      const double largest = std::max({abs(value[0]).hi, abs(value[1]).hi, abs(value[2]).hi});
      const EdgeValue scale(reciprocal_binade(largest));
      for (std::size_t k = 0; k < 3; ++k) value[k] *= scale, right[k] *= scale, down[k] *= scale;
    }
  }

  const FrameContext& context_;
  TriangleRef ref_;
  std::optional<SnappedTriangle> snapped_;
  const ProjectiveTriangle* projective_ = nullptr;
  std::vector<ExactPiece> exact_; // of a projective triangle, if T is Exact
  std::array<std::uint8_t, 3> corner_{};
  std::array<std::array<T, 4>, attribute_rows> row_;
  std::int32_t x_ = 0, y_ = 0;
  EdgeValue dx_{}, dy_{};
  double normal_factor_ = 1, stretched_ = 0;
  std::optional<MaskOf<T>> turned_; // where normals are, if the object is two-sided
  std::array<double, attribute_rows> error_{};
  std::optional<std::array<int, 2>> block_;
};

template <Derivatives, class T>
EdgeValues<T> edge_values(const SampleData<T>& data) {
  return data.edges();
}

} // namespace refraster
