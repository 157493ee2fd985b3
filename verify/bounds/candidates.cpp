#include "verify/bounds/candidates.h"

#include "raster/parallel.h"
#include "verify/bounds/pixel_bounds.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace refraster {
namespace {

/// Which of the asked pixels lie in a rectangle: a row's are found in a moment.
class PixelIndex {
public:
  PixelIndex(const std::vector<PixelPlace>& pixels, int height) : of_row_(static_cast<std::size_t>(height) + 1) {
    for (const PixelPlace& p : pixels) ++of_row_[static_cast<std::size_t>(p.y) + 1];
    std::partial_sum(of_row_.begin(), of_row_.end(), of_row_.begin());
    sorted_.resize(pixels.size());
    std::vector<std::uint32_t> next(of_row_.begin(), of_row_.end() - 1);
    for (std::uint32_t i = 0; i < pixels.size(); ++i)
      sorted_[next[static_cast<std::size_t>(pixels[i].y)]++] = {pixels[i].x, i};
    for (int y = 0; y < height; ++y) std::sort(row_begin(y), row_begin(y + 1));
  }

  /// visit(x, y, index in the list) for each in the rectangle.
  template <class Visit>
  void for_each_in(const PixelRect& box, const Visit& visit) const {
    for (int y = box.y; y < box.y + box.height; ++y) {
      const auto end = row_begin(y + 1);
      for (auto at = std::lower_bound(row_begin(y), end, std::pair(box.x, std::uint32_t{0}));
           at != end && at->first < box.x + box.width; ++at)
        visit(at->first, y, at->second);
    }
  }

private:
  using Entries = std::vector<std::pair<int, std::uint32_t>>;
  Entries::iterator row_begin(int y) { return sorted_.begin() + of_row_[static_cast<std::size_t>(y)]; }
  Entries::const_iterator row_begin(int y) const { return sorted_.begin() + of_row_[static_cast<std::size_t>(y)]; }

  std::vector<std::uint32_t> of_row_; // where each row begins
  Entries sorted_;
};

struct Found {
  std::uint32_t pixel = 0;
  Candidate candidate;
};

/// Whether a device may, and must, leave out a triangle of a material with cut-outs. The threshold is rounded to float
/// on its way there: by half an ulp of 1 at most, as it is no more than 1.
enum class CutOut { no, maybe, yes };
CutOut cut_out(const DeviceFrame& frame, const DeviceTriangle& triangle, int x, int y, double threshold) {
  constexpr double rounding = static_cast<double>(std::numeric_limits<float>::epsilon()) / 2;
  const ValueRange opacity = opacity_bounds(frame, triangle, x, y);
  if (opacity.lo >= threshold + rounding) return CutOut::no;
  return opacity.hi < threshold - rounding ? CutOut::yes : CutOut::maybe;
}

/// Of one triangle, whatever else is there.
void look_at(const DeviceFrame& frame, const PixelIndex& index, std::uint32_t number, SamplePosition sample,
             std::vector<Found>& found) {
  const DeviceTriangle triangle(frame, number);
  if (!triangle.is_seen()) return;
  const bool culls = frame.scene().objects[triangle.ref().object].cull == Cull::back;
  if (culls && !triangle.may_face_front()) return;
  const bool may_be_culled = culls && triangle.may_face_back();
  const Material& material = material_of(frame.scene().objects[triangle.ref().object], triangle.ref().triangle);
  const bool has_cut_outs = material.has_cut_outs();
  index.for_each_in(triangle.pixels(), [&](int x, int y, std::uint32_t pixel) {
    const double sample_x = x + sample.x / double{subpixels}, sample_y = y + sample.y / double{subpixels};
    const Coverage coverage = triangle.coverage(sample_x, sample_y);
    if (coverage.certainty == Coverage::Certainty::outside) return;
    const ValueRange depth = triangle.depth(sample_x, sample_y);
    if (depth.hi < 0 || depth.lo > 1) return;
    const CutOut cut_away = has_cut_outs ? cut_out(frame, triangle, x, y, material.opacity_threshold) : CutOut::no;
    if (cut_away == CutOut::yes) return;
    const bool cut = depth.lo < 0 || depth.hi > 1;
    // What may be cut off, culled or cut out may be missing whatever its neighbours do: its edges are shared with none.
    const bool may_be_missing = cut || may_be_culled || cut_away == CutOut::maybe;
    Candidate candidate{number, coverage.certainty == Coverage::Certainty::inside && !may_be_missing,
                        coverage.ambiguous_edges, cut_away == CutOut::maybe, depth};
    if (may_be_missing) candidate.ambiguous_edges = 8;
    found.push_back({pixel, candidate});
  });
}

/// Triangles of one sample that share edges: joined into components, of which each either covers it for certain or not.
class SharedEdges {
public:
  SharedEdges(const DeviceFrame& frame, const std::vector<Candidate>& candidates) {
    for (const Candidate& c : candidates) {
      if (c.certain) continue;
      const DeviceTriangle triangle(frame, c.number);
      Member& member = members_.emplace_back();
      member.depth = c.depth, member.unmatched = c.ambiguous_edges, member.object = triangle.ref().object;
      member.facing = triangle.may_face_front() && triangle.may_face_back() ? 0 : triangle.may_face_front() ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k) member.corner[k] = triangle.mesh_position(k);
      member.root = members_.size() - 1;
    }
    for (std::size_t i = 0; i < members_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) match(members_[i], members_[j]);
  }

  /// The farthest that something is for certain; infinite if nothing is.
  double certain_depth() {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t root = 0; root < members_.size(); ++root) {
      if (find(root) != root) continue;
      bool complete = true;
      double far = 0;
      for (std::size_t i = 0; i < members_.size(); ++i)
        if (find(i) == root) complete &= members_[i].unmatched == 0, far = std::max(far, members_[i].depth.hi);
      if (complete) nearest = std::min(nearest, far);
    }
    return nearest;
  }

private:
  struct Member {
    std::array<Float3, 3> corner{Float3(0), Float3(0), Float3(0)};
    ValueRange depth;
    std::uint8_t unmatched = 0; // ambiguous edges that no other has
    std::uint32_t object = 0;
    int facing = 0;
    std::size_t root = 0;
  };

  std::size_t find(std::size_t i) {
    while (members_[i].root != i) i = members_[i].root;
    return i;
  }
  /// The edge from corner k + 1 to k + 2 of one is that from k + 2 to k + 1 of the other if both look the same way.
  void match(Member& a, Member& b) {
    if (a.object != b.object || a.facing == 0 || a.facing != b.facing) return;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t m = 0; m < 3; ++m) {
        const auto bit = [](std::size_t edge) { return static_cast<std::uint8_t>(1 << edge); };
        if (!(a.unmatched & bit(k)) || !(b.unmatched & bit(m))) continue;
        if (a.corner[(k + 1) % 3] != b.corner[(m + 2) % 3] || a.corner[(k + 2) % 3] != b.corner[(m + 1) % 3]) continue;
        a.unmatched = static_cast<std::uint8_t>(a.unmatched & ~bit(k));
        b.unmatched = static_cast<std::uint8_t>(b.unmatched & ~bit(m));
        members_[find(a.root)].root = find(b.root);
      }
  }

  std::vector<Member> members_;
};

/// Whether both have the same corners in the same order: then a device computes the same of them, bit for bit.
bool is_same_triangle(const DeviceFrame& frame, std::uint32_t a, std::uint32_t b) {
  const TriangleRef ref_a = frame.triangle(a), ref_b = frame.triangle(b);
  const auto& objects = frame.scene().objects;
  if (objects[ref_a.object].cull != objects[ref_b.object].cull) return false; // one may be missing
  const auto& transforms = frame.context().geometry.transforms;
  if (transforms[ref_a.object].clip_from_object != transforms[ref_b.object].clip_from_object) return false;
  const Mesh &mesh_a = *objects[ref_a.object].mesh, &mesh_b = *objects[ref_b.object].mesh;
  for (std::size_t k = 0; k < 3; ++k)
    if (mesh_a.positions[mesh_a.triangles[ref_a.triangle][k]] != mesh_b.positions[mesh_b.triangles[ref_b.triangle][k]])
      return false;
  return true;
}

/// Of equal depths the depth test LESS keeps the first.
void drop_repeated(const DeviceFrame& frame, std::vector<Candidate>& candidates) {
  for (std::size_t i = 1; i < candidates.size();) {
    const bool repeats =
        std::any_of(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(i), [&](const Candidate& c) {
          return !c.may_be_cut_out && is_same_triangle(frame, c.number, candidates[i].number);
        });
    if (repeats) candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(i));
    else ++i;
  }
}

/// Leaves those that nothing certain hides.
void keep_visible(const DeviceFrame& frame, VisibleSet& set) {
  double far = std::numeric_limits<double>::infinity();
  bool any_ambiguous = false;
  for (const Candidate& c : set.candidates)
    if (c.certain) far = std::min(far, c.depth.hi);
    else any_ambiguous = true;
  if (any_ambiguous) far = std::min(far, SharedEdges(frame, set.candidates).certain_depth());
  std::erase_if(set.candidates, [far](const Candidate& c) { return c.depth.lo > far; });
  set.background = std::isinf(far);
  drop_repeated(frame, set.candidates);
}

} // namespace

std::vector<VisibleSet> find_candidates(const DeviceFrame& frame, const std::vector<PixelPlace>& pixels,
                                        SamplePosition sample) {
  std::vector<VisibleSet> sets(pixels.size());
  if (pixels.empty()) return sets;
  const PixelIndex index(pixels, frame.height());
  std::mutex merging;
  // Small pieces of the list of triangles: what they find is put together in any order, and sorted below.
  constexpr std::uint32_t piece = 1024;
  const std::uint32_t triangles = frame.triangles();
  const auto pieces = static_cast<std::size_t>((triangles + piece - 1) / piece);
  parallel_for(frame.context().threads, pieces, [&](std::size_t p, int) {
    std::vector<Found> found;
    const auto begin = static_cast<std::uint32_t>(p) * piece, end = std::min(begin + piece, triangles);
    for (std::uint32_t number = begin; number < end; ++number) look_at(frame, index, number, sample, found);
    const std::lock_guard lock(merging);
    for (const Found& f : found) sets[f.pixel].candidates.push_back(f.candidate);
  });
  constexpr std::size_t block = 256;
  parallel_for(frame.context().threads, (pixels.size() + block - 1) / block, [&](std::size_t b, int) {
    for (std::size_t i = b * block; i < std::min((b + 1) * block, sets.size()); ++i) {
      auto& candidates = sets[i].candidates;
      std::sort(candidates.begin(), candidates.end(),
                [](const Candidate& x, const Candidate& y) { return x.number < y.number; });
      keep_visible(frame, sets[i]);
    }
  });
  return sets;
}

std::vector<VisibleSet> find_candidates_among(const DeviceFrame& frame, const std::vector<PixelPlace>& pixels,
                                              SamplePosition sample, std::span<const std::uint32_t> triangles) {
  std::vector<VisibleSet> sets(pixels.size());
  const PixelIndex index(pixels, frame.height());
  std::vector<Found> found;
  for (const std::uint32_t number : triangles) look_at(frame, index, number, sample, found);
  for (const Found& f : found) sets[f.pixel].candidates.push_back(f.candidate);
  for (VisibleSet& set : sets) keep_visible(frame, set);
  return sets;
}

} // namespace refraster
