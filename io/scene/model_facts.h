#pragma once
// What is in an OBJ file and in the files that it names, and what is missing: `refraster mesh info`.

#include <refraster/files.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// An image that a material names.
struct TextureFact {
  std::string material; // its name
  std::string key;      // "map_Kd"
  std::string written;  // as the library has it
  std::string path;     // what it was found as; empty: missing, or outside the model's folder
};

/// A material that triangles name.
struct MaterialFact {
  std::string name, library; // library: the file that describes it; empty: none does
  std::uint64_t triangles = 0;
};

struct ModelFacts {
  // Statements of the text.
  std::uint64_t v = 0, vt = 0, vn = 0, f = 0;
  // The mesh that became of them.
  std::uint64_t vertices = 0, triangles = 0;
  std::uint64_t triangles_without_vt = 0, triangles_without_material = 0;
  std::uint64_t coloured_vertices = 0;
  Double3 least{0}, most{0}; // of its positions
  std::vector<MaterialFact> materials;
  std::vector<TextureFact> textures;
};

/// Reads a model as `render` does. Throws InputError for what is none.
ModelFacts model_facts(const std::string& path, const SceneOptions& options);

/// Lines to read, and the same as JSON.
std::string model_facts_text(const ModelFacts& facts);
std::string model_facts_json(const std::string& path, const ModelFacts& facts);

} // namespace refraster
