#include "verify/hypotheses/prepared.h"

#include "shading/srgb_curve.h"

#include <algorithm>
#include <utility>
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

std::vector<DepthMap> drawn_maps(const Scene& scene) {
  const RenderOptions options;
  const FrameInput frame{scene, options};
  const Scene casters = casters_of(scene);
  DepthMapScratch scratch;
  std::vector<DepthMap> maps;
  for (const LightView& view : light_views(scene, frame.threads))
    maps.emplace_back().draw(frame, casters, view, scratch);
  return maps;
}

Texture mip_mapped(Texture texture) {
  build_mip_levels(texture);
  return texture;
}

} // namespace

Prepared::Prepared(const Scene& scene) {
  for_each_material(scene, [this](const Material& material) {
    if (const Merl* const merl = material.measured(); merl && merl->table)
      if (!tables_.contains(merl->table.get())) tables_[merl->table.get()] = read_all_the_same(*merl->table);
    const std::shared_ptr<const Texture>& texture = material.diffuse_map.texture;
    if (!texture || textures_.contains(texture.get())) return;
    textures_[texture.get()].mip_mapped =
        texture->levels.size() > 1
            ? texture
            : std::make_shared<const Texture>(mip_mapped({texture->full_scale, {texture->levels[0]}}));
  });
  shadow_maps_ = drawn_maps(scene);
}

const Texture& Prepared::with_mip_levels(const Texture& texture) const {
  return *textures_.at(&texture).mip_mapped;
}

const Texture& Prepared::with_other_curve(const Texture& texture) const {
  const TextureVariants& variants = textures_.at(&texture);
  std::call_once(variants.once, [&] {
    Texture changed{texture.full_scale, {texture.levels[0]}};
    if (is_decoded(texture))
      for (float& value : changed.levels[0].rgb) value = static_cast<float>(srgb_encoded(static_cast<double>(value)));
    else decode_srgb(changed);
    variants.other_curve = mip_mapped(std::move(changed));
  });
  return variants.other_curve;
}

const TableWithHoles* Prepared::with_holes(const MerlTable& table) const {
  const TableWithHoles& found = tables_.at(&table);
  return found.black ? &found : nullptr;
}

} // namespace refraster::hypotheses
