#include "verify/hypotheses/prepared.h"

#include <algorithm>
#include <vector>

namespace refraster::hypotheses {
namespace {

TableWithHoles read_all_the_same(const MerlTable& table) {
  const double* const rgb = table.values<double>();
  PaddedVector<double> black(3 * MerlTable::samples, 0.0), marks(3 * MerlTable::samples, 0.0);
  bool any = false;
  for (std::size_t i = 0; i < black.size(); i += 3) {
    const bool measured = std::min({rgb[i], rgb[i + 1], rgb[i + 2]}) >= 0;
    any |= !measured;
    for (std::size_t c = i; c < i + 3; ++c) (measured ? black : marks)[c] = measured ? rgb[c] : std::max(-rgb[c], 0.0);
  }
  if (!any) return {};
  return {std::make_shared<const MerlTable>(std::move(black)), std::make_shared<const MerlTable>(std::move(marks))};
}

} // namespace

Prepared::Prepared(const Scene& scene) {
  for_each_material(scene, [this](const Material& material) {
    if (const Merl* const merl = material.measured(); merl && merl->table)
      if (!tables_.contains(merl->table.get())) tables_[merl->table.get()] = read_all_the_same(*merl->table);
    if (!material.diffuse_map.texture || mip_mapped_.contains(material.diffuse_map.texture.get())) return;
    auto mapped = material.diffuse_map.texture;
    if (mapped->levels.size() == 1) {
      Texture with_levels = *mapped;
      build_mip_levels(with_levels);
      mapped = std::make_shared<const Texture>(std::move(with_levels));
    }
    mip_mapped_[material.diffuse_map.texture.get()] = std::move(mapped);
  });
}

const Texture& Prepared::with_mip_levels(const Texture& texture) const {
  return *mip_mapped_.at(&texture);
}

const TableWithHoles* Prepared::with_holes(const MerlTable& table) const {
  const TableWithHoles& found = tables_.at(&table);
  return found.black ? &found : nullptr;
}

} // namespace refraster::hypotheses
