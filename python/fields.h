#pragma once
// Attributes of Python classes from what the library declares: once, beside the members, with range and meaning.
//
// A class has a function fields(self, use), which calls use(name, value, range, meaning) for each declared value. Its
// attributes, the keywords of its constructor, their checks, messages and docstrings follow.

#include "io/scene/scene_keys.h"
#include "python/arguments.h"

#include <cctype>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace refraster::python {

template <class Value>
inline constexpr bool is_python_value =
    std::is_same_v<Value, double> || std::is_same_v<Value, int> || std::is_same_v<Value, Double2> ||
    std::is_same_v<Value, Double3> || std::is_same_v<Value, std::string> || NamedEnum<Value>;

/// The reading of scene_keys.h that finds the values themselves: what files, shapes and materials are is another
/// class's.
template <class Use>
struct ValueKeys {
  const Use& use; ///< called with name, value, range and meaning

  template <class Value>
  void operator()(std::string_view name, Value&& value, const Range& range, std::string_view meaning, Presence) const {
    if constexpr (std::is_lvalue_reference_v<Value&&> && is_python_value<std::remove_reference_t<Value>>)
      use(name, value, range, meaning);
  }
  void optional_object(auto&&...) const {}
  void shape(auto&&...) const {}
  void normals(auto&&...) const {}
  void shadow(std::string_view name, auto& shadow, std::string_view meaning, auto&&) const {
    use(name, shadow, Range{}, meaning);
  }
  void map(std::string_view, MapText&, std::string_view, std::string_view, Double3*) const {}
  void material(auto&&...) const {}
  void materials(auto&&...) const {}
  void expect_material(auto&&...) const {}
  void parameters(auto&&...) const {}
  void check(auto&&...) const {}
  void check_light(auto&&...) const {}
};
template <class Use>
ValueKeys(const Use&) -> ValueKeys<Use>;

template <class Self>
py::object field_value(Self& self, std::string_view name) {
  py::object found = py::none();
  Self::fields(self, [&](std::string_view declared_name, auto& value, const Range&, std::string_view) {
    if (declared_name == name) found = python_value(value);
  });
  return found;
}

/// Throws ArgumentError.
template <class Self>
void set_field(Self& self, std::string_view name, py::handle given, const std::string& place) {
  Self::fields(self, [&](std::string_view declared_name, auto& value, const Range& range, std::string_view) {
    if (declared_name == name) read_argument(place, given, range, value);
  });
}

/// Sets what keywords give, through the attributes of the class, those that are no declared values included.
void set_attributes(py::handle self, const std::string& class_name, const py::kwargs& given);

/// "PointLight" of "point_light".
inline std::string class_name_of(std::string_view snake) {
  std::string name;
  bool begins = true;
  for (const char c : snake) {
    if (c != '_') name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '_';
  }
  return name;
}

/// "Phong(ka=(0.05, 0.05, 0.05), …)".
template <class Self>
std::string fields_text(Self& self, const std::string& class_name) {
  std::string text = class_name + "(";
  Self::fields(self, [&](std::string_view name, auto& value, const Range&, std::string_view) {
    text += (text.back() == '(' ? "" : ", ") + std::string(name) + "=" + std::string(py::repr(python_value(value)));
  });
  return text + ")";
}

/// What a declared value means, and what may stand there.
template <class Value>
std::string field_doc(const Value& value, const Range& range, std::string_view meaning) {
  return std::string(meaning) + "; " + expected_value(value, range);
}

/// Attributes for all declared values, which are read alone.
template <class Self, class... Options>
void def_read_fields(py::class_<Self, Options...>& type) {
  Self sample;
  Self::fields(sample, [&](std::string_view declared_name, auto& value, const Range& range, std::string_view meaning) {
    const std::string name(declared_name);
    type.def_property_readonly(
        name.c_str(), [name](Self& self) { return field_value(self, name); }, field_doc(value, range, meaning).c_str());
  });
}

/// Attributes for all declared values.
template <class Self, class... Options>
void def_fields(py::class_<Self, Options...>& type, const std::string& class_name) {
  Self sample;
  Self::fields(sample, [&](std::string_view declared_name, auto& value, const Range& range, std::string_view meaning) {
    const std::string name(declared_name), place = class_name + "." + name;
    type.def_property(
        name.c_str(), [name](Self& self) { return field_value(self, name); },
        [name, place](Self& self, const py::object& given) { set_field(self, name, given, place); },
        field_doc(value, range, meaning).c_str());
  });
}

template <class Self, class... Options>
void def_repr(py::class_<Self, Options...>& type, const std::string& class_name) {
  type.def("__repr__", [class_name](Self& self) { return fields_text(self, class_name); });
}

/// A class whose constructor takes its attributes as keywords.
template <class Self>
void def_keywords(py::class_<Self, std::shared_ptr<Self>>& type, const std::string& class_name) {
  type.def(py::init([class_name](const py::kwargs& given) {
    const auto self = std::make_shared<Self>();
    set_attributes(py::cast(self), class_name, given);
    return self;
  }));
}

} // namespace refraster::python
