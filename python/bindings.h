#pragma once
// What the sources of the Python module have in common. pybind11 is included here and nowhere else.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <string_view>

namespace refraster::python {

namespace py = pybind11;

// One file each; in this order: what a signature names must be there before.
void bind_errors(py::module_& module);             // errors.cpp
void bind_meshes(py::module_& module);             // scene/meshes.cpp
void bind_textures(py::module_& module);           // scene/textures.cpp
void bind_fragment_functions(py::module_& module); // scene/fragment_functions.cpp
void bind_lights(py::module_& module);             // scene/lights.cpp
void bind_scenes(py::module_& module);             // scene/scenes.cpp
void bind_frames(py::module_& module);             // frames.cpp
void bind_reports(py::module_& module);            // reports.cpp
void bind_brdf(py::module_& module);               // brdfs.cpp
void bind_bench(py::module_& module);              // benches.cpp

/// The dictionary that a report is: its documented JSON, read by Python's own json.
py::object dictionary(const std::string& json);

} // namespace refraster::python
