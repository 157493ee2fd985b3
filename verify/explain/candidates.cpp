#include "verify/explain/candidates.h"

#include "raster/shade/opacity.h"
#include "raster/visibility/depth_range.h"
#include "raster/visibility/setup.h"
#include "raster/visibility/snapped_setup.h"
#include "verify/explain/fragment_story.h"

#include <algorithm>
#include <array>
#include <bit>

namespace refraster {
namespace {

constexpr int lanes = NumberTraits<Native<double>>::lanes;

/// What covers a sample, as set-up has it.
struct Covered {
  Side side;
  double z; // z / w
};

/// z / w at a sample, as the rasterizer has it.
double snapped_depth(const Geometry& geometry, const TriangleRef& ref, std::int32_t x, std::int32_t y) {
  using Row = Wide<double, lanes>;
  const auto corner = [&](std::size_t k) {
    return gather_corners<lanes>([&](int) -> const PlacedVertex& { return geometry.window.placed[ref.vertex[k]]; });
  };
  const auto t = set_up_snapped(corner(0), corner(1), corner(2));
  const Row dx = Row(static_cast<double>(x)) - t.corner[0].x, dy = Row(static_cast<double>(y)) - t.corner[0].y;
  return depth_plane(t).at(t.a[1] * dx + t.b[1] * dy, t.a[2] * dx + t.b[2] * dy)[0];
}

std::optional<Covered> snapped_cover(const Geometry& geometry, const TriangleRef& ref,
                                     const std::array<WindowVertex, 3>& v, std::int32_t x, std::int32_t y) {
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  if (x < left || x > right || y < top || y > bottom) return {};
  const std::optional<SnappedTriangle> triangle = set_up_snapped(v);
  if (!triangle) return {};
  for (const SnappedEdge& edge : triangle->edge)
    if (!edge.covers(x, y)) return {};
  const std::int64_t area = std::int64_t{v[1].x - v[0].x} * (v[2].y - v[0].y) -
                            std::int64_t{v[2].x - v[0].x} * (v[1].y - v[0].y); // y down: > 0 seen from behind
  return Covered{area > 0 ? Side::back : Side::front, snapped_depth(geometry, ref, x, y)};
}

std::array<Double4, 3> clip_corners(const FrameContext& context, const TriangleRef& ref) {
  const Mesh& mesh = *context.scene.objects[ref.object].mesh;
  std::array<Double4, 3> clip;
  for (std::size_t k = 0; k < 3; ++k)
    clip[k] = clip_position(context.geometry.transforms[ref.object], mesh.positions[mesh.triangles[ref.triangle][k]]);
  return clip;
}

std::optional<Covered> projective_cover(const FrameContext& context, const TriangleRef& ref,
                                        const std::array<WindowVertex, 3>& v, std::int32_t x, std::int32_t y) {
  const std::optional<ProjectiveTriangle> triangle =
      set_up_projective(v, clip_corners(context, ref), image_shape(context));
  if (!triangle) return {};
  for (int i = 0; i < triangle->pieces; ++i) {
    const ProjectivePiece& piece = triangle->piece[static_cast<std::size_t>(i)];
    if (piece.covers(x, y))
      return Covered{triangle->facing == Facing::back ? Side::back : Side::front, piece.depth(x, y)};
  }
  return {};
}

bool is_unsnapped(const std::array<WindowVertex, 3>& v) {
  return ((v[0].outcode | v[1].outcode | v[2].outcode) & outcode::unsnapped) != 0;
}
bool is_finite(const std::array<WindowVertex, 3>& v) {
  return ((v[0].outcode | v[1].outcode | v[2].outcode) & outcode::not_finite) == 0;
}
/// All corners on the outer side of one of the view's planes: never drawn.
bool is_outside(const std::array<WindowVertex, 3>& v) {
  return (v[0].outcode & v[1].outcode & v[2].outcode & outcode::sides) != 0;
}

CandidateFate fate_of(const Object& object, const Covered& covered, const std::optional<OpacityStory>& opacity,
                      bool is_seen) {
  if (is_seen) return CandidateFate::seen;
  if (covered.z < -1) return CandidateFate::before_near;
  if (!(covered.z < beyond_far)) return CandidateFate::beyond_far;
  if (object.cull == Cull::back && covered.side == Side::back) return CandidateFate::culled;
  if (opacity && opacity->value < opacity->threshold) return CandidateFate::cut_out;
  return CandidateFate::hidden;
}

/// Whether set-up of attributes knows the triangle.
bool has_weights(const FrameContext& context, std::uint32_t number, const std::array<WindowVertex, 3>& v) {
  if (!is_unsnapped(v)) return true;
  return context.bins.find_projective(number) != nullptr;
}

/// That a sample lies in.
int pixel_of(std::int32_t subpixel) {
  return subpixel >> std::countr_zero(static_cast<unsigned>(subpixels));
}

/// At the centre of the pixel of the sample (x, y), of a triangle that has weights.
std::optional<OpacityStory> opacity_of(const FrameContext& context, std::uint32_t number, const TriangleRef& ref,
                                       std::int32_t x, std::int32_t y) {
  const Material& material = material_of(context.scene.objects[ref.object], ref.triangle);
  if (!material.has_cut_outs()) return {};
  return OpacityStory{opacity_at(context, number, pixel_of(x), pixel_of(y)), material.opacity_threshold};
}

/// Calls visit(number, ref, window corners) with every triangle of finite corners.
void for_each_triangle(const FrameContext& context, auto&& visit) {
  TriangleFinder finder(context.scene, context.geometry);
  for (std::uint32_t number = 0; number < context.geometry.triangles(); ++number) {
    const TriangleRef ref = finder.at(number);
    const std::array<WindowVertex, 3> v = window_corners(context.geometry, ref);
    if (is_finite(v)) visit(number, ref, v);
  }
}

// Pixels from the sample.
struct Offset {
  double x = 0, y = 0;
  double squared() const { return x * x + y * y; }
};

/// The point of the segment from a to b that is nearest to 0.
Offset nearest_on(const Offset& a, const Offset& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(-(a.x * dx + a.y * dy) / squared, 0.0, 1.0) : 0;
  return {a.x + t * dx, a.y + t * dy};
}

/// The part of a triangle between the depth planes, by Sutherland and Hodgman, as offsets from a point of the window.
class Outline {
public:
  std::optional<Offset> nearest(const std::array<Double4, 3>& clip, int width, int height, double x, double y) {
    polygon_.assign(clip.begin(), clip.end());
    cut([](const Double4& p) { return p.z + p.w; });
    cut([](const Double4& p) { return p.w - p.z; });
    if (polygon_.empty()) return {};
    const auto offset = [&](const Double4& p) {
      return Offset{(p.x / p.w + 1) / 2 * width - x, (1 - p.y / p.w) / 2 * height - y};
    };
    std::optional<Offset> best;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      if (polygon_[i].w <= 0) return {};
      const Offset at = nearest_on(offset(polygon_[i]), offset(polygon_[(i + 1) % polygon_.size()]));
      if (!best || at.squared() < best->squared()) best = at;
    }
    return best;
  }

private:
  void cut(auto&& inside) {
    scratch_.clear();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Double4 &a = polygon_[i], &b = polygon_[(i + 1) % polygon_.size()];
      const double at_a = inside(a), at_b = inside(b);
      if (at_a >= 0) scratch_.push_back(a);
      if ((at_a >= 0) != (at_b >= 0)) scratch_.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    polygon_.swap(scratch_);
  }

  std::vector<Double4> polygon_, scratch_;
};

} // namespace

std::vector<NumberedCandidate> candidates_at(const FrameContext& context, std::int32_t x, std::int32_t y,
                                             std::optional<std::uint32_t> seen) {
  std::vector<NumberedCandidate> found;
  for_each_triangle(context, [&](std::uint32_t number, const TriangleRef& ref, const std::array<WindowVertex, 3>& v) {
    const std::optional<Covered> covered =
        is_unsnapped(v) ? projective_cover(context, ref, v, x, y) : snapped_cover(context.geometry, ref, v, x, y);
    if (!covered) return;
    CoveringTriangle candidate;
    candidate.of = named_triangle(context, number), candidate.side = covered->side;
    candidate.depth = covered->z * 0.5 + 0.5;
    if (has_weights(context, number, v)) {
      candidate.weights = corner_weights(context, number, x, y);
      candidate.opacity = opacity_of(context, number, ref, x, y);
    }
    candidate.fate = fate_of(context.scene.objects[ref.object], *covered, candidate.opacity, number == seen);
    found.push_back({number, std::move(candidate)});
  });
  std::stable_sort(found.begin(), found.end(), [](const NumberedCandidate& a, const NumberedCandidate& b) {
    return a.candidate.depth < b.candidate.depth;
  });
  return found;
}

std::vector<NearMiss> near_misses(const FrameContext& context, int px, int py, std::size_t most) {
  const double x = px + 0.5, y = py + 0.5;
  Outline outline;
  std::vector<std::optional<NearMiss>> of_object(context.scene.objects.size());
  const auto squared = [](const NearMiss& miss) { return Offset{miss.dx, miss.dy}.squared(); };
  for_each_triangle(context, [&](std::uint32_t number, const TriangleRef& ref, const std::array<WindowVertex, 3>& v) {
    if (is_outside(v)) return;
    std::optional<NearMiss>& best = of_object[ref.object];
    if (best && !is_unsnapped(v)) { // most triangles are farther away than their box shows
      const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
      const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
      const double dx = std::max({left / double{subpixels} - x, x - right / double{subpixels}, 0.0});
      const double dy = std::max({top / double{subpixels} - y, y - bottom / double{subpixels}, 0.0});
      if (Offset{dx, dy}.squared() > squared(*best)) return;
    }
    const std::array<Double4, 3> clip = clip_corners(context, ref);
    // Counter-clockwise as seen from the eye, also with corners behind it: the sign of det(x, y, w).
    const double facing = clip[0].x * (clip[1].y * clip[2].w - clip[2].y * clip[1].w) -
                          clip[0].y * (clip[1].x * clip[2].w - clip[2].x * clip[1].w) +
                          clip[0].w * (clip[1].x * clip[2].y - clip[2].x * clip[1].y);
    if (context.scene.objects[ref.object].cull == Cull::back && !(facing > 0)) return;
    const std::optional<Offset> at = outline.nearest(clip, context.options.width, context.options.height, x, y);
    if (at && (!best || at->squared() < squared(*best))) best = NearMiss{named_triangle(context, number), at->x, at->y};
  });
  std::vector<NearMiss> found;
  for (const std::optional<NearMiss>& miss : of_object)
    if (miss) found.push_back(*miss);
  std::stable_sort(found.begin(), found.end(),
                   [&](const NearMiss& a, const NearMiss& b) { return squared(a) < squared(b); });
  if (found.size() > most) found.resize(most);
  return found;
}

} // namespace refraster
