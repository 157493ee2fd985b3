#include <refraster/files.h>

#include "io/brdf/merl_file.h"
#include "io/file/find_file.h"
#include "io/file/input_file.h"
#include "io/file/nearest.h"
#include "io/file/text.h"
#include "io/mesh/mesh_cache.h"
#include "io/mesh/mesh_normals.h"
#include "io/scene/file_materials.h"
#include "io/scene/material_texture.h"
#include "io/scene/model/model_scene.h"
#include "io/scene/not_a_scene.h"
#include "io/scene/scene_edits.h"
#include "io/scene/scene_reader.h"
#include "io/scene/scene_source.h"
#include "io/scene/shape_mesh.h"
#include "scene/exposure.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace refraster {
namespace {
namespace fs = std::filesystem;

/// Everything that the objects name, loaded or made. Each file is loaded once, and its faults are reported once.
class Loader {
public:
  /// `model`: the identity of the file that the user named in the place of a scene, or empty; `faults`: of the scene
  /// file; `in_files`: of those that it names.
  Loader(const JsonDocument& document, std::string model, const SceneOptions& options, FaultList& faults,
         FaultList& in_files)
      : document_(document), options_(options), model_(std::move(model)),
        folder_(fs::path(document.file()).parent_path()),
        real_folder_(canonical_path(folder_.empty() ? "." : folder_.string())), faults_(faults), in_files_(in_files),
        file_materials_([this](const std::string& path) { return is_outside(path); }, options.memory, options.notes) {}

  /// To be called for every object before the first is loaded: a loaded texture never changes, so it must be known
  /// whether it needs a mip chain; and shapes that are too many are not made.
  void note(const ObjectText& text) {
    if (text.shape) add(mesh_counts(*text.shape));
    if (is_any_from_file(text)) described_.insert(canonical_path(path_of(text.obj_file)));
    note_textures(text);
    for (const ObjectText& one : text.materials) note_textures(one);
  }

  void note_textures(const ObjectText& text) {
    for (const MapText& map : text.maps)
      if (!map.path.given.empty() && map.map.filter == TextureFilter::trilinear)
        trilinear_.insert(canonical_path(path_of(map.path)));
  }

  Object object(const ObjectText& text) {
    Object result = text.object;
    for (const PathText* const shader : {&text.vertex_shader, &text.fragment_shader})
      if (const auto fault = outside_fault(*shader)) faults_.add(*fault);
    result.vertex_shader_path = path_of(text.vertex_shader);
    result.fragment_shader_path = path_of(text.fragment_shader);
    result.mesh = text.shape ? shape(*text.shape) : mesh(text);
    if (!text.shape && result.mesh) add({result.mesh->positions.size(), result.mesh->triangles.size()});
    if (result.name.empty())
      result.name = text.shape ? std::string(std::visit([](auto& s) { return s.name; }, *text.shape))
                               : fs::path(text.obj_file.given).stem().string();
    if (text.material_from == MaterialFrom::scene) load_material(text, result.material);
    else result.material = FileMaterials::plain(function_of(text));
    if (result.mesh) add_materials(text, result);
    if (result.mesh && turns_normals(result)) result.mesh = with_tangents(result.mesh);
    if (result.mesh) note_untextured(text, result);
    for (const PathText* const path : {&text.obj_file, &text.vertex_shader, &text.fragment_shader})
      note_backslashes(*path);
    return result;
  }

  /// Where all textures are from.
  TextureFiles texture_files() const {
    TextureFiles files = file_materials_.texture_files();
    files.insert(texture_files_.begin(), texture_files_.end());
    return files;
  }

private:
  /// What a material that is described in the scene names.
  void load_material(const ObjectText& text, Material& material) {
    note_what_is_not_read(text);
    if (material.measured())
      std::get<Merl>(material.fragment_function).table =
          load(tables_, text.brdf_file, "a MERL table", [&](const std::string& path) {
            options_.memory.need(std::min(file_size_bytes(path), merl_file_bytes), path);
            return read_merl(path);
          });
    for (std::size_t i = 0; i < texture_slots.size(); ++i) {
      if (!shows(material, texture_slots[i])) continue;
      TextureMap& map = material.*texture_slots[i].map;
      map = text.maps[i].map, map.texture = texture(text.maps[i]);
    }
    for (const MapText& map : text.maps) note_backslashes(map.path);
    note_backslashes(text.brdf_file);
  }

  static bool is_any_from_file(const ObjectText& text) {
    const auto is_from_file = [](const ObjectText& one) { return one.material_from == MaterialFrom::file; };
    return is_from_file(text) || std::any_of(text.materials.begin(), text.materials.end(), is_from_file);
  }

  static FileFunction function_of(const ObjectText& text) {
    const std::optional<std::size_t> function = fragment_function_of(text);
    if (function == place_of<Phong>()) return FileFunction::phong;
    return function == place_of<Microfacet>() ? FileFunction::microfacet : FileFunction::blinn_phong;
  }

  /// Those of the mesh, by the names that the file has for them.
  void add_materials(const ObjectText& text, Object& result) {
    const Mesh& mesh = *result.mesh;
    if (mesh.materials.empty() && text.materials.empty()) return;
    if (!is_any_from_file(text) && text.materials.empty()) {
      if (options_.notes && unused_.insert(canonical_path(path_of(text.obj_file))).second)
        options_.notes->add({path_of(text.obj_file), 0, counted(mesh.materials.size(), "material") + " of its own",
                             "not used: the scene's `material` is"});
      return;
    }
    const bool from_file = is_any_from_file(text);
    const std::string path = path_of(text.obj_file);
    const std::vector<Material> none;
    const std::vector<Material>& of_file = from_file ? file_materials_.materials(path, mesh, function_of(text)) : none;
    if (text.material_from == MaterialFrom::file) result.materials = of_file;
    else result.materials.assign(mesh.materials.size(), result.material);
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) result.materials[i].name = mesh.materials[i].name;
    for (const ObjectText& one : text.materials) {
      const std::optional<std::size_t> number = number_of(one, mesh);
      if (!number) continue;
      Material& material = result.materials[*number];
      if (one.material_from == MaterialFrom::file) {
        material = of_file[*number];
      } else {
        material = one.object.material;
        load_material(one, material);
      }
      material.name = mesh.materials[*number].name;
    }
  }

  /// Of the mesh's materials, the one that a key names.
  std::optional<std::size_t> number_of(const ObjectText& one, const Mesh& mesh) {
    std::vector<std::string_view> names;
    for (const MeshMaterial& material : mesh.materials) {
      if (material.name == one.object.material.name) return names.size();
      names.push_back(material.name);
    }
    const PathText& place = one.material_place;
    faults_.add(document_.fault_at(place.offset, place.json_path, "a material that the OBJ file does not name",
                                   names.empty() ? "none: it names no material" : one_of(names, place.given)));
    return {};
  }

  std::shared_ptr<const Texture> texture(const MapText& map) {
    const auto read = [&](const std::string& path) {
      const MipLevels levels = trilinear_.contains(canonical_path(path)) ? MipLevels::all : MipLevels::none;
      auto loaded = material_texture(path, map.reading, levels, options_.memory, options_.notes);
      texture_files_.emplace(loaded.get(), TextureFile{canonical_path(path), map.reading});
      return loaded;
    };
    const auto& [colour_space, channel] = map.reading;
    return load(textures_, map.path, "an image", read,
                std::string(name_of(colour_space)).append(channel ? name_of(*channel) : ""));
  }

  std::shared_ptr<const Mesh> mesh(const ObjectText& text) {
    const auto read = [&](const std::string& path) {
      options_.memory.need(2 * file_size_bytes(path), path); // its text, and no less than as much for what it says
      // A file that is read once more, for other normals or colours, has the same remarks.
      const ObjOptions reading{text.normals, noted_.insert(canonical_path(path)).second ? options_.notes : nullptr,
                               text.colours, options_.threads};
      const std::string& cache = options_.mesh_cache;
      auto mesh =
          std::make_shared<Mesh>(cache.empty() ? read_obj(path, reading) : read_obj_by_cache(path, cache, reading));
      if (described_.contains(canonical_path(path))) file_materials_.describe(path, *mesh);
      return mesh;
    };
    return load(meshes_, text.obj_file, "an OBJ file", read,
                name_of(ObjOptions{.normals = text.normals, .colours = text.colours}));
  }

  static bool turns_normals(const Object& object) {
    const auto turns = [](const Material& material) { return material.turns_normals(); };
    return turns(object.material) || std::any_of(object.materials.begin(), object.materials.end(), turns);
  }

  /// A copy that has them: of a mesh that several objects have, one.
  std::shared_ptr<const Mesh> with_tangents(const std::shared_ptr<const Mesh>& mesh) {
    std::shared_ptr<const Mesh>& entry = with_tangents_[mesh];
    if (!entry) {
      std::uint64_t bytes = mesh->triangles.size() * sizeof mesh->triangles[0] + mesh->uvs.size() * sizeof(Float4);
      for_each_vertex_attribute([&](const auto& attribute) {
        const auto& values = mesh.get()->*attribute.values;
        bytes += values.size() * sizeof values[0];
      });
      options_.memory.need(bytes, "a mesh with tangents");
      auto copy = std::make_shared<Mesh>(*mesh);
      add_tangents(*copy);
      entry = std::move(copy);
    }
    return entry;
  }

  void note_untextured(const ObjectText& text, const Object& object) {
    const Mesh& mesh = *object.mesh;
    if (!options_.notes || text.shape || mesh.uvs.size() == mesh.positions.size()) return;
    std::size_t without = 0;
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    for (std::uint32_t i = 0; i < triangles;) {
      const MaterialRange range = material_range(object, i);
      const bool textured = is_textured(*range.material);
      for (; i < range.end_triangle; ++i) without += textured && !has_uvs(mesh, mesh.triangles[i]);
    }
    if (without > 0 && untextured_.insert(canonical_path(path_of(text.obj_file))).second)
      options_.notes->add({path_of(text.obj_file), 0, counted(without, "triangle") + " without vt",
                           "on which the texture is not shown"});
  }

  void note_backslashes(const PathText& text) {
    if (!options_.notes || text.given.empty()) return;
    if (path_of(text) == plain_path_of(text) || is_outside(path_of(text))) return;
    options_.notes->add({document_.file(), document_.fault_at(text.offset, "", "", "").line, in_quotes(text.given),
                         "read with / for \\"});
  }

  /// To the sum of all objects; an object counts however many share its mesh.
  void add(const MeshCounts& counts) {
    sum_.vertices += counts.vertices;
    sum_.triangles += counts.triangles;
    const auto check = [&](const Limit& limit, std::uint64_t count) {
      if (count > limit.value)
        throw InputError(InputFault{document_.file(), 0, 0, "/scene/objects", found_of(limit, count), at_most(limit)});
    };
    check(limit::vertices, sum_.vertices);
    check(limit::triangles, sum_.triangles);
  }

  template <class T>
  using Files = std::map<std::pair<std::string, std::string>, std::shared_ptr<const T>>; // null: it has a fault

  /// Null if no file is given, or, with a fault, if it cannot be read. Files are known by their identity, and the way
  /// in which they are read. A file that is not there at all is a fault of the scene, at the key that names it; what is
  /// in the file, is one of the file.
  template <class T, class Read>
  std::shared_ptr<const T> load(Files<T>& files, const PathText& text, std::string_view expected, Read&& read,
                                const std::string& way = {}) {
    if (text.given.empty()) return nullptr;
    const std::string path = path_of(text), file = canonical_path(path);
    const auto [entry, is_new] = files.try_emplace({file, way});
    if (!is_new || faulty_.contains(file)) return entry->second;
    if (const auto fault = outside_fault(text)) {
      faults_.add(*fault);
      faulty_.insert(file);
      return nullptr;
    }
    constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max(); // the reader knows its limit
    if (const auto fault = file_fault(path, expected, any_size)) {
      faults_.add(document_.fault_at(text.offset, text.json_path, fault->found + ", " + path, fault->expected));
      faulty_.insert(file);
      return nullptr;
    }
    try {
      entry->second = read(path);
    } catch (const InputError& error) {
      in_files_.add(error);
      faulty_.insert(file);
    }
    return entry->second;
  }

  /// Whether a path leads out of the scene's folder. It may name nothing: whether something is there is not reported.
  std::optional<InputFault> outside_fault(const PathText& text) const {
    if (text.given.empty() || !is_outside(path_of(text))) return {};
    return document_.fault_at(text.offset, text.json_path, in_quotes(text.given) + ", outside the scene's folder",
                              "a path within it, or --allow-outside");
  }

  /// The key that a texture's path stands at.
  static std::string_view map_key(const TextureSlot& slot, const MapText& map) {
    return map.path.json_path.ends_with(slot.file_key) && !slot.file_key.empty() ? slot.file_key : slot.key;
  }

  /// A material may name a file that its own fragment function has no use for: then its picture may surprise.
  void note_what_is_not_read(const ObjectText& text) const {
    if (!options_.notes) return;
    const Material& material = text.object.material;
    const bool measured = material.measured() != nullptr;
    const auto note = [&](std::string_view key, const PathText& path, const char* why) {
      if (path.given.empty()) return;
      options_.notes->add({document_.file(), document_.fault_at(path.offset, "", "", "").line,
                           std::string(key) + ' ' + in_quotes(path.given),
                           "not read: the fragment function " + std::string(material.function_name()) + why});
    };
    if (material.emissive != Double3(0) && (measured || material.user_function))
      options_.notes->add({document_.file(), 0, "emissive of " + in_quotes(material.function_name()),
                           "not used: it has no light of its own"});
    if (!measured) note("brdf_file_path", text.brdf_file, " uses no measured table");
    for (std::size_t i = 0; i < texture_slots.size(); ++i) {
      const TextureSlot& slot = texture_slots[i];
      if (slot.use == SlotUse::surface) continue; // of any function
      const std::string_view key = map_key(slot, text.maps[i]);
      if (measured) note(key, text.maps[i].path, " shows no texture");
      else if (material.user_function && slot.map != &Material::diffuse_map)
        note(key, text.maps[i].path, " shows no other texture than the diffuse one");
      else if (!shows(material, slot)) note(key, text.maps[i].path, " does not use it");
    }
  }

  std::string plain_path_of(const PathText& text) const {
    return text.given.empty() ? std::string() : (folder_ / text.given).string();
  }
  /// With / for \, where that names a file and the path as it stands does not: it was written under Windows.
  std::string path_of(const PathText& text) const {
    const std::string plain = plain_path_of(text);
    std::error_code none; // what cannot be asked is not there
    if (text.given.find('\\') == std::string::npos || fs::exists(plain, none)) return plain;
    std::string given = text.given;
    std::replace(given.begin(), given.end(), '\\', '/');
    const std::string path = (folder_ / given).string();
    // Of a place outside, whether something is there is not reported.
    return is_outside(path) || fs::exists(path, none) ? path : plain;
  }
  bool is_outside(const std::string& path) const {
    if (options_.outside == Outside::allowed) return false;
    // The model may be a link, but to what the user named.
    return !is_within(path, real_folder_) && (model_.empty() || canonical_path(path) != model_);
  }
  std::shared_ptr<const Mesh> shape(const Shape& wanted) {
    for (const auto& [made, mesh] : shapes_)
      if (made == wanted) return mesh;
    const MeshCounts counts = mesh_counts(wanted);
    options_.memory.need(counts.size_bytes(),
                         std::to_string(counts.triangles) + " triangles of a " +
                             std::string(std::visit([](const auto& s) { return s.name; }, wanted)));
    return shapes_.emplace_back(wanted, make_mesh(wanted)).second;
  }

  const JsonDocument& document_;
  const SceneOptions& options_;
  std::string model_;
  fs::path folder_;
  std::string real_folder_;
  FaultList &faults_, &in_files_;
  MeshCounts sum_;
  Files<Mesh> meshes_;
  Files<Texture> textures_;
  TextureFiles texture_files_; // where those are from
  Files<MerlTable> tables_;
  std::set<std::string> trilinear_;                   // identities of textures
  std::set<std::string> faulty_, noted_, untextured_; // identities of files whose faults, or remarks, are reported
  std::set<std::string> unused_;    // identities of OBJ files whose materials are reported not to be used
  std::set<std::string> described_; // identities of OBJ files whose materials are read
  FileMaterials file_materials_;
  std::vector<std::pair<Shape, std::shared_ptr<const Mesh>>> shapes_;
  std::map<std::shared_ptr<const Mesh>, std::shared_ptr<const Mesh>> with_tangents_; // by the mesh without
};

/// As the options have it. Returns how many lights have another shadow than the file says.
std::size_t change_shadows(const SceneOptions& options, Scene& scene) {
  std::size_t changed = 0;
  for_each_light_list(scene, [&](auto& lights) {
    for (auto& light : lights) {
      if (light.shadow == Shadow::none) continue;
      if (options.shadow && light.shadow != *options.shadow) light.shadow.kind = *options.shadow, ++changed;
      if (options.shadow_map_size) light.shadow.map.size = *options.shadow_map_size;
    }
  });
  return changed;
}

} // namespace

Scene read_scene(const std::string& path, const SceneOptions& options) {
  SceneSource source = read_scene_source(path, options);
  const Picture& picture = source.view.picture;
  return std::move(source).placed(picture.width, picture.height);
}

SceneSource read_scene_source(const std::string& path, const SceneOptions& options,
                              const std::vector<SceneEdit>& edits) {
  const std::string model = is_model(path) ? canonical_path(path) : std::string();
  const JsonDocument document(path, edited_text(path, scene_text(path, options.memory), edits));
  FaultList faults;
  SceneSource source;
  Scene& scene = source.scene;
  std::vector<ObjectText> objects;
  if (document[0].kind != JsonKind::object)
    throw InputError(
        document.fault_at(document[0].begin, "", document.describe(document[0]), "an object with the key scene"));
  for (JsonIndex i = document[0].first_child; i; i = document[i].next)
    if (document[i].key == "asset" && document[i].kind == JsonKind::object) throw gltf_is_no_scene(path);
  SceneReader top(document, 0, "", faults);
  top.object("scene", required, "",
             [&](auto& keys) { scene_keys(scene, source.view, objects, options.user_functions, keys); });
  top.finish();

  FaultList in_files;
  Loader loader(document, model, options, faults, in_files);
  for (const ObjectText& text : objects) loader.note(text);
  for (const ObjectText& text : objects) scene.objects.push_back(loader.object(text));
  faults.sort_by_place();
  faults.add(in_files);
  faults.throw_if_any();
  if (options.notes && has_shadows(scene) &&
      any_material(scene, [](const Material& material) { return material.has_cut_outs(); }))
    options.notes->add({path, 0, "opacity_map", "makes no holes in shadows: triangles cast them whole"});
  if (const std::size_t changed = change_shadows(options, scene); options.notes && changed > 0)
    options.notes->add({path, 0, "shadow",
                        std::to_string(changed) + (changed == 1 ? " light has" : " lights have") +
                            " another than the file says: " + std::string(name_of(*options.shadow))});
  expose(scene, options.exposure_stops);
  source.textures = loader.texture_files();
  return source;
}

} // namespace refraster
