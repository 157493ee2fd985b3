#include "io/scene/model_facts.h"

#include "io/file/find_file.h"
#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/json/json_writer.h"
#include "io/scene/model_scene.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

namespace refraster {
namespace {
namespace fs = std::filesystem;

/// The images that a material may name.
constexpr std::pair<const char*, MeshTexture MeshMaterial::*> maps[] = {
    {"map_Ka", &MeshMaterial::ambient_map},  {"map_Kd", &MeshMaterial::diffuse_map},
    {"map_Ks", &MeshMaterial::specular_map}, {"map_Ke", &MeshMaterial::emissive_map},
    {"map_d", &MeshMaterial::dissolve_map},  {"map_Bump", &MeshMaterial::bump_map},
    {"norm", &MeshMaterial::normal_map},     {"map_Pr", &MeshMaterial::roughness_map},
    {"map_Pm", &MeshMaterial::metallic_map}};

void count_statements(std::string_view text, ModelFacts& facts) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
    facts.v += word == "v", facts.vt += word == "vt", facts.vn += word == "vn", facts.f += word == "f" || word == "fo";
  }
}

void measure(const Mesh& mesh, ModelFacts& facts) {
  facts.vertices = mesh.positions.size(), facts.triangles = mesh.triangles.size();
  facts.coloured_vertices = mesh.colours.size();
  for (const auto& triangle : mesh.triangles) facts.triangles_without_vt += !has_uvs(mesh, triangle);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  facts.least = Double3(infinity), facts.most = Double3(-infinity);
  for (const Float3& position : mesh.positions)
    for (int c = 0; c < 3; ++c) {
      facts.least[c] = std::min(facts.least[c], static_cast<double>(position[c]));
      facts.most[c] = std::max(facts.most[c], static_cast<double>(position[c]));
    }
}

void count_materials(const Mesh& mesh, ModelFacts& facts) {
  for (const MeshMaterial& material : mesh.materials) facts.materials.push_back({material.name, material.file, 0});
  std::uint64_t named = 0;
  for (std::size_t i = 0; i < mesh.material_runs.size(); ++i) {
    const std::uint64_t begin = mesh.material_runs[i].first_triangle;
    const std::uint64_t end =
        i + 1 < mesh.material_runs.size() ? mesh.material_runs[i + 1].first_triangle : mesh.triangles.size();
    if (mesh.material_runs[i].material >= facts.materials.size()) continue;
    facts.materials[mesh.material_runs[i].material].triangles += end - begin, named += end - begin;
  }
  facts.triangles_without_material = facts.triangles - named;
}

std::string text_of(const Double3& v) {
  return format("%.6g %.6g %.6g", v.x, v.y, v.z);
}

std::string list_of(const std::vector<std::string>& items, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), most); ++i) text += (i == 0 ? "" : ", ") + items[i];
  return items.size() > most ? text + " and " + std::to_string(items.size() - most) + " more" : text;
}

std::string line(const char* label, const std::string& text) {
  return format("%-12s", label) + text + "\n";
}

/// "3 used, all described" and the like: how many there are, and which are missing.
std::string found_and_missing(std::size_t count, const char* what, const char* missing,
                              const std::vector<std::string>& names) {
  constexpr std::size_t most = 8; // names in a line
  if (count == 0) return "none";
  return counted(count, what) +
         (names.empty() ? "" : "; " + std::to_string(names.size()) + ' ' + missing + ": " + list_of(names, most));
}

} // namespace

ModelFacts model_facts(const std::string& path, const SceneOptions& options) {
  if (!is_model(path)) {
    scene_text(path, options.memory); // says what it is
    throw InputError(InputFault{path, 0, 0, "", "a scene", "an OBJ file, whose name ends in .obj"});
  }
  ModelFacts facts;
  const Scene scene = read_scene(path, options);
  const Mesh& mesh = *scene.objects.at(0).mesh;
  options.memory.need(file_size_bytes(path), path);
  count_statements(read_file(path, "an OBJ file", std::numeric_limits<std::uint64_t>::max()), facts);
  measure(mesh, facts);
  count_materials(mesh, facts);
  const std::string folder = fs::path(path).parent_path().string();
  const std::string real_folder = canonical_path(folder.empty() ? "." : folder);
  const auto is_outside = [&](const std::string& file) {
    return options.outside == Outside::refused && !is_within(file, real_folder);
  };
  for (const MeshMaterial& material : mesh.materials)
    for (const auto& [key, map] : maps)
      if (const std::string& written = (material.*map).path; !written.empty()) {
        const FoundFile found = find_file(fs::path(material.file).parent_path().string(), folder, written, is_outside);
        facts.textures.push_back({material.name, key, written, found.path});
      }
  return facts;
}

std::string model_facts_text(const ModelFacts& facts) {
  std::vector<std::string> undescribed, missing;
  for (const MaterialFact& material : facts.materials)
    if (material.library.empty()) undescribed.push_back(in_quotes(material.name));
  for (const TextureFact& texture : facts.textures)
    if (texture.path.empty()) missing.push_back(texture.key + ' ' + in_quotes(texture.written));
  std::string text;
  text += line("bounds", text_of(facts.least) + "  to  " + text_of(facts.most));
  text += line("size", text_of(facts.most - facts.least));
  text += line("positions", with_commas(facts.v) + " in the file, " + with_commas(facts.vertices) +
                                " vertices of the mesh: one for each different position, normal and uv");
  text += line("triangles", with_commas(facts.triangles) + " of " + counted(facts.f, "face"));
  text += line("normals", facts.vn == 0 ? "none in the file: computed from the faces" : with_commas(facts.vn) + " in the file");
  text += line("uvs", facts.vt == 0 ? "none"
                                    : with_commas(facts.vt) + " in the file; " +
                                          counted(facts.triangles_without_vt, "triangle") + " without");
  text += line("colours", facts.coloured_vertices == 0 ? "none" : with_commas(facts.coloured_vertices) + " vertices");
  text += line("materials",
               found_and_missing(facts.materials.size(), "material", "described by no library", undescribed) +
                   (facts.triangles_without_material > 0 && !facts.materials.empty()
                        ? "; " + counted(facts.triangles_without_material, "triangle") + " without"
                        : ""));
  text += line("textures", found_and_missing(facts.textures.size(), "texture", "missing", missing));
  return text;
}

std::string model_facts_json(const std::string& path, const ModelFacts& facts) {
  JsonWriter json;
  const auto three = [&](const char* name, const Double3& v) {
    json.array(name, [&] { json.value(v.x), json.value(v.y), json.value(v.z); });
  };
  json.object([&] {
    json.member("schema", 1);
    json.member("file", path);
    json.object("bounds", [&] { three("least", facts.least), three("most", facts.most); });
    json.object("statements", [&] {
      json.member("v", facts.v), json.member("vt", facts.vt), json.member("vn", facts.vn), json.member("f", facts.f);
    });
    json.member("vertices", facts.vertices);
    json.member("triangles", facts.triangles);
    json.member("triangles_without_vt", facts.triangles_without_vt);
    json.member("triangles_without_material", facts.triangles_without_material);
    json.member("coloured_vertices", facts.coloured_vertices);
    json.member("normals", facts.vn == 0 ? "computed" : "file");
    json.array("materials", [&] {
      for (const MaterialFact& material : facts.materials)
        json.object([&] {
          json.member("name", material.name);
          json.text_or_null("library", material.library);
          json.member("triangles", material.triangles);
        });
    });
    json.array("textures", [&] {
      for (const TextureFact& texture : facts.textures)
        json.object([&] {
          json.member("material", texture.material);
          json.member("key", texture.key);
          json.member("written", texture.written);
          json.text_or_null("path", texture.path);
        });
    });
  });
  return json.text();
}

} // namespace refraster
