#include "io/scene/model/whole_scene.h"

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/json/json.h"
#include "io/json/json_writer.h"
#include "io/scene/model/model_scene.h"
#include "io/scene/scene_edits.h"
#include "io/scene/scene_keys.h"
#include "io/scene/scene_source.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

namespace refraster {
namespace {
namespace fs = std::filesystem;

/// The reading of scene_keys.h that writes a material.
class MaterialWriter {
public:
  MaterialWriter(JsonWriter& json, const Material& material) : json_(json), material_(material) {}

  void operator()(std::string_view key, const auto& value, const Range&, std::string_view, Presence) {
    const auto is_short_form = [&](const TextureSlot& slot) { return key == slot.file_key || key == slot.filter_key; };
    if (std::none_of(texture_slots.begin(), texture_slots.end(), is_short_form)) member(key, value);
  }
  void map(std::string_view key, MapText& text, std::string_view, std::string_view, const Double3*) {
    if (!text.path.given.empty()) json_.object(key, [&] { map_keys(text, *this); });
  }
  template <class M>
  void parameters(M& function, Use use) {
    if (use == Use::other) return;
    function = std::get<M>(material_.fragment_function);
    M::fields(function,
              [&](std::string_view key, const auto& value, const Range&, std::string_view) { member(key, value); });
  }
  void parameters(UserFunction&, Use) {}

private:
  void member(std::string_view key, const PathText& path) {
    if (!path.given.empty()) json_.member(key, path.given);
  }
  void member(std::string_view key, const Double2& v) {
    json_.array(key, [&] { json_.value(v.x), json_.value(v.y); });
  }
  void member(std::string_view key, const Double3& v) {
    json_.array(key, [&] { json_.value(v.x), json_.value(v.y), json_.value(v.z); });
  }
  void member(std::string_view key, double number) { json_.member(key, number); }
  template <NamedEnum Enum>
  void member(std::string_view key, Enum value) {
    const std::string_view word = name_of(value);
    if (word == "true" || word == "false") json_.member(key, word == "true");
    else json_.member(key, word);
  }

  JsonWriter& json_;
  const Material& material_;
};

/// Text as it stands in a document that goes on around it.
std::string indented(std::string text) {
  text.pop_back(); // the line end of the document
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\n    ") : std::string(1, c);
  return result;
}

/// Makes the changes that a scene is written with.
class Writer {
public:
  Writer(const JsonDocument& document, const SceneSource& source, const std::string& path, const std::string& folder)
      : document_(document), textures_(source.textures),
        from_(canonical_path(folder_or_here(fs::path(path).parent_path().string()))),
        to_(canonical_path(folder_or_here(folder))) {
    std::size_t number = 0;
    for (JsonIndex object = find(find(find(0, "scene"), "objects"), ""); object; object = document_[object].next)
      write_object(object, "/scene/objects/" + std::to_string(number), source.scene.objects[number]), ++number;
  }
  const std::vector<SceneEdit>& edits() const { return edits_; }
  bool names_outside() const { return names_outside_; }

private:
  static std::string folder_or_here(const std::string& folder) { return folder.empty() ? "." : folder; }

  /// The member of this name, the first child for "", 0 if there is none.
  JsonIndex find(JsonIndex node, std::string_view key) const {
    JsonIndex i = document_[node].first_child;
    while (i && !key.empty() && document_[i].key != key) i = document_[i].next;
    return i;
  }
  bool is_from_file(JsonIndex node) const {
    return document_[node].kind == JsonKind::string && document_[node].string == from_file_word;
  }

  void write_object(JsonIndex object, const std::string& pointer, const Object& read) {
    const JsonIndex material = find(object, "material"), materials = find(object, "materials");
    bool any = material ? is_from_file(material) : find(object, "obj_file_path") != 0;
    if (materials)
      for (JsonIndex i = document_[materials].first_child; i; i = document_[i].next) any = any || is_from_file(i);
    if (any) write_materials(pointer, read);
    // The default for materials of a file is none for those of a scene.
    if (any && !find(object, "fragment_function") && !find(object, "fragment_shader_file_path"))
      edits_.push_back({pointer + "/fragment_function", json_string(read.material.function_name()), "scene"});
    write_paths(object, pointer, any);
  }

  void write_materials(const std::string& pointer, const Object& read) {
    const std::vector<MeshMaterial>& named = read.mesh->materials;
    const auto can_be_written = [](const MeshMaterial& one) { return as_utf8(one.name) == one.name; };
    if (std::all_of(named.begin(), named.end(), can_be_written)) {
      JsonWriter json;
      write_block(json, read.material);
      edits_.push_back({pointer + "/material", indented(json.text()), "scene"});
    }
    if (read.materials.empty()) return;
    JsonWriter json;
    json.object([&] {
      for (std::size_t i = 0; i < named.size(); ++i) {
        if (!can_be_written(named[i])) continue;
        json.key(named[i].name);
        write_block(json, read.materials[i]);
      }
    });
    edits_.push_back({pointer + "/materials", indented(json.text()), "scene"});
  }

  void write_block(JsonWriter& json, const Material& material) {
    ObjectText text;
    text.object.material = material;
    text.fragment_function.given = true, text.fragment_function.index = material.fragment_function.index();
    for (std::size_t i = 0; i < texture_slots.size(); ++i)
      if (const TextureMap& map = material.*texture_slots[i].map; map.texture) {
        const TextureFile& file = textures_.at(map.texture.get());
        text.maps[i].path.given = relative(file.path);
        text.maps[i].map = map, text.maps[i].reading = file.reading;
      }
    MaterialWriter writer(json, material);
    json.object([&] { material_keys(text, writer); });
  }

  /// Those of an object and all that lies in it; not of materials that are written anew.
  void write_paths(JsonIndex node, const std::string& pointer, bool without_materials) {
    for (JsonIndex i = document_[node].first_child; i; i = document_[i].next) {
      const JsonNode& member = document_[i];
      if (without_materials && member.key.starts_with("material")) continue;
      const std::string at = pointer + '/' + pointer_part(member.key);
      if (member.kind == JsonKind::object) write_paths(i, at, false);
      const auto is_map = [&](const TextureSlot& slot) { return member.key == slot.key; };
      const bool is_path = member.key.ends_with("_file_path") || member.key == "path" ||
                           std::any_of(texture_slots.begin(), texture_slots.end(), is_map);
      if (member.kind != JsonKind::string || !is_path) continue;
      const fs::path given(member.string);
      const std::string written = given.is_absolute() ? given.string() : relative((from_ / given).string());
      if (given.is_absolute()) names_outside_ = names_outside_ || relative(given.string()).starts_with("..");
      if (written != member.string) edits_.push_back({at, json_string(written), "scene"});
    }
  }

  std::string relative(const std::string& path) {
    std::string result = fs::path(path).lexically_relative(to_).string();
    names_outside_ = names_outside_ || result == ".." || result.starts_with("../");
    return result;
  }

  const JsonDocument& document_;
  const TextureFiles& textures_;
  fs::path from_, to_; // folders
  std::vector<SceneEdit> edits_;
  bool names_outside_ = false;
};

} // namespace

WholeScene whole_scene(const std::string& path, const SceneOptions& options, const std::vector<SceneEdit>& edits,
                       const std::string& folder) {
  const SceneSource source = read_scene_source(path, options, edits);
  EditedText edited = edited_text(path, scene_text(path, options.memory), edits);
  const JsonDocument document(path, edited);
  const Writer writer(document, source, path, folder);
  return {edited_text(path, std::move(edited.text), writer.edits()).text, writer.names_outside()};
}

} // namespace refraster
