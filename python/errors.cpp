#include "python/errors.h"

#include <refraster/notes.h>

#include "io/file/text.h"

#include <exception>
#include <new>

namespace refraster::python {
namespace {

/// The exceptions, as Python has them. They live as long as the process.
struct ErrorTypes {
  py::handle base, input, output, usage;
};
ErrorTypes& error_types() {
  static ErrorTypes types;
  return types;
}

py::handle new_error(py::module_& module, const char* name, const py::tuple& bases, const char* doc) {
  const std::string full = std::string("refraster.") + name;
  PyObject* const type = PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), nullptr);
  if (!type) throw py::error_already_set();
  module.add_object(name, py::handle(type));
  return type;
}

py::dict fault_of(const InputFault& fault) {
  py::dict dict;
  dict["file"] = as_utf8(fault.file);
  dict["line"] = fault.line;
  dict["column"] = fault.column;
  dict["path"] = as_utf8(fault.path);
  dict["found"] = as_utf8(fault.found);
  dict["expected"] = as_utf8(fault.expected);
  dict["text"] = as_utf8(fault.text());
  return dict;
}

void raise(const InputError& error) {
  const py::object instance = py::reinterpret_borrow<py::object>(error_types().input)(as_utf8(error.what()));
  py::list faults;
  for (const InputFault& fault : error.faults()) faults.append(fault_of(fault));
  instance.attr("faults") = faults;
  instance.attr("unlisted") = error.unlisted();
  instance.attr("advice") = as_utf8(error.advice());
  PyErr_SetObject(error_types().input.ptr(), instance.ptr());
}

void translate(std::exception_ptr thrown) {
  const auto raise_text = [](py::handle type, const std::exception& error) {
    PyErr_SetString(type.ptr(), as_utf8(error.what()).c_str());
  };
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise(error);
  } catch (const OutputError& error) {
    raise_text(error_types().output, error);
  } catch (const ArgumentError& error) {
    raise_text(error_types().usage, error);
  } catch (
      const std::invalid_argument& error) { // of the library: options out of range, a scene that validate() refuses
    raise_text(error_types().usage, error);
  } catch (const std::bad_alloc& error) {
    raise_text(PyExc_MemoryError, error);
  }
}

} // namespace

std::string found_text(py::handle value) {
  if (py::isinstance<py::str>(value)) return in_quotes(py::cast<std::string>(value));
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    return "an array of " + std::string(py::str(array.dtype())) + " with shape " +
           std::string(py::str(array.attr("shape")));
  }
  constexpr std::size_t most = 60;
  std::string text = py::repr(value);
  if (text.size() > most) text = text.substr(0, most) + "...";
  return one_line(as_utf8(text));
}

void refuse_argument(const std::string& place, py::handle value, const std::string& expected) {
  throw ArgumentError(place, found_text(value), expected);
}

py::object dictionary(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

void bind_errors(py::module_& module) {
  const auto builtin = [](PyObject* type) { return py::reinterpret_borrow<py::object>(type); };
  ErrorTypes& types = error_types();
  types.base = new_error(module, "Error", py::make_tuple(builtin(PyExc_Exception)), "What refraster reports.");
  const py::object base = py::reinterpret_borrow<py::object>(types.base);
  types.input = new_error(module, "InputError", py::make_tuple(base, builtin(PyExc_ValueError)),
                          "A file that cannot be read, or is not what it should be. The text has a line for each "
                          "fault, as the program prints it.\n\n"
                          "faults: a dictionary for each: file, line and column (from 1; 0: not known), path (a JSON "
                          "pointer), found, expected, text.\n"
                          "unlisted: how many faults the last one stands for; 0 if it is one itself.\n"
                          "advice: what to do about it; mostly empty.");
  types.output =
      new_error(module, "OutputError", py::make_tuple(base, builtin(PyExc_OSError)), "A file that cannot be written.");
  types.usage = new_error(module, "UsageError", py::make_tuple(base, builtin(PyExc_ValueError)),
                          "An argument that is not what it should be, or a scene that cannot be rendered: what was "
                          "found, and what was expected.");
  py::register_local_exception_translator(translate);
}

} // namespace refraster::python
