#include "io/scene/file_materials.h"

#include <refraster/files.h>

#include "io/file/find_file.h"
#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/file/text.h"
#include "io/mesh/mtl_file.h"
#include "io/scene/material_texture.h"
#include "io/scene/model/mtl_material.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace refraster {
namespace {
namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
  return fs::path(path).parent_path().string();
}

/// The words before a comment: '#' may be part of a name, and is tried as such first.
std::string_view without_comment(std::string_view text) {
  text = text.substr(0, text.find('#'));
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

/// Without textures and light of its own.
Material with_function(const MeshMaterial& described, FileFunction function) {
  Material material;
  switch (function) {
  case FileFunction::phong:
    material.fragment_function = Phong{phong_parameters(described)};
    break;
  case FileFunction::blinn_phong:
    material.fragment_function = BlinnPhong{phong_parameters(described)};
    break;
  case FileFunction::microfacet:
    material.fragment_function = microfacet_parameters(described);
    break;
  }
  return material;
}

/// What is done about a path that does not lead to a file as it is written; empty where it does.
std::string consequence(const FoundFile& found, std::string_view without) {
  switch (found.by) {
  case FoundBy::path:
    return {};
  case FoundBy::slashes:
    return "read with / for \\";
  case FoundBy::last_name:
    return "its last component is read, beside the model";
  case FoundBy::letters:
    return "read without regard to case";
  case FoundBy::none_outside:
    return "outside the model's folder: drawn without " + std::string(without) + "; --allow-outside reads it";
  case FoundBy::none:
    return "there is no such file: drawn without " + std::string(without);
  }
  return {};
}

} // namespace

Material FileMaterials::plain(FileFunction function) {
  return with_function(MeshMaterial{}, function);
}

const std::vector<MeshMaterial>& FileMaterials::library(const std::string& path) {
  const auto [entry, is_new] = libraries_.try_emplace(canonical_path(path));
  if (!is_new) return entry->second;
  if (const std::uint64_t bytes = file_size_bytes(path); bytes > limit::mtl_bytes.value)
    throw InputError(InputFault{path, 0, 0, "", found_of(limit::mtl_bytes, bytes), at_most(limit::mtl_bytes)});
  NoteList notes;
  try {
    entry->second = read_mtl(path, notes);
  } catch (const InputError& error) {
    const InputFault& fault = error.faults().front();
    notes.add({path, 0, fault.found, "not read: expected " + fault.expected});
  }
  if (notes_) notes_->add(notes);
  return entry->second;
}

/// `mtllib` may name several files, and each may have blanks in its name: all of it is tried first.
void FileMaterials::read_libraries(const std::string& obj_path, const MaterialLibrary& named, Mesh& mesh) {
  const std::string folder = folder_of(obj_path);
  const auto find = [&](std::string_view name) { return find_file(folder, folder, name, is_outside_); };
  std::vector<std::pair<std::string, FoundFile>> files;
  for (const std::string_view name : {std::string_view(named.text), without_comment(named.text)})
    if (const FoundFile found = find(name); files.empty() && !found.path.empty())
      files.emplace_back(std::string(name), found);
  if (files.empty()) {
    std::string_view rest = without_comment(named.text);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
      files.emplace_back(std::string(rest.substr(0, end)), find(rest.substr(0, end)));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t", end), rest.size()));
    }
  }
  for (const auto& [name, found] : files) {
    if (const std::string what = consequence(found, "its materials"); !what.empty())
      note({obj_path, named.line, "the material library " + in_quotes(name), what});
    if (found.path.empty()) continue;
    for (const MeshMaterial& described : library(found.path))
      for (MeshMaterial& material : mesh.materials) {
        if (!material.file.empty()) continue; // the first library that has it counts
        if (material.name != described.name && without_comment(material.name) != described.name) continue;
        const std::string of_the_mesh = material.name;
        material = described;
        material.name = of_the_mesh;
      }
  }
}

void FileMaterials::describe(const std::string& obj_path, Mesh& mesh) {
  for (const MaterialLibrary& named : mesh.material_libraries) read_libraries(obj_path, named, mesh);
  if (mesh.material_libraries.empty() && !mesh.materials.empty())
    return note({obj_path, 0, "usemtl without mtllib", "drawn in grey: no file describes its materials"});
  for (const MeshMaterial& material : mesh.materials)
    if (material.file.empty())
      note({obj_path, 0, "the material " + in_quotes(material.name), "drawn in grey: no library describes it"});
}

TextureMap FileMaterials::map(const MeshTexture& described, const TextureReading& reading, const MeshMaterial& material,
                              const std::string& obj_path) {
  TextureMap result;
  if (described.path.empty()) return result;
  result.filter = TextureFilter::trilinear; // as a stranger's texture may be any size
  result.wrap = described.clamp ? TextureWrap::clamp : TextureWrap::repeat;
  result.scale = described.scale, result.offset = described.offset;
  const std::string folder = folder_of(material.file), beside = folder_of(obj_path);
  FoundFile found = find_file(folder, beside, described.path, is_outside_);
  if (found.path.empty())
    if (const FoundFile shorter = find_file(folder, beside, without_comment(described.path), is_outside_);
        !shorter.path.empty())
      found = shorter;
  if (const std::string what = consequence(found, "it"); !what.empty())
    note({material.file, described.line, "the texture " + in_quotes(described.path), what});
  if (found.path.empty()) return result;
  const auto [entry, is_new] = textures_.try_emplace({canonical_path(found.path), reading});
  if (is_new) try {
      entry->second = material_texture(found.path, reading, MipLevels::all, memory_, notes_);
    } catch (const InputError& error) {
      note({found.path, 0, error.faults().front().found,
            "drawn without it: expected " + error.faults().front().expected});
    }
  result.texture = entry->second;
  return result;
}

TextureFiles FileMaterials::texture_files() const {
  TextureFiles files;
  for (const auto& [file, texture] : textures_)
    if (texture) files.emplace(texture.get(), TextureFile{file.first, file.second});
  return files;
}

const std::vector<Material>& FileMaterials::materials(const std::string& obj_path, const Mesh& mesh,
                                                      FileFunction function) {
  const auto [entry, is_new] = materials_.try_emplace({&mesh, function});
  if (!is_new) return entry->second;
  for (const MeshMaterial& described : mesh.materials) {
    Material& material = entry->second.emplace_back(with_function(described, function));
    material.name = described.name;
    // Colours of images are those of screens, where they are looked at; what weighs a highlight is a value.
    material.diffuse_map = map(described.diffuse_map, {ColourSpace::srgb}, described, obj_path);
    if (!material.microfacets()) material.specular_map = map(described.specular_map, {}, described, obj_path);
    material.emissive_map = map(described.emissive_map, {ColourSpace::srgb}, described, obj_path);
    const auto scalar = [&](const MeshTexture& texture, TextureMap Material::*slot) {
      material.*slot = map(texture, {.channel = scalar_channel(texture, declared(slot).channel)}, described, obj_path);
    };
    scalar(described.dissolve_map, &Material::opacity_map), scalar(described.bump_map, &Material::bump_map);
    if (material.microfacets()) {
      scalar(described.roughness_map, &Material::roughness_map);
      scalar(described.metallic_map, &Material::metallic_map);
    }
    material.normal_map = map(described.normal_map, {}, described, obj_path);
    material.emissive = emissive_colour(described);
    material.bump_scale = described.bump_map.bump_multiplier;
    if (notes_) note_what_is_not_shown(described, function, *notes_);
  }
  return entry->second;
}

} // namespace refraster
