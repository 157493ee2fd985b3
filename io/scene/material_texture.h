#pragma once
// Textures as materials want them.

#include <refraster/memory.h>
#include <refraster/notes.h>
#include <refraster/texture.h>

#include <compare>
#include <memory>
#include <optional>
#include <string>

namespace refraster {

/// Whether a texture has all its smaller levels, for a trilinear filter.
enum class MipLevels { none, all };

/// What a texture's numbers are taken as.
struct TextureReading {
  ColourSpace colour_space = ColourSpace::linear;
  std::optional<ScalarChannel> channel = {}; // of a texture of single numbers; a colour has all

  auto operator<=>(const TextureReading&) const = default;
};

/// Reads an image, decodes what is sRGB, and makes the levels that are wanted: in this order, so that means are those
/// of light. Throws InputError. Notes go nowhere if `notes` is null.
std::shared_ptr<const Texture> material_texture(const std::string& path, const TextureReading& reading,
                                                MipLevels levels, const MemoryBudget& memory, NoteList* notes);

} // namespace refraster
