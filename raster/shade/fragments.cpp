#include "raster/shade/fragments.h"

namespace refraster {

// Each triangle that is seen, in submission order. Triangles of one object follow one another, and those of a material
// do as the file has them: a group.
template <class Real>
void TileAttributes<Real>::set_up(const FrameContext& context, std::span<const std::uint32_t> triangles) {
  groups_.clear();
  next_.clear();
  visible_.clear();
  setup_of_.resize(triangles.size());
  TriangleFinder finder(context.scene, context.geometry);
  std::uint32_t runs = 0, end_of_group = 0; // the number in the frame up to which the group's material goes on
  for (std::size_t slot = 0; slot < triangles.size(); ++slot) {
    const Seen seen = seen_[slot];
    if (seen.runs == 0) continue;
    const TriangleRef ref = finder.at(triangles[slot]);
    setup_of_[slot] = static_cast<std::int32_t>(visible_.size());
    visible_.push_back({ref, triangles[slot]});
    if (triangles[slot] >= end_of_group) {
      const MaterialRange range = material_range(context.scene.objects[ref.object], ref.triangle);
      end_of_group = context.geometry.first_triangle[ref.object] + range.end_triangle;
      if (groups_.empty() || groups_.back().object != ref.object || groups_.back().material != range.material)
        groups_.push_back({ref.object, range.material, runs, runs, 0});
    }
    next_.push_back(runs);
    runs += seen.runs;
    groups_.back().end_run = runs;
    groups_.back().fragments += seen.fragments;
  }

  uncommon_edges_ = {};
  setups_.resize(visible_.size());
  set_up_attributes<Real>(context, visible_, setups_, uncommon_edges_);
}

// A counting sort: runs of a triangle stay in the order in which they came.
template <class Real>
std::uint32_t TileAttributes<Real>::sort(std::span<FragmentRun> runs) {
  sorted_.resize(runs.size());
  for (FragmentRun& run : runs) {
    const std::int32_t setup = setup_of_[static_cast<std::size_t>(run.slot)];
    std::uint32_t& next = next_[static_cast<std::size_t>(setup)];
    run.first_fragment = next; // its place in sorted_, until the fragments are numbered
    sorted_[next++] = {setup, 0, run.x, run.y, run.length, run.samples};
  }
  std::uint32_t fragments = 0;
  for (FragmentRun& run : sorted_) {
    run.first_fragment = fragments;
    fragments += run.length;
  }
  for (FragmentRun& run : runs) run.first_fragment = sorted_[run.first_fragment].first_fragment;
  return fragments;
}

template <class Real>
std::uint32_t TileAttributes<Real>::collect(const FrameContext& context, std::span<const std::uint32_t> triangles,
                                            std::span<FragmentRun> runs) {
  seen_.assign(triangles.size(), {});
  for (const FragmentRun& run : runs) {
    Seen& seen = seen_[static_cast<std::size_t>(run.slot)];
    ++seen.runs;
    seen.fragments += run.length;
  }
  set_up(context, triangles);
  return sort(runs);
}

template class TileAttributes<double>;
template class TileAttributes<float>;

} // namespace refraster
