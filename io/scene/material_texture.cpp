#include "io/scene/material_texture.h"

#include <refraster/files.h>

namespace refraster {

std::shared_ptr<const Texture> material_texture(const std::string& path, const TextureReading& reading,
                                                MipLevels levels, const MemoryBudget& memory, NoteList* notes) {
  auto texture = std::make_shared<Texture>(reading.channel ? read_scalar_texture(path, *reading.channel, memory, notes)
                                                           : read_texture(path, memory, notes));
  if (reading.colour_space == ColourSpace::srgb) decode_srgb(*texture);
  if (levels == MipLevels::all) {
    memory.need(texture->levels.front().rgb.size() * sizeof(float) / 3, path); // 1/4 + 1/16 + …
    build_mip_levels(*texture);
  }
  return texture;
}

} // namespace refraster
