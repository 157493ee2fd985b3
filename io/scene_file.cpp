#include "io/scene_file.h"

#include "io/image_file.h"
#include "io/input_file.h"
#include "io/merl_file.h"
#include "io/mesh_cache.h"
#include "io/obj_file.h"
#include "io/scene_reader.h"
#include "raster/primitives.h"

#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace refraster {
namespace {
namespace fs = std::filesystem;

/// The same for every way to write the path of one file.
std::string identity(const std::string& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path : canonical.string();
}

std::shared_ptr<const Mesh> make_mesh(const Shape& shape) {
  struct Make {
    Mesh operator()(const SphereShape& s) const { return sphere_mesh(s.segments, s.rings); }
    Mesh operator()(const CubeShape&) const { return cube_mesh(); }
    Mesh operator()(const PlaneShape& s) const { return plane_mesh(s.segments); }
    Mesh operator()(const TorusShape& s) const { return torus_mesh(s.segments, s.rings, s.tube_radius); }
    Mesh operator()(const KnotShape& s) const { return knot_mesh(s.segments, s.rings, s.tube_radius); }
  };
  return std::make_shared<const Mesh>(std::visit(Make{}, shape));
}

/// Everything that the objects name, loaded or made. Each file is loaded once, and its faults are told once.
class Loader {
public:
  /// `faults`: of the scene file; `in_files`: of those that it names.
  Loader(const JsonDocument& document, const std::string& mesh_cache, FaultList& faults, FaultList& in_files)
      : document_(document), folder_(fs::path(document.file()).parent_path()), mesh_cache_(mesh_cache), faults_(faults),
        in_files_(in_files) {}

  /// Which textures need a mip chain is known before the first is loaded: a loaded texture never changes.
  void note(const ObjectText& text) {
    if (!text.texture_file.given.empty() && text.object.material.texture_filter == TextureFilter::trilinear)
      trilinear_.insert(identity(path_of(text.texture_file)));
  }

  Object object(const ObjectText& text) {
    Object result = text.object;
    result.vertex_shader_path = path_of(text.vertex_shader);
    result.fragment_shader_path = path_of(text.fragment_shader);
    result.mesh =
        text.shape ? shape(*text.shape) : load(meshes_, text.obj_file, "an OBJ file", [&](const std::string& path) {
          return std::make_shared<const Mesh>(mesh_cache_.empty() ? read_obj(path)
                                                                  : read_obj_by_cache(path, mesh_cache_));
        });
    if (result.name.empty())
      result.name = text.shape ? std::string(std::visit([](auto& s) { return s.name; }, *text.shape))
                               : fs::path(text.obj_file.given).stem().string();
    if (Merl* const merl = std::get_if<Merl>(&result.material.model)) {
      merl->table = load(tables_, text.brdf_file, "a MERL table", read_merl);
    } else {
      result.material.texture = load(textures_, text.texture_file, "an image", [&](const std::string& path) {
        auto texture = std::make_shared<Texture>(read_texture(path));
        if (trilinear_.contains(identity(path))) build_mip_levels(*texture);
        return texture;
      });
    }
    return result;
  }

private:
  template <class T>
  using Files = std::map<std::string, std::shared_ptr<const T>>; // by identity; null: it has a fault

  /// Null if no file is given, or, with a fault, if it cannot be read. A file that is not there at all is a fault of
  /// the scene, at the key that names it; what is in the file, is one of the file.
  template <class T, class Read>
  std::shared_ptr<const T> load(Files<T>& files, const PathText& text, std::string_view expected, Read&& read) {
    if (text.given.empty()) return nullptr;
    const std::string path = path_of(text);
    const auto [entry, is_new] = files.try_emplace(identity(path));
    if (!is_new) return entry->second;
    constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max(); // the reader knows its limit
    if (const auto fault = file_fault(path, expected, any_size)) {
      faults_.add(document_.fault_at(text.offset, text.json_path, fault->found + ", " + path, fault->expected));
      return nullptr;
    }
    try {
      entry->second = read(path);
    } catch (const InputError& error) {
      in_files_.add(error);
    }
    return entry->second;
  }

  std::string path_of(const PathText& text) const {
    return text.given.empty() ? std::string() : (folder_ / text.given).string();
  }
  std::shared_ptr<const Mesh> shape(const Shape& wanted) {
    for (const auto& [made, mesh] : shapes_)
      if (made == wanted) return mesh;
    return shapes_.emplace_back(wanted, make_mesh(wanted)).second;
  }

  const JsonDocument& document_;
  fs::path folder_;
  const std::string& mesh_cache_;
  FaultList &faults_, &in_files_;
  Files<Mesh> meshes_;
  Files<Texture> textures_;
  Files<MerlTable> tables_;
  std::set<std::string> trilinear_; // identities of textures
  std::vector<std::pair<Shape, std::shared_ptr<const Mesh>>> shapes_;
};

} // namespace

Scene read_scene(const std::string& path, const std::string& mesh_cache) {
  const JsonDocument document(path, read_file(path, "a scene file", JsonDocument::max_bytes));
  FaultList faults;
  Scene scene;
  std::vector<ObjectText> objects;
  if (document[0].kind != JsonKind::object)
    throw InputError(
        document.fault_at(document[0].begin, "", document.describe(document[0]), "an object with the key scene"));
  SceneReader root(document, 0, "", faults);
  root.object("scene", required, "", [&](auto& keys) { scene_keys(scene, objects, keys); });
  root.finish();

  FaultList in_files;
  Loader loader(document, mesh_cache, faults, in_files);
  for (const ObjectText& text : objects) loader.note(text);
  for (const ObjectText& text : objects) scene.objects.push_back(loader.object(text));
  faults.sort_by_place();
  faults.add(in_files);
  faults.throw_if_any();
  return scene;
}

} // namespace refraster
