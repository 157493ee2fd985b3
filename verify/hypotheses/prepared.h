#pragma once
// What hypotheses need of a scene beside itself, made once for all pixels.

#include <refraster/scene.h>

#include "raster/shadow/map/depth_map.h"

#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace refraster::hypotheses {

/// Whether a texture's values were decoded from sRGB: decode_srgb() leaves values of which 1 means 1.
inline bool is_decoded(const Texture& texture) {
  return texture.full_scale == 1;
}

/// A measured table whose samples that were never measured are read all the same.
struct TableWithHoles {
  std::shared_ptr<const MerlTable> black; // they are 0
  std::shared_ptr<const MerlTable> marks; // minus what the file has there, and 0 everywhere else
};

class Prepared {
public:
  explicit Prepared(const Scene& scene);

  /// With all its mip levels, whether the scene asks for them or not.
  const Texture& with_mip_levels(const Texture& texture) const;
  /// As if what its values mean were mistaken: those of a texture that was decoded from sRGB as they are stored, those
  /// of any other decoded as if they were sRGB; with all its mip levels. Made when it is first asked for, by any
  /// thread.
  const Texture& with_other_curve(const Texture& texture) const;
  /// Null if all of it was measured.
  const TableWithHoles* with_holes(const MerlTable& table) const;

  /// The shadow maps of its lights, in the order of the sum.
  const std::vector<DepthMap>& shadow_maps() const { return shadow_maps_; }

private:
  struct TextureVariants {
    std::shared_ptr<const Texture> mip_mapped;
    mutable std::once_flag once;
    mutable Texture other_curve;
  };
  std::map<const Texture*, TextureVariants> textures_;
  std::map<const MerlTable*, TableWithHoles> tables_;
  std::vector<DepthMap> shadow_maps_;
};

} // namespace refraster::hypotheses
