#include "io/mesh/mtl_file.h"
#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include <cmath>
#include <initializer_list>
#include <set>
#include <sstream>

namespace refraster::fuzz {
namespace {

void require_number(const std::optional<double>& number, std::string_view law) {
  require(!number || (std::isfinite(*number) && *number >= 0), law);
}

void require_colour(const std::optional<Double3>& colour) {
  for (int c = 0; colour && c < 3; ++c) require_number((*colour)[c], "a colour is finite, and not negative");
}

void require_texture(const MeshTexture& texture, int lines) {
  require(texture.path.empty() || (texture.line >= 1 && texture.line <= lines),
          "a texture stands on a line of the file");
  for (const double number :
       {texture.scale.x, texture.scale.y, texture.offset.x, texture.offset.y, texture.bump_multiplier})
    require(std::isfinite(number), "options of a texture are finite");
}

} // namespace

void read_mtl_bytes(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  NoteList notes;
  const PeakMemory peak;
  const std::vector<MeshMaterial> materials = parse_mtl("m.mtl", text, notes);
  require_memory(peak, bytes.size(), 1 << 17, 600);
  const auto lines = static_cast<int>(bytes.size()) + 1;
  require(notes.notes().size() <= 64, "a note a kind");
  std::set<std::string> names;
  for (const MeshMaterial& material : materials) {
    require(!material.name.empty() && names.insert(material.name).second, "each material has a name of its own");
    require(material.file == "m.mtl" && material.line >= 1 && material.line <= lines, "a material has a place");
    for (const auto& colour : {material.ambient, material.diffuse, material.specular, material.emissive})
      require_colour(colour);
    for (const auto& number : {material.exponent, material.dissolve, material.roughness, material.metallic})
      require_number(number, "a number is finite, and not negative");
    require(!material.illumination || (*material.illumination >= 0 && *material.illumination <= 10),
            "a model of illumination is one of the format's");
    for (const MeshTexture* const texture : {&material.ambient_map, &material.diffuse_map, &material.specular_map,
                                             &material.emissive_map, &material.dissolve_map, &material.bump_map,
                                             &material.normal_map, &material.roughness_map, &material.metallic_map})
      require_texture(*texture, lines);
  }
}

} // namespace refraster::fuzz
