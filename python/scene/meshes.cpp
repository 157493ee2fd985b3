// refraster.Mesh, and what makes meshes.

#include "python/scene/meshes.h"

#include <refraster/files.h>

#include "io/file/limits.h"
#include "io/scene/shape_mesh.h"
#include "math/vec.h"
#include "python/arguments.h"
#include "python/arrays.h"
#include "python/work.h"

#include <cmath>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

namespace refraster::python {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

void check_count(const std::string& place, std::uint64_t count, const Limit& limit) {
  if (count > limit.value) throw ArgumentError(place, found_of(limit, count), at_most(limit));
}

/// Rows of a vertex attribute: one copy of float32 in C order, two of all else.
template <class Value>
void read_rows(const std::string& place, py::handle given, std::vector<Value>& rows) {
  static_assert(sizeof(Value) == sizeof(float) * static_cast<std::size_t>(Value::length()));
  const auto array = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != 2 || array.shape(1) != Value::length())
    refuse_argument(place, given, "an array of numbers with shape (vertices, " + std::to_string(Value::length()) + ")");
  check_count(place, static_cast<std::uint64_t>(array.shape(0)), limit::vertices);
  rows.resize(static_cast<std::size_t>(array.shape(0)));
  if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), array.data(), rows.size() * sizeof(Value));
}

/// Throws for the first index that names no vertex.
template <class Index>
void check_indices(const Index* indices, std::size_t triangles, std::size_t vertices) {
  for (std::size_t i = 0; i < 3 * triangles; ++i)
    if (indices[i] < 0 || static_cast<std::uint64_t>(indices[i]) >= vertices)
      throw ArgumentError("triangles[" + std::to_string(i / 3) + "]", "index " + std::to_string(indices[i]),
                          "one of the " + std::to_string(vertices) + " vertices, from 0");
}

/// One copy of uint32 in C order, two of other whole numbers.
void read_triangles(py::handle given, std::size_t vertices, std::vector<Triangle>& triangles) {
  const py::array array = py::array::ensure(given);
  if (!array) PyErr_Clear();
  const char kind = array ? array.dtype().kind() : '?';
  if (!array || array.ndim() != 2 || array.shape(1) != 3 || (kind != 'i' && kind != 'u'))
    refuse_argument("triangles", given, "an array of whole numbers with shape (triangles, 3)");
  const auto count = static_cast<std::size_t>(array.shape(0));
  check_count("triangles", count, limit::triangles);
  triangles.resize(count);
  if (count == 0) return;
  if (kind == 'u' && array.itemsize() == sizeof(std::uint32_t)) {
    const auto same = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>::ensure(array);
    check_indices(same.data(), count, vertices);
    std::memcpy(triangles.data(), same.data(), count * sizeof(Triangle));
    return;
  }
  const auto wide = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  check_indices(wide.data(), count, vertices);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) triangles[i][k] = static_cast<std::uint32_t>(wide.data()[3 * i + k]);
}

/// Of each vertex the mean of the faces around it, weighted by area: their cross products added up. 0 where they
/// cancel, or there is none.
std::vector<Float3> normals_of_faces(const Mesh& mesh) {
  std::vector<Double3> sums(mesh.positions.size(), Double3(0));
  for (const Triangle& triangle : mesh.triangles) {
    const auto at = [&](std::size_t k) { return Double3(mesh.positions[triangle[k]]); };
    const Double3 twice_area = cross(at(1) - at(0), at(2) - at(0));
    for (const std::uint32_t vertex : triangle) sums[vertex] += twice_area;
  }
  std::vector<Float3> normals;
  normals.reserve(sums.size());
  for (const Double3& sum : sums) {
    const double length = std::sqrt(dot(sum, sum));
    normals.emplace_back(length > 0 ? sum / length : Double3(0));
  }
  return normals;
}

/// Names of the attributes, of which the first two are arguments of their own.
std::vector<std::string_view> attribute_names() {
  std::vector<std::string_view> names;
  for_each_vertex_attribute([&](const auto& attribute) { names.push_back(attribute.name); });
  return names;
}

std::shared_ptr<LiveMesh> mesh_of(const py::object& positions, const py::object& triangles, py::kwargs others) {
  const auto mesh = std::make_shared<Mesh>();
  const std::vector<std::string_view> names = attribute_names();
  for (const auto& [key, value] : others)
    if (const auto name = py::cast<std::string>(key); std::find(names.begin(), names.end(), name) == names.end())
      refuse_keyword("Mesh", name, names);
  others["positions"] = positions;
  for_each_vertex_attribute([&]<class Value>(const VertexAttribute<Value>& attribute) {
    const py::str name(attribute.name.data(), attribute.name.size());
    const std::string place(attribute.name);
    std::vector<Value>& rows = mesh.get()->*attribute.values;
    if (others.contains(name) && !others[name].is_none()) read_rows(place, others[name], rows);
    const std::size_t vertices = mesh->positions.size();
    const bool all_or_none = attribute.need == Need::required;
    if (rows.size() > vertices || (all_or_none && !rows.empty() && rows.size() != vertices))
      throw ArgumentError(place, std::to_string(rows.size()) + " rows",
                          (all_or_none ? "" : "at most ") + std::to_string(vertices) + ", as many as positions");
  });
  read_triangles(triangles, mesh->positions.size(), mesh->triangles);
  if (mesh->normals.empty()) mesh->normals = normals_of_faces(*mesh);
  return std::make_shared<LiveMesh>(mesh);
}

std::shared_ptr<LiveMesh> allocated_mesh(const py::object& vertices, const py::object& triangles,
                                         const py::object& attributes) {
  const auto mesh = std::make_shared<Mesh>();
  const auto counted = [](const std::string& place, const py::object& given, const Limit& limit) {
    return static_cast<std::size_t>(whole_number(place, given, 0, static_cast<int>(limit.value),
                                                 "a whole number from 0 to " + std::to_string(limit.value)));
  };
  const std::vector<std::string_view> names = attribute_names();
  const std::vector<std::size_t> wanted = words_argument("attributes", attributes, names);
  const std::size_t count = counted("vertices", vertices, limit::vertices);
  std::size_t number = 0;
  for_each_vertex_attribute([&](const auto& attribute) {
    const bool is_wanted = std::find(wanted.begin(), wanted.end(), number++) != wanted.end();
    if (attribute.need == Need::required || is_wanted) (mesh.get()->*attribute.values).resize(count);
  });
  mesh->triangles.resize(counted("triangles", triangles, limit::triangles));
  return std::make_shared<LiveMesh>(mesh);
}

py::list runs_of(const LiveMesh& self) {
  py::list runs;
  for (const TriangleRun& run : self.mesh->material_runs)
    runs.append(py::make_tuple(run.first_triangle,
                               run.material == no_material ? py::object(py::none()) : py::int_(run.material)));
  return runs;
}

void set_runs(LiveMesh& self, const py::object& given) {
  const std::string place = "Mesh.material_runs", expected = "pairs (first triangle, number of the material or None), "
                                                             "first triangles in rising order";
  if (!self.own) throw ArgumentError(place, "a mesh that was read from a file", "one that was made in Python");
  std::vector<TriangleRun> runs;
  if (!py::isinstance<py::sequence>(given)) refuse_argument(place, given, expected);
  const auto most = static_cast<int>(limit::triangles.value);
  for (const py::handle item : given) {
    if (!py::isinstance<py::sequence>(item) || py::len(item) != 2) refuse_argument(place, item, expected);
    const auto pair = py::reinterpret_borrow<py::sequence>(item);
    const int first = whole_number(place, pair[0], 0, most, expected);
    const std::uint32_t material = py::object(pair[1]).is_none()
                                       ? no_material
                                       : static_cast<std::uint32_t>(whole_number(place, pair[1], 0, most, expected));
    if (!runs.empty() && static_cast<std::uint32_t>(first) <= runs.back().first_triangle)
      refuse_argument(place, item, expected);
    runs.push_back({static_cast<std::uint32_t>(first), material});
  }
  self.own->material_runs = std::move(runs);
}

Access access_to(const LiveMesh& self) {
  return self.own ? Access::write : Access::read;
}

void def_arrays(py::class_<LiveMesh, std::shared_ptr<LiveMesh>>& type) {
  for_each_vertex_attribute([&]<class Value>(const VertexAttribute<Value>& attribute) {
    const std::string doc = "float32, shape (vertices, " + std::to_string(Value::length()) +
                            (attribute.need == Need::required ? ")" : ") or fewer vertices, the first ones") +
                            ": the mesh's own memory.";
    type.def_property_readonly(
        std::string(attribute.name).c_str(),
        [attribute](const py::object& self) {
          const auto& live = py::cast<const LiveMesh&>(self);
          const std::vector<Value>& rows = live.mesh.get()->*attribute.values;
          return array_view({static_cast<py::ssize_t>(rows.size()), Value::length()},
                            reinterpret_cast<const float*>(rows.data()), self, access_to(live));
        },
        doc.c_str());
  });
  type.def_property_readonly(
      "triangles",
      [](const py::object& self) {
        const auto& live = py::cast<const LiveMesh&>(self);
        const std::vector<Triangle>& rows = live.mesh->triangles;
        return array_view({static_cast<py::ssize_t>(rows.size()), 3},
                          reinterpret_cast<const std::uint32_t*>(rows.data()), self, access_to(live));
      },
      "uint32, shape (triangles, 3): indices of vertices, from 0; counter-clockwise seen from outside. The mesh's own "
      "memory.");
}

template <class Shape_>
void def_shape(py::module_& module) {
  const std::string name(Shape_::name);
  std::string doc = "A mesh: " + std::string(Shape_::meaning) + ".";
  Shape_ sample;
  Shape_::fields(sample,
                 [&](std::string_view key, auto& value, const Range& range, std::string_view meaning, Presence) {
                   doc += "\n\n" + std::string(key) + ": " + std::string(meaning) + "; " +
                          expected_value(value, range) + ", by default " + std::string(py::str(python_value(value)));
                 });
  module.def(
      name.c_str(),
      [name](const py::kwargs& given) {
        Shape_ shape;
        std::vector<std::string_view> known;
        Shape_::fields(shape, [&](std::string_view key, auto& value, const Range& range, std::string_view, Presence) {
          known.push_back(key);
          if (const py::str word(key.data(), key.size()); given.contains(word))
            read_argument(name + "." + std::string(key), given[word], range, value);
        });
        for (const auto& [key, value] : given)
          if (const auto word = py::cast<std::string>(key); std::find(known.begin(), known.end(), word) == known.end())
            refuse_keyword(name, word, known);
        return std::make_shared<LiveMesh>(make_mesh(Shape(shape)));
      },
      doc.c_str());
}

std::shared_ptr<LiveMesh> read_mesh(const py::object& path, const py::object& normals, const py::object& colours,
                                    int threads) {
  ObjOptions options;
  if (py::isinstance<py::str>(normals)) {
    read_argument("normals", normals, Range{}, options.normals.from);
  } else {
    options.normals.from = NormalsFrom::crease;
    const std::string expected =
        expected_value(options.normals.from, Range{}) + ", or an angle in degrees from 0 to 180";
    try {
      read_argument("normals", normals, Range{0, 180}, options.normals.crease_degrees);
    } catch (const ArgumentError&) {
      refuse_argument("normals", normals, expected);
    }
  }
  read_argument("colours", colours, Range{}, options.colours);
  options.threads = threads;
  const std::string file = path_argument("path", path);
  std::shared_ptr<const Mesh> mesh;
  run_watched(py::none(), [&](Watch&) { mesh = std::make_shared<Mesh>(read_obj(file, options)); });
  return std::make_shared<LiveMesh>(mesh);
}

template <std::size_t... I>
void def_shapes(py::module_& module, std::index_sequence<I...>) {
  (def_shape<std::variant_alternative_t<I, Shape>>(module), ...);
}

} // namespace

void bind_meshes(py::module_& module) {
  py::class_<LiveMesh, std::shared_ptr<LiveMesh>> type(
      module, "Mesh",
      "Triangles in object space, counter-clockwise seen from outside.\n\nThe arrays are copied once where they are "
      "float32 and uint32 in C order, and converted before where they are not; Mesh.allocate() gives a mesh whose own "
      "memory can be filled instead. What is left out of normals follows from the faces: of each vertex their mean, "
      "weighted by area.");
  type.def(
      py::init(&mesh_of), py::arg("positions"), py::arg("triangles"),
      "positions: shape (vertices, 3). triangles: whole numbers, shape (triangles, 3). Keywords: normals (vertices, "
      "3), uvs (vertices, 2), colours (vertices, 3), tangents (vertices, 4).");
  type.def_static(
      "allocate", &allocated_mesh, py::arg("vertices"), py::arg("triangles"), py::arg("attributes") = py::tuple(),
      "A mesh of zeros, to be filled through its arrays: nothing is copied. attributes: which of the optional "
      "ones it has, as \"uvs\". Not to be written to while it is rendered.");
  def_arrays(type);
  type.def_property("material_runs", &runs_of, &set_runs,
                    "Pairs (first triangle, number of the material): triangles from this one on have that of the "
                    "object's `materials`, or with None its `material`.");
  type.def(
      "with_tangents",
      [](const LiveMesh& self) {
        const auto mesh = std::make_shared<Mesh>(*self.mesh);
        add_tangents(*mesh);
        return std::make_shared<LiveMesh>(mesh);
      },
      "A copy with the tangents that normal maps and bump maps need (MikkTSpace), of which vertices may be split.");
  type.def(
      "save",
      [](const LiveMesh& self, const py::object& path) {
        const std::string file = path_argument("path", path);
        run_watched(py::none(), [&](Watch&) { write_obj(file, *self.mesh); });
      },
      py::arg("path"), "Writes an OBJ file.");
  type.def("__repr__", [](const LiveMesh& self) {
    return "<refraster.Mesh of " + std::to_string(self.mesh->positions.size()) + " vertices, " +
           std::to_string(self.mesh->triangles.size()) + " triangles>";
  });
  module.def(
      "read_mesh", &read_mesh, py::arg("path"), py::arg("normals") = "file", py::arg("colours") = "linear",
      py::arg("threads") = 0,
      "The triangles of an OBJ file, as render draws them. normals: \"file\", \"smooth\", \"flat\", or the angle "
      "in degrees up to which edges are smooth. colours: what those of the vertices are taken as, \"linear\", "
      "\"srgb\" or \"ignored\".");
  def_shapes(module, std::make_index_sequence<std::variant_size_v<Shape>>{});
}

} // namespace refraster::python
