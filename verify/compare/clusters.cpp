#include "verify/compare/clusters.h"

#include <algorithm>
#include <utility>

namespace refraster {
namespace {

using Place = std::pair<int, int>; // x, y

/// Gathers marked pixels that touch, each once.
class Flood {
public:
  explicit Flood(const Image<std::uint8_t>& marked) : marked_(marked), seen_(marked.width, marked.height, 1) {}

  /// All that hang together with this pixel, which comes first; none if it is not marked, or was gathered before.
  const std::vector<Place>& from(int x, int y) {
    pixels_.clear();
    take(x, y);
    for (std::size_t next = 0; next < pixels_.size(); ++next) { // not recursion: a cluster may be the whole image
      const auto [px, py] = pixels_[next];
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) take(px + dx, py + dy);
    }
    return pixels_;
  }

private:
  void take(int x, int y) {
    if (x < 0 || y < 0 || x >= marked_.width || y >= marked_.height || *seen_.at(x, y) || !*marked_.at(x, y)) return;
    *seen_.at(x, y) = 1;
    pixels_.emplace_back(x, y);
  }

  const Image<std::uint8_t>& marked_;
  Image<std::uint8_t> seen_;
  std::vector<Place> pixels_;
};

} // namespace

std::vector<Cluster> clusters_over(const Image<double>& differences, double limit) {
  Image<std::uint8_t> over(differences.width, differences.height, 1);
  for (std::size_t i = 0; i < over.values.size(); ++i) over.values[i] = differences.values[i] > limit;
  return clusters_of(over, differences);
}

std::vector<Cluster> clusters_of(const Image<std::uint8_t>& marked, const Image<double>& differences) {
  Flood flood(marked);
  std::vector<Cluster> clusters;
  for (int y = 0; y < marked.height; ++y) {
    for (int x = 0; x < marked.width; ++x) {
      const std::vector<Place>& pixels = flood.from(x, y);
      if (pixels.empty()) continue;
      Cluster cluster;
      int right = x, bottom = y;
      cluster.x = cluster.worst_x = x, cluster.y = cluster.worst_y = y;
      cluster.pixels = pixels.size();
      for (const auto& [px, py] : pixels) {
        const double difference = *differences.at(px, py);
        const bool earlier = std::pair(py, px) < std::pair(cluster.worst_y, cluster.worst_x);
        if (difference > cluster.largest || (difference == cluster.largest && earlier)) {
          cluster.largest = difference;
          cluster.worst_x = px, cluster.worst_y = py;
        }
        cluster.x = std::min(cluster.x, px), right = std::max(right, px);
        cluster.y = std::min(cluster.y, py), bottom = std::max(bottom, py);
      }
      cluster.width = right - cluster.x + 1;
      cluster.height = bottom - cluster.y + 1;
      clusters.push_back(cluster);
    }
  }
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const Cluster& a, const Cluster& b) { return a.pixels > b.pixels; });
  return clusters;
}

std::vector<Place> cluster_pixels(const Image<std::uint8_t>& marked, const Cluster& cluster) {
  return Flood(marked).from(cluster.worst_x, cluster.worst_y);
}

} // namespace refraster
