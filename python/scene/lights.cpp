// refraster.ShadowMap, and refraster.PointLight and so on

#include "python/scene/lights.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

std::string expected_value(const CastShadow& value, const Range& range) {
  return expected_value(value.kind, range) + " or a ShadowMap";
}

} // namespace refraster

namespace refraster::python {

void read_argument(const std::string& place, py::handle given, const Range& range, CastShadow& value) {
  if (py::isinstance<LiveShadowMap>(given)) {
    value = py::cast<const LiveShadowMap&>(given).map;
    return;
  }
  const std::optional<Shadow> named =
      py::isinstance<py::str>(given) ? value_named<Shadow>(py::cast<std::string>(given)) : std::nullopt;
  if (!named) refuse_argument(place, given, expected_value(value, range));
  value = *named;
}

py::object python_value(const CastShadow& value) {
  return value == Shadow::map ? py::cast(LiveShadowMap{value.map}) : python_value(value.kind);
}

namespace {

/// Its attributes are read, and not set: a light gives out a copy.
void bind_shadow_map(py::module_& module) {
  py::class_<LiveShadowMap, std::shared_ptr<LiveShadowMap>> type(
      module, "ShadowMap",
      "A light's shadow by an image of depths that it sees, as GPUs make it: docs/shadow-maps.md. Not to be changed: a "
      "light is given another.");
  type.def(py::init([](const py::kwargs& given) {
    LiveShadowMap self;
    std::vector<std::string_view> names;
    LiveShadowMap::fields(self, [&](std::string_view name, auto&&...) { names.push_back(name); });
    for (const auto& [key, value] : given) {
      const auto name = py::cast<std::string>(key);
      if (std::find(names.begin(), names.end(), name) == names.end()) refuse_keyword("ShadowMap", name, names);
      set_field(self, name, value, "ShadowMap." + name);
    }
    return self;
  }));
  def_read_fields(type);
  def_repr(type, "ShadowMap");
  type.def("__eq__", [](const LiveShadowMap& self, const py::object& other) {
    return py::isinstance<LiveShadowMap>(other) && self.map == py::cast<const LiveShadowMap&>(other).map;
  });
}

template <class Light>
void bind_light(py::module_& module) {
  std::string name = class_name_of(Light::names.key);
  name.pop_back(); // of the list's name, the s
  py::class_<LiveLight<Light>, std::shared_ptr<LiveLight<Light>>> type(
      module, name.c_str(), ("One of a scene's " + std::string(Light::names.words) + ".").c_str());
  def_keywords(type, name);
  def_fields(type, name);
  def_repr(type, name);
}

} // namespace

void bind_lights(py::module_& module) {
  bind_shadow_map(module);
  Scene sample;
  for_each_light_list(sample, [&]<class Light>(std::vector<Light>&) { bind_light<Light>(module); });
}

} // namespace refraster::python
