#include "io/scene/not_a_scene.h"

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/file/text_kind.h"
#include "io/image/image_formats.h"
#include "io/scene/example_scene.h"
#include "io/scene/model_scene.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

/// What another file may be for in a scene.
enum class Use { obj, other_mesh, texture, table, shader, none };

struct Kind {
  std::string_view name; // "an OBJ file"
  Use use;
};

constexpr Kind obj{"an OBJ file", Use::obj}, stl{"an STL file", Use::other_mesh}, ply{"a PLY file", Use::other_mesh},
    gltf{"a glTF file", Use::other_mesh}, fbx{"an FBX file", Use::other_mesh},
    collada{"a COLLADA file", Use::other_mesh}, studio{"a 3DS file", Use::other_mesh},
    blender{"a Blender file", Use::other_mesh}, usd{"a USD file", Use::other_mesh},
    mtl{"the materials of an OBJ file", Use::none}, image{"an image", Use::texture}, table{"a MERL table", Use::table},
    glsl{"GLSL", Use::shader}, binary{"a binary file", Use::none};

/// Bytes that files of a kind begin with.
constexpr std::pair<std::string_view, Kind> beginnings[] = {
    {"glTF"sv, gltf},     {"Kaydara FBX Binary"sv, fbx},
    {"; FBX"sv, fbx},     {"ply\n"sv, ply},
    {"ply\r"sv, ply},     {"BLENDER"sv, blender},
    {"PXR-USDC"sv, usd},  {"#usda"sv, usd},
    {"#version"sv, glsl}, {"\x5a\0\0\0\x5a\0\0\0\xb4\0\0\0"sv, table}, // 90, 90, 180
};

/// Of file names; those of images are in the list of image formats.
constexpr std::pair<std::string_view, Kind> extensions[] = {
    {"obj", obj},   {"stl", stl},     {"ply", ply},    {"gltf", gltf},     {"glb", gltf},
    {"fbx", fbx},   {"dae", collada}, {"3ds", studio}, {"blend", blender}, {"usd", usd},
    {"usda", usd},  {"usdc", usd},    {"usdz", usd},   {"mtl", mtl},       {"binary", table},
    {"glsl", glsl}, {"vert", glsl},   {"frag", glsl},  {"vs", glsl},       {"fs", glsl},
};

/// The statements that a line of an OBJ file begins with.
constexpr std::string_view obj_words[] = {"v", "vt", "vn", "f", "o", "g", "s", "l", "p", "mtllib", "usemtl"};

/// A binary STL file has 80 bytes of anything, the number of its triangles, and 50 bytes for each.
bool is_binary_stl(std::string_view prefix, std::uint64_t size_bytes) {
  if (prefix.size() < 84) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, prefix.data() + 80, sizeof triangles);
  return triangles > 0 && size_bytes == 84 + 50 * std::uint64_t{triangles};
}

/// By the first statement, which is the first word behind comments.
std::optional<Kind> kind_of_statements(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    if (line.empty() || line.front() == '#') continue;
    const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
    if (std::find(std::begin(obj_words), std::end(obj_words), word) != std::end(obj_words)) return obj;
    if (word == "newmtl") return mtl;
    if (word == "solid" && text.find("facet") != std::string_view::npos) return stl;
    return std::nullopt;
  }
  return std::nullopt;
}

/// How much of a file is looked at.
constexpr std::size_t prefix_bytes = std::size_t{1} << 16;

/// Whether the text may be JSON with comments: then what is wrong with it is said of its JSON.
bool may_be_json(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  return text[first] == '{' || text[first] == '[' || text.substr(first).starts_with("//") ||
         text.substr(first).starts_with("/*");
}

std::optional<Kind> kind_of(const std::string& path, std::string_view prefix, std::uint64_t size_bytes) {
  if (format_with_signature(prefix)) return image;
  for (const auto& [beginning, kind] : beginnings)
    if (prefix.starts_with(beginning)) return kind;
  if (const TextKind text = text_kind(prefix); text == TextKind::utf_16 || text == TextKind::utf_32)
    return Kind{name_of(text), Use::none};
  if (is_binary_stl(prefix, size_bytes)) return stl;
  const bool is_binary = prefix.find('\0') != std::string_view::npos;
  if (!is_binary) {
    if (const auto kind = kind_of_statements(prefix)) return kind;
    if (prefix.find("<COLLADA") != std::string_view::npos) return collada;
  }
  if (may_be_json(prefix)) return std::nullopt;
  const std::string ending = extension(path);
  if (format_of_name(path)) return image;
  for (const auto& [listed, kind] : extensions)
    if (ending == listed) return kind;
  if (is_binary) return binary;
  return std::nullopt;
}

/// A name beside the file for a scene that shows it, which no file has yet if possible.
std::string scene_path_beside(const std::string& path) {
  const fs::path stem = fs::path(path).replace_extension();
  std::error_code error;
  const fs::path plain = stem.string() + ".json";
  return fs::exists(plain, error) ? stem.string() + ".scene.json" : plain.string();
}

constexpr const char* keys_hint = "`refraster list scene-format` prints every key.\n";

std::string small_scene() {
  return std::string("A small scene, which needs no other file:\n\n") + example_scene() + "\n" + keys_hint;
}

std::string advice_for(const Kind& kind, const std::string& path) {
  const std::string scene = one_line(scene_path_beside(path)), file_name = fs::path(path).filename().string();
  const std::string shown_name = one_line(file_name);
  switch (kind.use) {
  case Use::obj:
    return "A file whose name ends in .obj is shown as it is. For another name, this scene shows " + shown_name +
           "; save it as " + scene + " and name that instead:\n\n" + model_scene_text(as_utf8(file_name)) + "\n" +
           keys_hint;
  case Use::other_mesh: {
    const std::string converted = one_line(fs::path(file_name).replace_extension(".obj").string());
    return "Meshes are read from OBJ files: convert it with Blender, MeshLab or assimp (assimp export " + shown_name +
           " " + converted + "),\nand name " + converted + " in the place of a scene.\n";
  }
  case Use::texture:
    return "In a scene, the key \"texture_file_path\" of a material names an image. `refraster compare` compares "
           "two.\n" +
           small_scene();
  case Use::table:
    return "In a scene, the key \"brdf_file_path\" of a material names a table, with \"fragment_function\": "
           "\"merl\".\n" +
           small_scene();
  case Use::shader:
    return "In a scene, the key \"fragment_shader_file_path\" of an object names GLSL, which `refraster gl` draws "
           "with.\n" +
           small_scene();
  case Use::none:
    break;
  }
  return small_scene();
}

/// Files in a folder that are scenes by their name, sorted; a few.
std::string scenes_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (extension(at->path().string()) == "json") names.push_back(at->path().string());
  std::sort(names.begin(), names.end());
  constexpr std::size_t most = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) list += (i == 0 ? "" : ", ") + one_line(names[i]);
  return names.size() > most ? list + " …" : list;
}

} // namespace

bool holds_json(const std::string& path) {
  return may_be_json(read_prefix(path, prefix_bytes));
}

std::optional<InputError> not_a_scene(const std::string& path) {
  constexpr std::string_view expected = "a scene file";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const InputFault folder_or_empty{
      path, 0, 0, "", fs::is_directory(status) ? "a folder" : "an empty file", std::string(expected)};
  if (fs::is_directory(status)) {
    const std::string scenes = scenes_in(path);
    return InputError(folder_or_empty, scenes.empty() ? small_scene() : "In it there is " + scenes + "\n");
  }
  if (!fs::is_regular_file(status)) return std::nullopt;
  const std::uint64_t size_bytes = file_size_bytes(path);
  if (size_bytes == 0) return InputError(folder_or_empty, small_scene());
  const std::string prefix = read_prefix(path, prefix_bytes);
  const std::optional<Kind> kind = kind_of(path, prefix, size_bytes);
  if (!kind) return std::nullopt;
  return InputError(InputFault{path, 0, 0, "", std::string(kind->name), std::string(expected)},
                    advice_for(*kind, path));
}

InputError gltf_is_no_scene(const std::string& path) {
  return InputError(InputFault{path, 0, 0, "", std::string(gltf.name), "a scene file"}, advice_for(gltf, path));
}

} // namespace refraster
