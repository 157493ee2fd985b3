#include "raster/visibility/setup.h"

#include <algorithm>
#include <cmath>

namespace refraster {

std::optional<SnappedTriangle> set_up_snapped(const std::array<WindowVertex, 3>& v) {
  SnappedTriangle triangle;
  std::array<std::uint8_t, 3>& corner = triangle.corner;
  corner = {0, 1, 2};
  bool odd = false; // an odd number of exchanges turns the triangle over
  const auto exchange_if_after = [&](std::size_t i, std::size_t j) {
    const WindowVertex &p = v[corner[i]], &q = v[corner[j]];
    if (p.x > q.x || (p.x == q.x && p.y > q.y)) {
      std::swap(corner[i], corner[j]);
      odd = !odd;
    }
  };
  exchange_if_after(0, 1), exchange_if_after(1, 2), exchange_if_after(0, 1);

  const WindowVertex &p0 = v[corner[0]], &p1 = v[corner[1]], &p2 = v[corner[2]];
  const std::int64_t area = static_cast<std::int64_t>(p1.x - p0.x) * (p2.y - p0.y) -
                            static_cast<std::int64_t>(p2.x - p0.x) * (p1.y - p0.y); // twice, and < 2^52
  if (area == 0) return std::nullopt;
  triangle.facing = (area < 0) != odd ? Facing::front : Facing::back; // y down: counter-clockwise is negative

  for (std::size_t k = 0; k < 3; ++k) {
    const WindowVertex &p = v[corner[(k + 1) % 3]], &q = v[corner[(k + 2) % 3]];
    SnappedEdge edge{p.y - q.y, q.x - p.x, 0};
    edge.c = -(edge.a * p.x + edge.b * p.y);
    triangle.edge[k] = area > 0 ? edge : -edge;
  }

  const double size = static_cast<double>(area > 0 ? area : -area);
  triangle.z0 = p0.z;
  triangle.slope1 = (p1.z - p0.z) / size;
  triangle.slope2 = (p2.z - p0.z) / size;
  triangle.z_min = std::min({p0.z, p1.z, p2.z});
  triangle.z_max = std::max({p0.z, p1.z, p2.z});

  triangle.x_min = p0.x, triangle.x_max = p2.x; // in order of x
  triangle.y_min = std::min({p0.y, p1.y, p2.y});
  triangle.y_max = std::max({p0.y, p1.y, p2.y});
  return triangle;
}

} // namespace refraster
