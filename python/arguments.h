#pragma once
// Values between Python and the declared members of the library: <refraster/fields.h>, io/scene/scene_keys.h.

#include <refraster/fields.h>
#include <refraster/scene.h>
#include <refraster/vector.h>

#include "io/scene/value_kinds.h"
#include "python/bindings.h"
#include "python/errors.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// What a light's shadow may be set to: scene/lights.cpp.
std::string expected_value(const CastShadow&, const Range&);

} // namespace refraster

namespace refraster::python {

// Each reads an argument into `value`, or throws ArgumentError with what the documentation of scene files expects
// there.
void read_argument(const std::string& place, py::handle given, const Range& range, double& value);
void read_argument(const std::string& place, py::handle given, const Range& range, int& value);
void read_argument(const std::string& place, py::handle given, const Range& range, Double2& value);
void read_argument(const std::string& place, py::handle given, const Range& range, Double3& value);
void read_argument(const std::string& place, py::handle given, const Range& range, std::string& value);
void read_argument(const std::string& place, py::handle given, const Range& range, CastShadow& value);

/// A word, or of an enum of true and false a bool.
template <NamedEnum Enum>
void read_argument(const std::string& place, py::handle given, const Range& range, Enum& value) {
  std::string word;
  if (py::isinstance<py::bool_>(given)) word = given.ptr() == Py_True ? "true" : "false";
  else if (py::isinstance<py::str>(given)) word = py::cast<std::string>(given);
  const std::optional<Enum> named = value_named<Enum>(word);
  if (!named) refuse_argument(place, given, expected_value(value, range));
  value = *named;
}

/// The same where None leaves the value as it is.
template <class Value>
void read_optional(const std::string& place, py::handle given, const Range& range, Value& value) {
  if (!given.is_none()) read_argument(place, given, range, value);
}

/// Vectors are tuples, and a ShadowMap is not to be changed: a member of one cannot be set by itself, which would
/// change a copy.
py::object python_value(double value);
py::object python_value(int value);
py::object python_value(const Double2& value);
py::object python_value(const Double3& value);
py::object python_value(const std::string& value);
py::object python_value(const CastShadow& value);

template <NamedEnum Enum>
py::object python_value(Enum value) {
  const std::string_view word = name_of(value);
  if (word == "true" || word == "false") return py::bool_(word == "true");
  return py::str(word.data(), word.size());
}

/// Whole numbers in a range; `expected` is what the message says.
int whole_number(const std::string& place, py::handle given, int least, int most, const std::string& expected);

/// (width, height) of a frame.
std::pair<int, int> size_argument(const std::string& place, py::handle given);

/// A sequence of words or a single one, each of the list, as indices.
std::vector<std::size_t> words_argument(const std::string& place, py::handle given,
                                        const std::vector<std::string_view>& words);

/// Throws ArgumentError for a keyword that is none of these.
[[noreturn]] void refuse_keyword(const std::string& place, const std::string& keyword,
                                 const std::vector<std::string_view>& known);

/// A path as Python has them: a string, bytes or os.PathLike.
std::string path_argument(const std::string& place, py::handle given);

} // namespace refraster::python
