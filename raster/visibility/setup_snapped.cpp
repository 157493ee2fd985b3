#include "raster/visibility/setup.h"
#include "raster/visibility/snapped_setup.h"

namespace refraster {

std::optional<SnappedTriangle> set_up_snapped(const std::array<WindowVertex, 3>& v) {
  std::array<SnappedCorner<double, 1>, 3> submitted;
  for (std::size_t k = 0; k < 3; ++k)
    submitted[k] = {static_cast<double>(v[k].x), static_cast<double>(v[k].y), {static_cast<double>(k)}};
  const SnappedSetup<double, 1> t = set_up_snapped(submitted[0], submitted[1], submitted[2]);
  if (t.size == 0) return std::nullopt;
  SnappedTriangle triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.corner[k] = static_cast<std::uint8_t>(t.corner[k].with[0]);
    SnappedEdge& edge = triangle.edge[k];
    edge.a = static_cast<std::int64_t>(t.a[k]), edge.b = static_cast<std::int64_t>(t.b[k]);
    const WindowVertex& on_edge = v[static_cast<std::size_t>(t.corner[(k + 1) % 3].with[0])];
    edge.c = -(edge.a * on_edge.x + edge.b * on_edge.y);
  }
  return triangle;
}

} // namespace refraster
