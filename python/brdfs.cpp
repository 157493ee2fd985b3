// refraster.brdf: reflectance apart from scenes.

#include "brdf/read_brdf.h"

#include "brdf/comparison.h"
#include "brdf/evaluation.h"
#include "brdf/facts.h"
#include "brdf/fit/fit.h"
#include "brdf/points.h"
#include "python/arguments.h"
#include "python/work.h"

#include <optional>

namespace refraster::python {
namespace {

MerlLookup lookup_argument(const py::object& given) {
  MerlLookup lookup = MerlLookup::trilinear;
  read_argument("lookup", given, Range{}, lookup);
  return lookup;
}

/// Throws ArgumentError for a model's fault.
Brdf brdf_argument(const std::string& place, const py::object& given, MerlLookup lookup) {
  const std::string word = path_argument(place, given);
  if (means_model(word))
    for (const ModelFault& fault : read_models(word).faults)
      throw ArgumentError(fault.place.empty() ? place : fault.place, fault.found, fault.expected);
  std::optional<Brdf> brdf;
  run_watched(py::none(), [&](Watch&) { brdf = read_brdf(word, lookup); });
  return *std::move(brdf);
}

py::object info(const py::object& brdf, const py::object& lookup) {
  const Brdf given = brdf_argument("brdf", brdf, lookup_argument(lookup));
  std::string json;
  run_watched(py::none(), [&](Watch&) { json = info_json(brdf_info(given)); });
  return dictionary(json);
}

/// Rows of numbers, checked as those of a file are, under these columns.
void add_pairs(const std::string& place, const py::object& given, const std::vector<std::string>& columns,
               std::vector<DirectionPair>& pairs) {
  if (given.is_none()) return;
  const auto width = static_cast<py::ssize_t>(columns.size());
  const std::string expected = "numbers with shape (pairs, " + std::to_string(width) + "), or " +
                               std::to_string(width) + " numbers: " + columns.front() + " to " + columns.back();
  auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array) PyErr_Clear();
  if (!array || (array.ndim() != 1 && array.ndim() != 2) || array.shape(array.ndim() - 1) != width)
    refuse_argument(place, given, expected);
  NumberTable table{place, columns, {array.data(), array.data() + array.size()}, {}};
  for (py::ssize_t row = 0; row < array.size() / width; ++row) table.lines.push_back(static_cast<int>(row + 1));
  const std::vector<DirectionPair> read = pairs_of(table);
  pairs.insert(pairs.end(), read.begin(), read.end());
}

py::object eval(const py::object& brdf, const py::object& angles, const py::object& half, const py::object& directions,
                const py::object& lookup) {
  std::vector<DirectionPair> pairs;
  add_pairs("angles", angles, {"theta_in", "theta_out", "dphi"}, pairs);
  add_pairs("half", half, {"theta_h", "theta_d", "phi_d"}, pairs);
  add_pairs("directions", directions, {"in_x", "in_y", "in_z", "out_x", "out_y", "out_z"}, pairs);
  if (angles.is_none() && half.is_none() && directions.is_none())
    throw ArgumentError("eval", "nothing", "one of angles, half, directions");
  const Brdf given = brdf_argument("brdf", brdf, lookup_argument(lookup));
  std::string json;
  run_watched(py::none(), [&](Watch&) { json = evaluation_json(given, pairs); });
  return dictionary(json);
}

py::object compare(const py::object& a, const py::object& b, const py::object& max_rms,
                   const py::object& max_cosine_rms, const py::object& max_log_rms, const py::object& max_cube_root_rms,
                   const py::object& lookup) {
  BrdfLimits limits;
  const auto read = [](const char* place, const py::object& given, std::optional<double>& limit) {
    if (!given.is_none()) read_argument(place, given, Range{}, limit.emplace());
  };
  read("max_rms", max_rms, limits.max_rms);
  read("max_cosine_rms", max_cosine_rms, limits.max_cosine_rms);
  read("max_log_rms", max_log_rms, limits.max_log_rms);
  read("max_cube_root_rms", max_cube_root_rms, limits.max_cube_root_rms);
  const MerlLookup reading = lookup_argument(lookup);
  const Brdf brdf_a = brdf_argument("a", a, reading), brdf_b = brdf_argument("b", b, reading);
  std::string json;
  run_watched(py::none(), [&](Watch&) {
    json = comparison_json(BrdfComparisonReport{brdf_a, brdf_b, limits, compare_brdfs(brdf_a, brdf_b)});
  });
  return dictionary(json);
}

py::object fit(const py::object& brdf, const py::object& to, const py::object& lobes, const py::object& lookup) {
  std::vector<std::string_view> models;
  for (const FittedModel& model : fitted_models) models.push_back(model.name);
  const std::vector<std::size_t> index = words_argument("to", to, models);
  if (index.size() != 1) refuse_argument("to", to, "a single name");
  const int count = whole_number("lobes", lobes, 1, 3, "1, 2 or 3");
  const Brdf given = brdf_argument("brdf", brdf, lookup_argument(lookup));
  std::string json;
  run_watched(py::none(),
              [&](Watch&) { json = fit_json(given, fit_or_refuse(given, std::string(models[index.front()]), count)); });
  return dictionary(json);
}

} // namespace

void bind_brdf(py::module_& module) {
  py::module_ brdf = module.def_submodule(
      "brdf",
      "Reflectance apart from scenes, docs/brdf.md. A BRDF is the path of a MERL table, .binary, or the text of a "
      "model, as \"blinn_phong:kd=0.5,glossiness=32\". All give the dictionaries of docs/reports.md.");
  const py::object none = py::none();
  brdf.def("info", &info, py::arg("brdf"), py::kw_only(), py::arg("lookup") = "trilinear",
           "What is in a table, or what a model reflects. lookup: how a table is read between its samples.");
  brdf.def("eval", &eval, py::arg("brdf"), py::kw_only(), py::arg("angles") = none, py::arg("half") = none,
           py::arg("directions") = none, py::arg("lookup") = "trilinear",
           "f in 1/sr at pairs of directions. angles: (pairs, 3), theta_in, theta_out, dphi in degrees, dphi 180 in a "
           "mirror. half: (pairs, 3), theta_h, theta_d, phi_d in degrees. directions: (pairs, 6), two vectors over a "
           "surface "
           "with normal (0, 0, 1).");
  brdf.def("compare", &compare, py::arg("a"), py::arg("b"), py::kw_only(), py::arg("max_rms") = none,
           py::arg("max_cosine_rms") = none, py::arg("max_log_rms") = none, py::arg("max_cube_root_rms") = none,
           py::arg("lookup") = "trilinear",
           "How far two reflectances are apart, and where; a is the one that is right.");
  brdf.def("fit", &fit, py::arg("brdf"), py::arg("to"), py::arg("lobes") = 1, py::kw_only(),
           py::arg("lookup") = "trilinear", "Parameters of the model `to` that come nearest, with 1, 2 or 3 lobes.");
}

} // namespace refraster::python
