#include "verify/bounds/device_depth_map.h"

#include "raster/samples.h"
#include "verify/bounds/candidates.h"

#include <algorithm>
#include <array>

namespace refraster {
namespace {

/// Texels along a side of what is looked at together: the triangles that may be there are gone through once.
constexpr int square_side = 16;

} // namespace

struct DeviceDepthMap::Square {
  std::once_flag once;
  std::vector<std::uint32_t> triangles;                        // that may touch it
  std::array<ValueRange, square_side* square_side> texel = {}; // row by row, y down
};

struct DeviceDepthMap::Face {
  Face(const Scene& casters, const RenderOptions& options, const DeviceProfile& profile, const Viewpoint& viewpoint,
       std::size_t squares)
      : frame(casters, options, profile, ShaderMatrices::one, viewpoint), square(std::make_unique<Square[]>(squares)) {}

  DeviceFrame frame;
  std::unique_ptr<Square[]> square;
};

DeviceDepthMap::DeviceDepthMap(const Scene& casters, const LightView& view, const RenderOptions& options,
                               const DeviceProfile& profile)
    : casters_(casters), view_(view), profile_(profile),
      squares_across_((view.map.size + square_side - 1) / square_side), faces_(view.faces()) {
  options_.width = options_.height = view.map.size;
  options_.threads = options.threads;
  options_.memory = options.memory;
}

DeviceDepthMap::~DeviceDepthMap() = default;

DeviceDepthMap::Face& DeviceDepthMap::face_at(std::size_t number) const {
  const std::lock_guard lock(making_faces_);
  std::unique_ptr<Face>& face = faces_[number];
  if (face) return *face;
  const auto across = static_cast<std::size_t>(squares_across_);
  face = std::make_unique<Face>(casters_, options_, profile_, view_.viewpoint(number), across * across);
  for (std::uint32_t triangle = 0; triangle < face->frame.triangles(); ++triangle) {
    const DeviceTriangle device(face->frame, triangle);
    if (!device.is_seen()) continue;
    const PixelRect box = device.pixels();
    if (box.width <= 0 || box.height <= 0) continue;
    for (int y = box.y / square_side; y <= (box.y + box.height - 1) / square_side; ++y)
      for (int x = box.x / square_side; x <= (box.x + box.width - 1) / square_side; ++x)
        face->square[static_cast<std::size_t>(y) * across + static_cast<std::size_t>(x)].triangles.push_back(triangle);
  }
  return *face;
}

void DeviceDepthMap::fill(const Face& face, int first_column, int first_row, Square& square) const {
  std::vector<PixelPlace> pixels;
  for (int y = first_row; y < std::min(first_row + square_side, view_.map.size); ++y)
    for (int x = first_column; x < std::min(first_column + square_side, view_.map.size); ++x) pixels.push_back({x, y});
  const std::vector<VisibleSet> sets =
      find_candidates_among(face.frame, pixels, sample_pattern(1).front(), square.triangles);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ValueRange range{1, sets[i].background ? 1.0 : 0.0};
    for (const Candidate& candidate : sets[i].candidates)
      range.lo = std::min(range.lo, candidate.depth.lo), range.hi = std::max(range.hi, candidate.depth.hi);
    square.texel[static_cast<std::size_t>((pixels[i].y - first_row) * square_side + pixels[i].x - first_column)] = {
        std::max(range.lo, 0.0), std::min(range.hi, 1.0)};
  }
}

ValueRange DeviceDepthMap::texel(std::size_t face, int column, int row) const {
  Face& of = face_at(face);
  const int y = view_.map.size - 1 - row, square_x = column / square_side, square_y = y / square_side;
  Square& square = of.square[static_cast<std::size_t>(square_y * squares_across_ + square_x)];
  std::call_once(square.once, [&] { fill(of, square_x * square_side, square_y * square_side, square); });
  return square.texel[static_cast<std::size_t>(y % square_side * square_side + column % square_side)];
}

} // namespace refraster
