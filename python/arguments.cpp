#include "python/arguments.h"

#include "io/file/limits.h"
#include "io/file/nearest.h"

#include <algorithm>

namespace refraster::python {
namespace {

/// A number of Python or NumPy; nothing of anything else, a text that looks like one included.
std::optional<double> number_of(py::handle given) {
  if (py::isinstance<py::str>(given) || py::isinstance<py::bytes>(given)) return std::nullopt;
  const double number = PyFloat_AsDouble(given.ptr());
  if (PyErr_Occurred()) {
    PyErr_Clear();
    return std::nullopt;
  }
  return number;
}

/// A whole number of Python or NumPy.
std::optional<long long> whole_of(py::handle given) {
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
  if (!index) {
    PyErr_Clear();
    return std::nullopt;
  }
  const long long number = PyLong_AsLongLong(index.ptr());
  if (PyErr_Occurred()) {
    PyErr_Clear();
    return std::nullopt;
  }
  return number;
}

/// The items of a list, a tuple, an array; nothing of a text, and of what is no sequence.
std::optional<std::vector<py::object>> items_of(py::handle given) {
  if (py::isinstance<py::str>(given) || py::isinstance<py::bytes>(given) || !PySequence_Check(given.ptr()))
    return std::nullopt;
  std::vector<py::object> items;
  for (const py::handle item : py::reinterpret_borrow<py::object>(given))
    items.push_back(py::reinterpret_borrow<py::object>(item));
  return items;
}

template <class Vector>
void read_vector(const std::string& place, py::handle given, const Range& range, Vector& value) {
  const auto refuse = [&] { refuse_argument(place, given, expected_value(value, range)); };
  const auto items = items_of(given);
  if (!items || items->size() != static_cast<std::size_t>(Vector::length())) return refuse();
  Vector read;
  for (int i = 0; i < Vector::length(); ++i) {
    const std::optional<double> number = number_of((*items)[static_cast<std::size_t>(i)]);
    if (!number || !range.contains(*number)) return refuse();
    read[i] = *number;
  }
  if (range.zero == Zero::excluded && read == Vector(0)) return refuse();
  value = read;
}

} // namespace

void read_argument(const std::string& place, py::handle given, const Range& range, double& value) {
  const std::optional<double> number = number_of(given);
  if (!number || !range.contains(*number)) refuse_argument(place, given, expected_value(value, range));
  value = *number;
}

void read_argument(const std::string& place, py::handle given, const Range& range, int& value) {
  const std::optional<long long> number = whole_of(given);
  const bool fits = number && *number == static_cast<long long>(static_cast<int>(*number));
  if (!fits || !range.contains(static_cast<double>(*number)))
    refuse_argument(place, given, expected_value(value, range));
  value = static_cast<int>(*number);
}

void read_argument(const std::string& place, py::handle given, const Range& range, Double2& value) {
  read_vector(place, given, range, value);
}

void read_argument(const std::string& place, py::handle given, const Range& range, Double3& value) {
  read_vector(place, given, range, value);
}

void read_argument(const std::string& place, py::handle given, const Range& range, std::string& value) {
  if (!py::isinstance<py::str>(given)) refuse_argument(place, given, expected_value(value, range));
  value = py::cast<std::string>(given);
}

py::object python_value(double value) {
  return py::float_(value);
}
py::object python_value(int value) {
  return py::int_(value);
}
py::object python_value(const Double2& value) {
  return py::make_tuple(value.x, value.y);
}
py::object python_value(const Double3& value) {
  return py::make_tuple(value.x, value.y, value.z);
}
py::object python_value(const std::string& value) {
  return py::str(value);
}

int whole_number(const std::string& place, py::handle given, int least, int most, const std::string& expected) {
  const std::optional<long long> number = whole_of(given);
  if (!number || *number < least || *number > most) refuse_argument(place, given, expected);
  return static_cast<int>(*number);
}

std::pair<int, int> size_argument(const std::string& place, py::handle given) {
  constexpr int most = static_cast<int>(limit::frame_side.value);
  const std::string expected = "(width, height), whole numbers from 1 to " + std::to_string(most);
  const auto items = items_of(given);
  if (!items || items->size() != 2) refuse_argument(place, given, expected);
  std::pair<int, int> size;
  for (const auto& [item, side] : {std::pair(0, &size.first), std::pair(1, &size.second)}) {
    const std::optional<long long> number = whole_of((*items)[static_cast<std::size_t>(item)]);
    if (!number || *number < 1 || *number > most) refuse_argument(place, given, expected);
    *side = static_cast<int>(*number);
  }
  return size;
}

std::vector<std::size_t> words_argument(const std::string& place, py::handle given,
                                        const std::vector<std::string_view>& words) {
  std::vector<py::object> items = {py::reinterpret_borrow<py::object>(given)};
  if (auto several = items_of(given)) items = *std::move(several);
  std::vector<std::size_t> found;
  for (const py::object& item : items) {
    const std::string word = py::isinstance<py::str>(item) ? py::cast<std::string>(item) : "";
    const auto listed = std::find(words.begin(), words.end(), word);
    if (listed == words.end()) refuse_argument(place, item, one_of(words, word));
    const auto index = static_cast<std::size_t>(listed - words.begin());
    if (std::find(found.begin(), found.end(), index) == found.end()) found.push_back(index);
  }
  return found;
}

void refuse_keyword(const std::string& place, const std::string& keyword, const std::vector<std::string_view>& known) {
  throw ArgumentError(place, "the keyword \"" + keyword + '"', known.empty() ? "none" : one_of(known, keyword));
}

std::string path_argument(const std::string& place, py::handle given) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(given.ptr(), &bytes) == 0) {
    PyErr_Clear();
    refuse_argument(place, given, "the path of a file");
  }
  return py::reinterpret_steal<py::bytes>(bytes);
}

} // namespace refraster::python
