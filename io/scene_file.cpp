#include "io/scene_file.h"

#include "io/image_file.h"
#include "io/input_file.h"
#include "io/merl_file.h"
#include "io/obj_file.h"
#include "io/scene_reader.h"
#include "raster/primitives.h"

#include <filesystem>
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

/// Files of one kind: each is loaded once, whatever way its path is written, and its faults are told once.
template <class T>
class Files {
public:
  /// Null, with a fault, if it cannot be read. `read(path)` returns a shared_ptr.
  template <class Read>
  std::shared_ptr<const T> load(const std::string& path, FaultList& faults, Read&& read) {
    const auto [entry, is_new] = loaded_.try_emplace(identity(path));
    if (is_new) {
      try {
        entry->second = read(path);
      } catch (const InputError& fault) {
        faults.add(fault);
      }
    }
    return entry->second;
  }

private:
  std::map<std::string, std::shared_ptr<const T>> loaded_;
};

std::shared_ptr<const Mesh> make_mesh(const Shape& shape) {
  struct Make {
    Mesh operator()(const SphereShape& s) const { return sphere_mesh(s.segments, s.rings); }
    Mesh operator()(const CubeShape&) const { return cube_mesh(); }
    Mesh operator()(const PlaneShape& s) const { return plane_mesh(s.segments); }
    Mesh operator()(const TorusShape& s) const { return torus_mesh(s.segments, s.rings, s.tube_radius); }
  };
  return std::make_shared<const Mesh>(std::visit(Make{}, shape));
}

/// Everything that the objects name, loaded or made.
class Loader {
public:
  Loader(const std::string& scene_path, FaultList& faults) : folder_(fs::path(scene_path).parent_path()), faults_(faults) {}

  /// Which textures need a mip chain is known before the first is loaded: a loaded texture never changes.
  void note(const ObjectText& text) {
    if (!text.texture_file.given.empty() && text.object.material.texture_filter == TextureFilter::trilinear)
      trilinear_.insert(identity(path_of(text.texture_file)));
  }

  Object object(const ObjectText& text) {
    Object result = text.object;
    result.vertex_shader_path = path_of(text.vertex_shader);
    result.fragment_shader_path = path_of(text.fragment_shader);
    if (text.shape) result.mesh = shape(*text.shape);
    if (!text.obj_file.given.empty())
      result.mesh = meshes_.load(path_of(text.obj_file), faults_,
                                 [](const std::string& path) { return std::make_shared<const Mesh>(read_obj(path)); });
    if (result.name.empty())
      result.name = text.shape ? std::string(std::visit([](auto& s) { return s.name; }, *text.shape))
                               : fs::path(text.obj_file.given).stem().string();
    if (Merl* const merl = std::get_if<Merl>(&result.material.model)) {
      if (!text.brdf_file.given.empty()) merl->table = tables_.load(path_of(text.brdf_file), faults_, read_merl);
    } else if (!text.texture_file.given.empty()) {
      result.material.texture = textures_.load(path_of(text.texture_file), faults_, [&](const std::string& path) {
        auto texture = std::make_shared<Texture>(read_texture(path));
        if (trilinear_.contains(identity(path))) build_mip_levels(*texture);
        return texture;
      });
    }
    return result;
  }

private:
  std::string path_of(const PathText& text) const {
    return text.given.empty() ? std::string() : (folder_ / text.given).string();
  }
  std::shared_ptr<const Mesh> shape(const Shape& wanted) {
    for (const auto& [made, mesh] : shapes_)
      if (made == wanted) return mesh;
    return shapes_.emplace_back(wanted, make_mesh(wanted)).second;
  }

  fs::path folder_;
  FaultList& faults_;
  Files<Mesh> meshes_;
  Files<Texture> textures_;
  Files<MerlTable> tables_;
  std::set<std::string> trilinear_; // identities of textures
  std::vector<std::pair<Shape, std::shared_ptr<const Mesh>>> shapes_;
};

} // namespace

Scene read_scene(const std::string& path) {
  const JsonDocument document(path, read_file(path, "a scene file", JsonDocument::max_bytes));
  FaultList faults;
  Scene scene;
  std::vector<ObjectText> objects;
  if (document[0].kind != JsonKind::object)
    throw InputError(document.fault_at(document[0].begin, "", document.describe(document[0]), "an object with the key scene"));
  SceneReader root(document, 0, "", faults);
  root.object("scene", required, "", [&](auto& keys) { scene_keys(scene, objects, keys); });
  root.finish();
  faults.sort_by_place();

  Loader loader(path, faults);
  for (const ObjectText& text : objects) loader.note(text);
  for (const ObjectText& text : objects) scene.objects.push_back(loader.object(text));
  faults.throw_if_any();
  return scene;
}

} // namespace refraster
