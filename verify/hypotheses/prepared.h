#pragma once
// What hypotheses need of a scene beside itself, made once for all pixels.

#include <refraster/scene.h>

#include <map>
#include <memory>

namespace refraster::hypotheses {

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
  /// Null if all of it was measured.
  const TableWithHoles* with_holes(const MerlTable& table) const;

private:
  std::map<const Texture*, std::shared_ptr<const Texture>> mip_mapped_;
  std::map<const MerlTable*, TableWithHoles> tables_;
};

} // namespace refraster::hypotheses
