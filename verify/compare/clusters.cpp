#include "verify/compare/clusters.h"

#include <algorithm>
#include <utility>

namespace refraster {

std::vector<Cluster> clusters_over(const Image<double>& differences, double limit) {
  Image<std::uint8_t> over(differences.width, differences.height, 1);
  for (std::size_t i = 0; i < over.values.size(); ++i) over.values[i] = differences.values[i] > limit;
  return clusters_of(over, differences);
}

std::vector<Cluster> clusters_of(const Image<std::uint8_t>& marked, const Image<double>& differences) {
  const int width = differences.width, height = differences.height;
  Image<std::uint8_t> seen(width, height, 1);
  const auto take = [&](int x, int y) { // whether it is marked, and not yet in a cluster
    if (x < 0 || y < 0 || x >= width || y >= height || *seen.at(x, y) || !*marked.at(x, y)) return false;
    *seen.at(x, y) = 1;
    return true;
  };

  std::vector<Cluster> clusters;
  std::vector<std::pair<int, int>> waiting; // not recursion: a cluster may be the whole image
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!take(x, y)) continue;
      Cluster cluster;
      int right = x, bottom = y;
      cluster.x = x, cluster.y = y;
      waiting.emplace_back(x, y);
      while (!waiting.empty()) {
        const auto [px, py] = waiting.back();
        waiting.pop_back();
        ++cluster.pixels;
        const double difference = *differences.at(px, py);
        const bool earlier = std::pair(py, px) < std::pair(cluster.worst_y, cluster.worst_x);
        if (difference > cluster.largest || (difference == cluster.largest && earlier)) {
          cluster.largest = difference;
          cluster.worst_x = px, cluster.worst_y = py;
        }
        cluster.x = std::min(cluster.x, px), right = std::max(right, px);
        cluster.y = std::min(cluster.y, py), bottom = std::max(bottom, py);
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (take(px + dx, py + dy)) waiting.emplace_back(px + dx, py + dy);
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

} // namespace refraster
