#pragma once
// A scene at one size, as a device may see it: what all its pixels have in common.

#include "raster/vertex/transform.h"
#include "raster/visibility/bin.h"
#include "verify/device/device_profile.h"

#include <memory>

namespace refraster {

class DeviceShadows; // verify/bounds/shadow_bounds.h

/// How a vertex shader makes clip coordinates: from one matrix, that was multiplied before, or as the product
/// projection view model position, where the roundings of each add up.
enum class ShaderMatrices { one, three };
template <>
struct EnumNames<ShaderMatrices> {
  static constexpr std::pair<ShaderMatrices, std::string_view> names[] = {
      {ShaderMatrices::one, "one"},
      {ShaderMatrices::three, "three"},
  };
};

/// Holds references to the scene and the profile.
class DeviceFrame {
public:
  DeviceFrame(const Scene& scene, const RenderOptions& options, const DeviceProfile& profile, ShaderMatrices matrices);
  /// The same seen from a light: nothing is known of its shadows.
  DeviceFrame(const Scene& scene, const RenderOptions& options, const DeviceProfile& profile, ShaderMatrices matrices,
              const Viewpoint& viewpoint);
  ~DeviceFrame();
  DeviceFrame(const DeviceFrame&) = delete;
  DeviceFrame& operator=(const DeviceFrame&) = delete;

  const FrameContext& context() const { return context_; }
  const Scene& scene() const { return context_.scene; }
  const DeviceProfile& profile() const { return profile_; }
  /// Null without shadow maps.
  const DeviceShadows* shadows() const { return shadows_.get(); }
  int width() const { return options_.width; }
  int height() const { return options_.height; }
  TriangleRef triangle(std::uint32_t number) const { return TriangleFinder(context_.scene, geometry_).at(number); }
  std::uint32_t triangles() const { return geometry_.triangles(); }
  /// That of an object's mesh, in the frame.
  std::uint32_t number_of(std::size_t object, std::uint32_t triangle) const {
    return geometry_.first_triangle[object] + triangle;
  }

  /// How far the device may be from the sum of magnitudes that a clip coordinate is made from.
  double clip_error(std::size_t object, int row, const Float3& position) const;
  /// The same for world positions, and for normals in the space of world_from_normal.
  double world_error(std::size_t object, int row, const Float3& position) const;
  double normal_error(std::size_t object, int row, const Float3& normal) const;
  /// Of a tangent in world space, which is made unit; infinite where it is too short for that, and not 0.
  double tangent_error(std::size_t object, int row, const Float3& tangent) const;

private:
  struct Magnitudes {
    std::array<Double4, 4> clip; // rows: of one matrix, or of the product of all three's magnitudes
  };

  void lay_out_frame();

  RenderOptions options_;
  const DeviceProfile& profile_;
  ShaderMatrices matrices_;
  Geometry geometry_;
  Bins bins_;
  FrameContext context_;
  std::vector<Magnitudes> magnitudes_; // of each object
  std::unique_ptr<const DeviceShadows> shadows_;
};

} // namespace refraster
