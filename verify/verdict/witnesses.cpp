#include "verify/verdict/witnesses.h"

#include <algorithm>
#include <map>

namespace refraster {
namespace {

/// Its texels moved by a share of the full scale, within what a texture can hold.
std::shared_ptr<const Texture> moved(const Texture& texture, double by) {
  auto copy = std::make_shared<Texture>(texture);
  for (TextureLevel& level : copy->levels)
    for (float& value : level.rgb)
      value =
          static_cast<float>(std::clamp(static_cast<double>(value) + by * texture.full_scale, 0.0, texture.full_scale));
  return copy;
}

Image<float> frame_with(const Scene& scene, const RenderOptions& options, double by) {
  Scene changed = scene;
  std::map<const Texture*, std::shared_ptr<const Texture>> done;
  for_each_material(changed, [&](Material& material) {
    for_each_texture(material, [&](TextureMap& map) {
      if (map.filter == TextureFilter::nearest) return;
      std::shared_ptr<const Texture>& copy = done[map.texture.get()];
      if (!copy) copy = moved(*map.texture, by);
      map.texture = copy;
    });
  });
  return render(changed, options).radiance;
}

} // namespace

std::optional<Witnesses> texel_witnesses(const Scene& scene, const RenderOptions& options,
                                         const DeviceProfile& profile) {
  const double error = profile.texture.filter_error;
  const bool any_filtered = any_material(scene, [](const Material& material) {
    return any_texture(material, [](const TextureMap& map) { return map.filter != TextureFilter::nearest; });
  });
  if (!any_filtered || error == 0) return std::nullopt;
  RenderOptions plain = options;
  plain.want_rgb8 = plain.want_radiance_double = false;
  plain.want_radiance = true;
  plain.aovs.clear();
  return Witnesses{frame_with(scene, plain, -error), frame_with(scene, plain, error)};
}

} // namespace refraster
