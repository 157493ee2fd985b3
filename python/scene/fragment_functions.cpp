// refraster.Phong and the other fragment functions, refraster.Material

#include <refraster/files.h>

#include "python/arrays.h"
#include "python/scene/materials.h"
#include "python/work.h"

#include <algorithm>
#include <cmath>

namespace refraster::python {
namespace {

constexpr py::ssize_t table_shape[] = {MerlTable::theta_h_bins, MerlTable::theta_d_bins, MerlTable::phi_d_bins, 3};

std::shared_ptr<const MerlTable> table_argument(const std::string& place, const py::object& given) {
  if (!py::isinstance<py::array>(given)) {
    const std::string path = path_argument(place, given);
    std::shared_ptr<const MerlTable> table;
    run_watched(py::none(), [&](Watch&) { table = read_merl(path); });
    return table;
  }
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array || array.ndim() != 4 || !std::equal(std::begin(table_shape), std::end(table_shape), array.shape()))
    refuse_argument(place, given, "the path of a MERL table, or an array with shape (90, 90, 180, 3)");
  if (!std::all_of(array.data(), array.data() + array.size(), [](double f) { return std::isfinite(f); }))
    throw ArgumentError(place, "a value that is not finite", "finite values in 1/sr, negative where none was measured");
  return std::make_shared<MerlTable>(PaddedVector<double>(array.data(), array.data() + array.size()));
}

void def_table(py::class_<Merl, std::shared_ptr<Merl>>& type) {
  type.def_property(
      "table",
      [](const py::object& self) -> py::object {
        const auto& table = py::cast<const Merl&>(self).table;
        if (!table) return py::none();
        // The table lives as long as somebody holds it, whatever the function's table becomes.
        const py::capsule owner(new std::shared_ptr<const MerlTable>(table),
                                [](void* held) { delete static_cast<std::shared_ptr<const MerlTable>*>(held); });
        return array_view({std::begin(table_shape), std::end(table_shape)}, table->values<double>(), owner,
                          Access::read);
      },
      [](Merl& self, const py::object& given) { self.table = table_argument("Merl.table", given); },
      "f in 1/sr: float64, shape (90, 90, 180, 3) of theta_h, theta_d, phi_d and r g b; the table's own memory, not to "
      "be "
      "written to. Set by the path of a .binary file, or by such an array, which is copied. Must be there to render.");
}

template <class Function>
void def_function(py::module_& module, py::dict& functions) {
  const std::string name = class_name_of(Function::name);
  const std::string doc = "The fragment function \"" + std::string(Function::name) + "\" with its parameters.";
  py::class_<Function, std::shared_ptr<Function>> type(module, name.c_str(), doc.c_str());
  def_keywords(type, name);
  def_fields(type, name);
  def_repr(type, name);
  type.attr("name") = std::string(Function::name);
  if constexpr (std::is_same_v<Function, Merl>) def_table(type);
  functions[py::str(Function::name.data(), Function::name.size())] = type;
}

bool is_function(py::handle given) {
  bool is = false;
  for_each_fragment_function(
      [&]<class Function>(Function, std::size_t) { is = is || py::isinstance<Function>(given); });
  return is;
}

void set_function(LiveMaterial& self, const py::object& given) {
  if (!is_function(given)) refuse_argument("Material.function", given, "a fragment function, as refraster.Phong()");
  self.function = given;
}

void def_slots(py::class_<LiveMaterial, std::shared_ptr<LiveMaterial>>& type) {
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    const TextureSlot& slot = texture_slots[i];
    const std::string place = "Material." + std::string(slot.key);
    const std::string doc = "TextureMap or None; set also by a Texture. Key `" + std::string(slot.key) +
                            "` of a scene file: " + std::string(slot.meaning);
    type.def_property(
        std::string(slot.key).c_str(), [i](const LiveMaterial& self) { return self.maps[i]; },
        [i, place](LiveMaterial& self, const py::object& given) { self.maps[i] = map_argument(place, given); },
        doc.c_str());
  }
}

} // namespace

py::object live_function(const FragmentFunction& function) {
  return std::visit([](const auto& one) { return py::cast(std::make_shared<std::decay_t<decltype(one)>>(one)); },
                    function);
}

Material LiveMaterial::material(const std::string& place) const {
  Material made = text.object.material;
  bool is_known = false;
  for_each_fragment_function([&]<class Function>(Function, std::size_t) {
    if (!function || !py::isinstance<Function>(function)) return;
    made.fragment_function = py::cast<const Function&>(function);
    is_known = true;
  });
  if (!is_known) throw ArgumentError(place + "/function", "none", "a fragment function, as refraster.Phong()");
  if (const auto* const merl = std::get_if<Merl>(&made.fragment_function); merl && !merl->table)
    throw ArgumentError(place + "/function/table", "none", "a measured table");
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    TextureMap& map = made.*texture_slots[i].map;
    map = {};
    if (!maps[i]) continue;
    map = maps[i]->text.map;
    map.texture = maps[i]->texture->for_filter(map.filter);
  }
  return made;
}

void bind_fragment_functions(py::module_& module) {
  py::dict functions;
  for_each_fragment_function([&]<class Function>(Function, std::size_t) { def_function<Function>(module, functions); });
  module.attr("fragment_functions") = functions;

  py::class_<LiveMaterial, std::shared_ptr<LiveMaterial>> type(
      module, "Material",
      "What a surface is like: a fragment function, textures, and what goes beside them. Objects may share one.");
  type.def(py::init([](const py::object& function, const py::kwargs& given) {
             auto self = std::make_shared<LiveMaterial>();
             set_function(*self, function.is_none() ? live_function(BlinnPhong{}) : function);
             set_attributes(py::cast(self), "Material", given);
             return self;
           }),
           py::arg("function") = py::none());
  type.def_property(
      "function", [](const LiveMaterial& self) { return self.function; }, &set_function,
      "The fragment function, as refraster.Phong(); by default a BlinnPhong().");
  type.def_property(
      "name", [](const LiveMaterial& self) { return self.text.object.material.name; },
      [](LiveMaterial& self, const py::object& given) {
        read_argument("Material.name", given, Range{}, self.text.object.material.name);
      },
      "For reports.");
  def_fields(type, "Material");
  def_repr(type, "Material");
  def_slots(type);
}

} // namespace refraster::python
