#include "python/fields.h"

#include <algorithm>

namespace refraster::python {

void set_attributes(py::handle self, const std::string& class_name, const py::kwargs& given) {
  std::vector<std::string> names;
  const py::dict members = py::type::of(self).attr("__dict__").attr("copy")();
  for (const auto& [name, member] : members)
    if (py::isinstance(member, py::handle(reinterpret_cast<PyObject*>(&PyProperty_Type))) &&
        !member.attr("fset").is_none())
      names.push_back(py::cast<std::string>(name));
  for (const auto& [key, value] : given) {
    const auto name = py::cast<std::string>(key);
    if (std::find(names.begin(), names.end(), name) == names.end())
      refuse_keyword(class_name, name, {names.begin(), names.end()});
    py::setattr(self, key, value);
  }
}

} // namespace refraster::python
