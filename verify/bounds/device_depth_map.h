#pragma once
// The depth map of a light as a device may have drawn it.

#include "raster/shadow/map/light_view.h"
#include "verify/bounds/device_frame.h"
#include "verify/bounds/device_triangle.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace refraster {

/// Texels are looked at when they are first asked for, a square of them at a time: by any thread.
class DeviceDepthMap {
public:
  /// Holds references: to casters_of() the scene and the profile.
  DeviceDepthMap(const Scene& casters, const LightView& view, const RenderOptions& options,
                 const DeviceProfile& profile);
  ~DeviceDepthMap();
  DeviceDepthMap(const DeviceDepthMap&) = delete;
  DeviceDepthMap& operator=(const DeviceDepthMap&) = delete;

  const LightView& view() const { return view_; }

  /// What the texel may hold: the depths, from nearest to farthest, of all that may be seen at its centre
  /// (find_candidates); up to 1 where that may be nothing. Columns and rows from the lower left corner.
  ValueRange texel(std::size_t face, int column, int row) const;

private:
  struct Square;
  struct Face;
  Face& face_at(std::size_t number) const;
  void fill(const Face& face, int first_column, int first_row, Square& square) const;

  const Scene& casters_;
  LightView view_;
  RenderOptions options_;
  const DeviceProfile& profile_;
  int squares_across_ = 0;
  mutable std::vector<std::unique_ptr<Face>> faces_;
  mutable std::mutex making_faces_;
};

} // namespace refraster
