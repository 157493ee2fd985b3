// refraster.Scene, refraster.Camera, refraster.Object, refraster.load

#include "python/scene/scenes.h"

#include "python/work.h"

#include <array>

namespace refraster::python {
namespace {

/// What a fit decides, or, but for the position, takes as given.
void def_placed(py::class_<LiveCamera, std::shared_ptr<LiveCamera>>& type) {
  const auto number = [&](const char* name, std::optional<double> CameraFit::*of_fit, const char* doc) {
    type.def_property(
        name,
        [name, of_fit](LiveCamera& self) -> py::object {
          return self.fit ? py::cast(self.fit->fit.*of_fit) : field_value(self, name);
        },
        [name, of_fit](LiveCamera& self, const py::object& given) {
          const std::string place = std::string("Camera.") + name;
          if (!self.fit) return set_field(self, name, given, place);
          std::optional<double> value;
          if (!given.is_none()) read_argument(place, given, Range{.ends = Ends::excluded}, value.emplace());
          self.fit->fit.*of_fit = value;
        },
        doc);
  };
  number("near", &CameraFit::near, "Distance of the near plane, > 0. With a fit: None unless it is given.");
  number("far", &CameraFit::far, "Distance of the far plane, > near. With a fit: None unless it is given.");
  type.def_property(
      "target",
      [](LiveCamera& self) -> py::object {
        if (!self.fit) return field_value(self, "target");
        return self.fit->fit.target ? python_value(*self.fit->fit.target) : py::none();
      },
      [](LiveCamera& self, const py::object& given) {
        if (!self.fit) return set_field(self, "target", given, "Camera.target");
        std::optional<Double3> target;
        if (!given.is_none()) read_argument("Camera.target", given, any_number, target.emplace());
        self.fit->fit.target = target;
      },
      "The point looked at, world space; three numbers. With a fit: None unless it is given.");
  type.def_property(
      "position", [](LiveCamera& self) -> py::object { return self.fit ? py::none() : field_value(self, "position"); },
      [](LiveCamera& self, const py::object& given) {
        if (self.fit)
          throw ArgumentError("Camera.position", "a camera with a fit, which gives it one",
                              "scene.place(size) before, or camera.fit = None");
        set_field(self, "position", given, "Camera.position");
      },
      "Where the eye is, world space; three numbers. With a fit: None, and not to be set.");
}

void bind_camera(py::module_& module) {
  py::class_<LiveCameraFit, std::shared_ptr<LiveCameraFit>> fit(
      module, "CameraFit", "From which side a camera looks at all that the scene shows; angles in degrees.");
  def_keywords(fit, "CameraFit");
  def_fields(fit, "CameraFit");
  def_repr(fit, "CameraFit");
  fit.def_property(
      "distance", [](const LiveCameraFit& self) { return self.fit.distance; },
      [](LiveCameraFit& self, const py::object& given) {
        std::optional<double> distance;
        if (!given.is_none())
          read_argument("CameraFit.distance", given, Range{.ends = Ends::excluded}, distance.emplace());
        self.fit.distance = distance;
      },
      "From the point looked at, > 0; None: as near as lets every vertex be seen.");

  py::class_<LiveCamera, std::shared_ptr<LiveCamera>> camera(
      module, "Camera", "OpenGL's camera: right-handed, looks down its own -Z. fov_y is in degrees.");
  def_keywords(camera, "Camera");
  def_fields(camera, "Camera");
  def_repr(camera, "Camera");
  def_placed(camera);
  camera.def_property(
      "fit", [](const LiveCamera& self) { return self.fit; },
      [](LiveCamera& self, const py::object& given) {
        if (!given.is_none() && !py::isinstance<LiveCameraFit>(given))
          refuse_argument("Camera.fit", given, "a CameraFit or None");
        self.fit = py::cast<std::shared_ptr<LiveCameraFit>>(given);
      },
      "A CameraFit, which gives the camera its place for each size of image anew; or None.");
}

std::shared_ptr<LiveMaterial> material_argument(const std::string& place, const py::object& given) {
  if (py::isinstance<LiveMaterial>(given)) return py::cast<std::shared_ptr<LiveMaterial>>(given);
  if (given.is_none()) return py::cast<std::shared_ptr<LiveMaterial>>(py::type::of<LiveMaterial>()());
  // A fragment function is one, without anything beside it.
  try {
    return py::cast<std::shared_ptr<LiveMaterial>>(py::type::of<LiveMaterial>()(given));
  } catch (const py::error_already_set&) {
    refuse_argument(place, given, "a Material, or a fragment function");
  }
}

std::shared_ptr<LiveMesh> mesh_argument(const py::object& given) {
  if (!py::isinstance<LiveMesh>(given)) refuse_argument("Object.mesh", given, "a Mesh");
  return py::cast<std::shared_ptr<LiveMesh>>(given);
}

void bind_object(py::module_& module) {
  py::class_<LiveObject, std::shared_ptr<LiveObject>> type(
      module, "Object", "A mesh, placed: world from object is T . Rx . Ry . Rz . S, angles in degrees.");
  type.def(py::init([](const py::object& mesh, const py::object& material, const py::kwargs& given) {
             auto self = std::make_shared<LiveObject>();
             self->mesh = mesh_argument(mesh);
             self->material = material_argument("Object.material", material);
             set_attributes(py::cast(self), "Object", given);
             return self;
           }),
           py::arg("mesh"), py::arg("material") = py::none());
  type.def_property(
      "mesh", [](const LiveObject& self) { return self.mesh; },
      [](LiveObject& self, const py::object& given) { self.mesh = mesh_argument(given); }, "The Mesh.");
  type.def_property(
      "material", [](const LiveObject& self) { return self.material; },
      [](LiveObject& self, const py::object& given) { self.material = material_argument("Object.material", given); },
      "The Material, where `materials` has nothing else; set also by a fragment function.");
  type.def_property(
      "materials", [](const LiveObject& self) { return self.materials; },
      [](LiveObject& self, const py::iterable& given) { self.materials = py::list(given); },
      "A list of Material: of the mesh's material_runs, by their number.");
  def_fields(type, "Object");
  def_repr(type, "Object");
}

template <std::size_t... I>
void def_light_lists(py::class_<LiveScene, std::shared_ptr<LiveScene>>& type, std::index_sequence<I...>) {
  const auto def = [&]<class Light>(std::vector<Light> Scene::*, std::size_t index) {
    type.def_property(
        std::string(Light::names.key).c_str(), [index](const LiveScene& self) { return self.lights[index]; },
        [index](LiveScene& self, const py::iterable& given) { self.lights[index] = py::list(given); },
        ("A list of the scene's " + std::string(Light::names.words) + ".").c_str());
  };
  (def(std::get<I>(light_lists), I), ...);
}

/// For an image of this size, for good.
void place_scene(LiveScene& self, const py::object& size) {
  const auto [width, height] =
      size.is_none() ? std::pair(self.picture.width, self.picture.height) : size_argument("size", size);
  SceneSource source = source_of(self);
  place(source.scene, source.view, width, height);
  self.camera->camera = source.scene.camera;
  self.camera->fit.reset();
  std::size_t index = 0;
  for_each_light_list(source.scene, [&]<class Light>(std::vector<Light>& list) {
    std::size_t i = 0;
    for (const py::handle item : self.lights[index++]) {
      auto& light = py::cast<LiveLight<Light>&>(item);
      light.light = list[i++], light.space = LightSpace::world;
    }
  });
}

std::vector<std::string> faults_of(const LiveScene& self) {
  SceneSource source = source_of(self);
  place(source.scene, source.view, self.picture.width, self.picture.height);
  std::vector<std::string> texts;
  for (const SceneFault& fault : validate(source.scene)) texts.push_back(fault.text());
  return texts;
}

std::vector<SceneEdit> edits_of(const py::dict& set) {
  std::vector<SceneEdit> edits;
  const py::object dumps = py::module_::import("json").attr("dumps");
  for (const auto& [pointer, value] : set) {
    if (!py::isinstance<py::str>(pointer))
      refuse_argument("set", pointer, "a JSON pointer, as \"/scene/camera/fov_y\"");
    edits.push_back({py::cast<std::string>(pointer), py::cast<std::string>(dumps(value)), "set"});
  }
  return edits;
}

std::shared_ptr<LiveScene> load(const py::object& path, bool allow_outside, const py::object& exposure,
                                const py::object& mesh_cache, const py::dict& set, const py::object& shadow,
                                const py::object& shadow_map_size, const py::object& threads) {
  SceneOptions options;
  options.outside = allow_outside ? Outside::allowed : Outside::refused;
  read_argument("exposure", exposure, Range{-64, 64}, options.exposure_stops);
  read_argument("threads", threads, Range{0, double(limit::threads.value)}, options.threads);
  if (!shadow.is_none()) read_argument("shadow", shadow, Range{}, options.shadow.emplace());
  if (!shadow_map_size.is_none())
    read_argument("shadow_map_size", shadow_map_size, ShadowMap::sizes, options.shadow_map_size.emplace());
  if (!mesh_cache.is_none()) options.mesh_cache = path_argument("mesh_cache", mesh_cache);
  return load_scene(path_argument("path", path), options, edits_of(set));
}

void bind_scene(py::module_& module) {
  py::class_<LiveScene, std::shared_ptr<LiveScene>> type(module, "Scene",
                                                         "What is drawn: a camera, lights, objects. Empty at first. It "
                                                         "refers to what it is made of: two objects may have one "
                                                         "mesh or one material.");
  def_keywords(type, "Scene");
  def_fields(type, "Scene");
  type.def("__repr__", [](const LiveScene& self) {
    return "<refraster.Scene of " + std::to_string(self.objects.size()) + " objects>";
  });
  type.def_property(
      "camera", [](const LiveScene& self) { return self.camera; },
      [](LiveScene& self, const py::object& given) {
        if (!py::isinstance<LiveCamera>(given)) refuse_argument("Scene.camera", given, "a Camera");
        self.camera = py::cast<std::shared_ptr<LiveCamera>>(given);
      },
      "The Camera.");
  def_light_lists(type, std::make_index_sequence<std::tuple_size_v<std::decay_t<decltype(light_lists)>>>{});
  type.def_property(
      "objects", [](const LiveScene& self) { return self.objects; },
      [](LiveScene& self, const py::iterable& given) { self.objects = py::list(given); },
      "A list of Object, drawn in this order.");
  type.def_property(
      "size", [](const LiveScene& self) { return std::pair(self.picture.width, self.picture.height); },
      [](LiveScene& self, const py::object& given) {
        std::tie(self.picture.width, self.picture.height) = size_argument("Scene.size", given);
      },
      "(width, height) in pixels, where render is not asked for another.");
  type.def_property_readonly(
      "path", [](const LiveScene& self) { return self.path; }, "Of the file that it was read from; \"\": none.");
  type.def_property_readonly(
      "notes", [](const LiveScene& self) { return self.notes; },
      "Sentences on what was read, as the program prints them.");
  type.def(
      "place", &place_scene, py::arg("size") = py::none(),
      "Places a camera with a fit, and lights that move with the camera, for images of this size (width, height), by "
      "default scene.size: then they stay there, whatever is rendered, and may be changed.");
  type.def("validate", &faults_of,
           "A sentence for everything that is wrong with the scene; empty: render draws all of it.");
}

} // namespace

void bind_scenes(py::module_& module) {
  bind_camera(module);
  bind_object(module);
  bind_scene(module);
  module.def(
      "load", &load, py::arg("path"), py::kw_only(), py::arg("allow_outside") = false, py::arg("exposure") = 0.0,
      py::arg("mesh_cache") = py::none(), py::arg("set") = py::dict(), py::arg("shadow") = py::none(),
      py::arg("shadow_map_size") = py::none(), py::arg("threads") = 0,
      "Reads a scene file, or an OBJ model, which is framed and lit as `refraster render MODEL.obj` does.\n\n"
      "allow_outside: the scene may name files outside its folder. exposure: all that shines is multiplied by "
      "2^exposure. mesh_cache: a folder for large meshes. set: values of the file to set before it is read, by JSON "
      "pointer, as {\"/scene/camera/fov_y\": 30}. shadow: \"none\", \"exact\" or \"map\" for every light that has a "
      "shadow; shadow_map_size: texels a side of every map. Raises InputError with all faults.");
}

} // namespace refraster::python
