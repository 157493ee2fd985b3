#include "raster/fragments.h"

#include <algorithm>

namespace refraster {

namespace {

void list_single_sample(const TileVisibility& visibility, const Crop& tile, std::vector<FragmentRun>& runs) {
  for (int y = 0; y < tile.height; ++y) {
    const std::int32_t* const row = visibility.row(0, y);
    for (int x = 0; x < tile.width;) {
      const std::int32_t place = row[x];
      int end = x + 1;
      while (end < tile.width && row[end] == place) ++end;
      if (place != nothing)
        runs.push_back({place, 0, static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                        static_cast<std::uint8_t>(end - x), 1});
      x = end;
    }
  }
}

void list_multisample(const TileVisibility& visibility, const Crop& tile, int samples, std::vector<FragmentRun>& runs) {
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const std::size_t first = runs.size();
      for (int s = 0; s < samples; ++s) {
        const std::int32_t place = visibility.row(s, y)[x];
        if (place == nothing) continue;
        const auto same = std::find_if(runs.begin() + static_cast<std::ptrdiff_t>(first), runs.end(),
                                       [=](const FragmentRun& run) { return run.place == place; });
        if (same != runs.end()) ++same->samples;
        else runs.push_back({place, 0, static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 1, 1});
      }
    }
}

} // namespace

void list_runs(const TileVisibility& visibility, const Crop& tile, int samples, std::vector<FragmentRun>& runs) {
  runs.clear();
  if (samples == 1) list_single_sample(visibility, tile, runs);
  else list_multisample(visibility, tile, samples, runs);
}

template <class Real>
std::size_t TileSurfaces<Real>::group_of(std::uint32_t object) {
  const auto at = std::find_if(groups_.begin(), groups_.end(), [=](const Group& g) { return g.object == object; });
  if (at != groups_.end()) return static_cast<std::size_t>(at - groups_.begin());
  groups_.push_back({object});
  return groups_.size() - 1;
}

template <class Real>
std::uint32_t TileSurfaces<Real>::collect(const Scene& scene, const Geometry& geometry, const Bins& bins,
                                          std::span<const std::uint32_t> triangles, std::span<FragmentRun> runs) {
  surfaces_.clear();
  large_lines_.clear();
  groups_.clear();
  group_of_surface_.clear();
  runs_of_surface_.clear();
  surface_of_.assign(triangles.size(), -1);
  for (const FragmentRun& run : runs) {
    std::int32_t& surface = surface_of_[static_cast<std::size_t>(run.place)];
    if (surface < 0) {
      surface = static_cast<std::int32_t>(surfaces_.size());
      set_up_surface<Real>(scene, geometry, bins, triangles[static_cast<std::size_t>(run.place)],
                           surfaces_.emplace_back(), large_lines_);
      group_of_surface_.push_back(static_cast<std::uint32_t>(group_of(surfaces_.back().object)));
      runs_of_surface_.push_back(0);
    }
    ++runs_of_surface_[static_cast<std::size_t>(surface)];
    groups_[group_of_surface_[static_cast<std::size_t>(surface)]].end_run += 1; // a count, until all are known
    groups_[group_of_surface_[static_cast<std::size_t>(surface)]].fragments += run.length;
  }

  // Counting sort: groups one after the other, in each the surfaces in the order they were met, in each the runs as
  // they came. `next` of a surface starts where the surfaces of its group before it end.
  std::size_t begin = 0;
  std::vector<std::size_t> next_of_group;
  for (Group& group : groups_) {
    group.begin_run = begin;
    next_of_group.push_back(begin);
    begin = group.end_run += begin;
  }
  next_.resize(surfaces_.size());
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    next_[s] = static_cast<std::uint32_t>(next_of_group[group_of_surface_[s]]);
    next_of_group[group_of_surface_[s]] += runs_of_surface_[s];
  }
  sorted_.resize(runs.size());
  for (FragmentRun& run : runs) {
    const auto surface = static_cast<std::size_t>(surface_of_[static_cast<std::size_t>(run.place)]);
    run.first_fragment = next_[surface]; // its place in sorted_, until the fragments are numbered
    sorted_[next_[surface]++] = {static_cast<std::int32_t>(surface), 0, run.x, run.y, run.length, run.samples};
  }
  std::uint32_t fragments = 0;
  for (FragmentRun& run : sorted_) {
    run.first_fragment = fragments;
    fragments += run.length;
  }
  for (FragmentRun& run : runs) run.first_fragment = sorted_[run.first_fragment].first_fragment;
  return fragments;
}

template class TileSurfaces<double>;
template class TileSurfaces<float>;

} // namespace refraster
