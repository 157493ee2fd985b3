#include "suite/shards/shard.h"

#include "raster/vertex/scene_view.h"

#include <algorithm>
#include <numeric>

namespace refraster::suite {
namespace {

constexpr double default_samples_a_second = 1e6;

double samples_of(const Entry& entry) {
  const Picture otherwise;
  const PixelSize size = entry.size.value_or(PixelSize{otherwise.width, otherwise.height});
  return static_cast<double>(size.width) * size.height * entry.samples.value_or(otherwise.samples);
}

} // namespace

std::vector<double> entry_costs(const std::vector<Entry>& entries, const References& references) {
  double known_seconds = 0, known_samples = 0;
  for (const Entry& entry : entries)
    if (const Reference* const record = references.find(entry.name); record != nullptr && record->seconds > 0)
      known_seconds += record->seconds, known_samples += samples_of(entry);
  const double seconds_a_sample = known_samples > 0 ? known_seconds / known_samples : 1 / default_samples_a_second;
  std::vector<double> costs;
  for (const Entry& entry : entries) {
    const Reference* const record = references.find(entry.name);
    costs.push_back(record != nullptr && record->seconds > 0 ? record->seconds : samples_of(entry) * seconds_a_sample);
  }
  return costs;
}

std::vector<std::size_t> entries_of(const Shard& shard, const std::vector<Entry>& entries,
                                    const std::vector<double>& costs) {
  std::vector<std::size_t> by_cost(entries.size());
  std::iota(by_cost.begin(), by_cost.end(), std::size_t{0});
  std::sort(by_cost.begin(), by_cost.end(), [&](std::size_t a, std::size_t b) {
    return costs[a] != costs[b] ? costs[a] > costs[b] : entries[a].name < entries[b].name;
  });
  std::vector<double> sums(static_cast<std::size_t>(shard.of), 0.0);
  std::vector<std::size_t> own;
  for (const std::size_t i : by_cost) {
    const auto least = std::min_element(sums.begin(), sums.end()); // the first of equals
    *least += costs[i];
    if (least - sums.begin() == shard.part - 1) own.push_back(i);
  }
  std::sort(own.begin(), own.end());
  return own;
}

} // namespace refraster::suite
