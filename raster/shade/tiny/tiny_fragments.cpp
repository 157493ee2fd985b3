#include "raster/shade/tiny/tiny_fragments.h"

#include "raster/shade/shade_packet.h"

#include <algorithm>

namespace refraster {

namespace {

VertexNeeds vertex_needs(const FrameContext& context, std::uint32_t object, std::uint32_t triangle,
                         const Material& material) {
  const bool derivatives = any_texture(material, [](const TextureMap& map) { return needs_derivatives(map); });
  return {is_textured(material), derivatives, repeats_of(context, object, triangle)};
}

// Setting up a triangle for one fragment costs about as much as interpolating in one that is set up already; so of two
// fragments a triangle that is seen both ways cost the same. How many are seen is not known: no more than are listed,
// and no more than there are runs.
bool are_tiny(std::size_t triangles, std::size_t runs, std::size_t fragments) {
  return fragments <= 2 * std::min(triangles, runs);
}

} // namespace

// Triangles come in the order of their numbers: each group is a range of slots.
void TinyFragments::find_groups(const FrameContext& context, std::span<const std::uint32_t> triangles) {
  end_slot_.clear();
  TriangleFinder finder(context.scene, context.geometry);
  for (auto at = triangles.begin(); at != triangles.end();) {
    const TriangleRef ref = finder.at(*at);
    const MaterialRange range = material_range(context.scene.objects[ref.object], ref.triangle);
    const std::uint32_t end = context.geometry.first_triangle[ref.object] + range.end_triangle;
    // Of neighbours that are many in a tile: often the last one is of the group as well.
    at = triangles.back() < end ? triangles.end() : std::lower_bound(at, triangles.end(), end);
    groups_.push_back(
        {ref.object, range.material, vertex_needs(context, ref.object, ref.triangle, *range.material), 0, 0});
    end_slot_.push_back(static_cast<std::int32_t>(at - triangles.begin()));
  }
}

// Fragments as they come. With one sample a pixel these are the pixels that see anything, and no branch depends on how
// long runs are, which cannot be foreseen.
void TinyFragments::put_in_order(const VisibleTile& visible, std::span<const FragmentRun> runs) {
  const std::uint32_t* const triangles = visible.triangles.data();
  std::uint32_t next = 0;
  if (samples_ == 1) {
    for (int y = 0; y < visible.tile.height; ++y) {
      const std::int32_t* const row = visible.visibility.row(0, y);
      for (int x = 0; x < visible.tile.width; ++x) {
        const std::int32_t slot = row[x];
        triangle_[next] = triangles[std::max(slot, 0)], place_[next] = static_cast<std::uint32_t>(x + 256 * y);
        next += slot != nothing;
      }
    }
    return;
  }
  for (const FragmentRun& run : runs) {
    const std::uint32_t triangle = triangles[static_cast<std::size_t>(run.slot)];
    const std::uint32_t place = run.x + 256u * run.y;
    for (std::uint32_t i = 0; i < run.length; ++i, ++next) triangle_[next] = triangle, place_[next] = place + i;
  }
}

// A counting sort by group.
void TinyFragments::sort(std::span<const std::uint32_t> triangles, std::span<FragmentRun> runs) {
  const auto group_of = [&](const FragmentRun& run) {
    return static_cast<std::size_t>(std::upper_bound(end_slot_.begin(), end_slot_.end(), run.slot) - end_slot_.begin());
  };
  for (const FragmentRun& run : runs) groups_[group_of(run)].fragments += run.length;
  next_.clear();
  std::uint32_t first = 0;
  for (Group& group : groups_) {
    group.first_fragment = first;
    next_.push_back(first);
    first += group.fragments;
  }
  for (FragmentRun& run : runs) {
    std::uint32_t& next = next_[group_of(run)];
    run.first_fragment = next;
    const std::uint32_t triangle = triangles[static_cast<std::size_t>(run.slot)];
    const std::uint32_t place = run.x + 256u * run.y;
    for (std::uint32_t i = 0; i < run.length; ++i, ++next) triangle_[next] = triangle, place_[next] = place + i;
  }
}

// Groups of which nothing is seen go; what then follows one of the same material is one with it.
void TinyFragments::merge_groups() {
  std::size_t kept = 0;
  for (const Group& group : groups_) {
    if (group.fragments == 0) continue;
    Group* const last = kept > 0 ? &groups_[kept - 1] : nullptr;
    if (last && last->object == group.object && last->material == group.material) last->fragments += group.fragments;
    else groups_[kept++] = group;
  }
  groups_.resize(kept);
}

// Vertices come from far: those of fragments that are shaded later are asked for, and before that the triangles that
// name them. Of a mesh of this size or less they are near enough, in the second-level cache.
void TinyFragments::ask_for(const FrameContext& context, const Group& group, std::uint32_t first,
                            std::uint32_t count) const {
  constexpr std::size_t near_vertices = 1 << 15;
  constexpr std::uint32_t vertices_ahead = 64, triangles_ahead = 160; // fragments: 1 µs, and more
  const Mesh& mesh = *context.scene.objects[group.object].mesh;
  if (mesh.positions.size() <= near_vertices) return;
  const Geometry& geometry = context.geometry;
  const std::uint32_t end = group.first_fragment + group.fragments;
  const auto* const triangles = mesh.triangles.data();
  const std::uint32_t first_triangle = geometry.first_triangle[group.object];
  for (std::uint32_t i = first + triangles_ahead; i < std::min(first + triangles_ahead + count, end); ++i)
    __builtin_prefetch(&triangles[triangle_[i] - first_triangle]);
  const PlacedVertex* const placed = geometry.window.placed.data() + geometry.first_vertex[group.object];
  const double* const inverse_w = geometry.window.inverse_w.data() + geometry.first_vertex[group.object];
  const Float3 *const positions = mesh.positions.data(), *const normals = mesh.normals.data();
  for (std::uint32_t i = first + vertices_ahead; i < std::min(first + vertices_ahead + count, end); ++i)
    for (const std::size_t k : {0u, 2u}) { // the other one is mostly a neighbour's as well
      const std::uint32_t vertex = triangles[triangle_[i] - first_triangle][k];
      __builtin_prefetch(&placed[vertex]), __builtin_prefetch(&inverse_w[vertex]);
      __builtin_prefetch(&positions[vertex]), __builtin_prefetch(&normals[vertex]);
    }
}

std::uint32_t TinyFragments::collect(const FrameContext& context, const VisibleTile& visible,
                                     std::span<FragmentRun> runs) {
  fragments_ = 0;
  groups_.clear();
  const std::span<const std::uint32_t> triangles = visible.triangles;
  std::uint32_t fragments = 0;
  for (FragmentRun& run : runs) {
    run.first_fragment = fragments;
    fragments += run.length;
  }
  if (fragments == 0 || !are_tiny(triangles.size(), runs.size(), fragments)) return 0;
  if (!context.geometry.all_stored() || context.uses.vertex_colours || context.uses.tangents) return 0;
  fragments_ = fragments;
  samples_ = context.options.samples;
  // What is behind the last pixel that sees anything is written once more.
  if (triangle_.size() <= fragments) // the one that is asked grows last, should there be no memory
    place_.resize(fragments + 1), triangle_.resize(fragments + 1);
  find_groups(context, triangles);
  if (groups_.size() == 1) {
    groups_[0].fragments = fragments;
    put_in_order(visible, runs);
  } else {
    sort(triangles, runs);
    merge_groups();
  }
  return fragments;
}

} // namespace refraster
