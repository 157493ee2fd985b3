#include "raster/visibility/runs.h"

#include <algorithm>

namespace refraster {

std::vector<std::vector<RunPart>> runs_of(const Geometry& geometry, int threads) {
  const auto& first = geometry.first_triangle;
  const auto objects = static_cast<std::uint32_t>(first.size() - 1);
  std::uint64_t triangles = 0;
  for (std::uint32_t o = 0; o < objects; ++o)
    if (geometry.storage_of(o) != Storage::outside) triangles += first[o + 1] - first[o];

  // A few for each thread, since some take longer than others. A run of the least size takes about as long as its lists
  // and its part in the lists of every tile do.
  constexpr std::uint32_t min_run = 512, runs_of_thread = 4;
  const std::size_t max_runs = threads == 1 ? 1 : static_cast<std::size_t>(threads) * runs_of_thread;
  const std::size_t count = std::clamp<std::size_t>(triangles / min_run, 1, max_runs);
  std::vector<std::vector<RunPart>> runs(count);
  std::size_t run = 0;
  std::uint64_t listed = 0;
  for (std::uint32_t o = 0; o < objects; ++o) {
    const Storage storage = geometry.storage_of(o);
    if (storage == Storage::outside) continue;
    for (std::uint32_t begin = first[o]; begin < first[o + 1];) {
      while (listed >= triangles * (run + 1) / count) ++run;
      const std::uint64_t room = triangles * (run + 1) / count - listed, rest = first[o + 1] - begin;
      const auto taken = static_cast<std::uint32_t>(storage == Storage::on_demand ? rest : std::min(room, rest));
      runs[run].push_back({o, begin, begin + taken});
      begin += taken;
      listed += taken;
    }
  }
  return runs;
}

} // namespace refraster
