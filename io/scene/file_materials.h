#pragma once
// The materials that OBJ files bring along: their libraries, textures, and what a fragment function makes of them.

#include <refraster/material.h>
#include <refraster/memory.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>

#include "io/scene/model/mtl_material.h"
#include "io/scene/scene_source.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// Reads libraries and textures, each once. Nothing in them is a fault, but a library beyond limit::mtl_bytes: a model
/// is drawn with what there is, and each kind of remark is a note.
class FileMaterials {
public:
  /// No file is looked for where is_outside(path). Notes go nowhere if `notes` is null.
  FileMaterials(std::function<bool(const std::string&)> is_outside, const MemoryBudget& memory, NoteList* notes)
      : is_outside_(std::move(is_outside)), memory_(memory), notes_(notes) {}

  /// Fills the materials that a mesh names from the libraries of its file. Throws InputError for one that is too large.
  void describe(const std::string& obj_path, Mesh& mesh);

  /// What a mesh's materials are drawn with, by their number, with their textures. The mesh must live on.
  const std::vector<Material>& materials(const std::string& obj_path, const Mesh& mesh, FileFunction function);

  /// Where the textures of all these are from.
  TextureFiles texture_files() const;

  /// What is drawn with that names no material, or one that no library describes.
  static Material plain(FileFunction function);

private:
  const std::vector<MeshMaterial>& library(const std::string& path);
  void read_libraries(const std::string& obj_path, const MaterialLibrary& named, Mesh& mesh);
  TextureMap map(const MeshTexture& described, const TextureReading& reading, const MeshMaterial& material,
                 const std::string& obj_path);
  void note(Note note) const {
    if (notes_) notes_->add(std::move(note));
  }

  std::function<bool(const std::string&)> is_outside_;
  MemoryBudget memory_;
  NoteList* notes_;
  std::map<std::string, std::vector<MeshMaterial>> libraries_; // by identity
  /// By identity and what its numbers are taken as; null: it cannot be read.
  std::map<std::pair<std::string, TextureReading>, std::shared_ptr<const Texture>> textures_;
  std::map<std::pair<const Mesh*, FileFunction>, std::vector<Material>> materials_;
};

} // namespace refraster
