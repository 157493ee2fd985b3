#include "brdf/points.h"

#include <refraster/notes.h>

#include "io/file/fault_list.h"
#include "io/file/number_text.h"
#include "io/file/text.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

namespace refraster {
namespace {

bool is_polar_angle(double degrees) {
  return 0 <= degrees && degrees <= 90;
}

std::optional<DirectionPair> of_in_out(std::span<const double> a) {
  if (!is_polar_angle(a[0]) || !is_polar_angle(a[1]) || !std::isfinite(a[2])) return std::nullopt;
  return directions_of(InOutAngles{a[0], a[1], a[2]});
}

std::optional<DirectionPair> of_half_difference(std::span<const double> a) {
  if (!is_polar_angle(a[0]) || !is_polar_angle(a[1]) || !std::isfinite(a[2])) return std::nullopt;
  return directions_of(HalfDifferenceAngles{a[0], a[1], a[2]});
}

/// Nothing for a vector without a direction.
std::optional<Double3> unit_vector(std::span<const double> a) {
  const Double3 vector(a[0], a[1], a[2]);
  const bool finite = std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
  if (!finite || vector == Double3(0)) return std::nullopt;
  return normalize(vector);
}

std::optional<DirectionPair> of_vectors(std::span<const double> a) {
  const std::optional<Double3> i = unit_vector(a.first(3)), o = unit_vector(a.last(3));
  if (!i || !o) return std::nullopt;
  return DirectionPair{*i, *o};
}

/// A way to name a pair.
struct PairForm {
  std::vector<std::string_view> columns;
  std::optional<DirectionPair> (*pair)(std::span<const double>);
  std::string_view expected;
};

const PairForm& in_out_form() {
  static const PairForm form{
      {"theta_in", "theta_out", "dphi"}, of_in_out, "thetas from 0 to 90 degrees, and a finite dphi"};
  return form;
}
const PairForm& half_difference_form() {
  static const PairForm form{
      {"theta_h", "theta_d", "phi_d"}, of_half_difference, "thetas from 0 to 90 degrees, and a finite phi_d"};
  return form;
}
const PairForm& vectors_form() {
  static const PairForm form{
      {"in_x", "in_y", "in_z", "out_x", "out_y", "out_z"}, of_vectors, "two finite vectors that are not 0"};
  return form;
}

std::string joined_names(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ",") + std::string(name);
  return text;
}

/// Where the form's columns are; nothing if one is missing.
std::optional<std::vector<std::size_t>> columns_of(const NumberTable& table, const PairForm& form) {
  std::vector<std::size_t> places;
  for (const std::string_view name : form.columns) {
    const std::optional<std::size_t> place = table.column(name);
    if (!place) return std::nullopt;
    places.push_back(*place);
  }
  return places;
}

std::string header_of(const NumberTable& table) {
  std::vector<std::string_view> names(table.columns.begin(), table.columns.end());
  return "the columns " + in_quotes(joined_names(names));
}

std::vector<DirectionPair> read_pairs(const NumberTable& table, const PairForm& form,
                                      const std::vector<std::size_t>& places) {
  std::vector<DirectionPair> pairs;
  FaultList faults;
  std::vector<double> numbers(places.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < places.size(); ++k) numbers[k] = table.at(row, places[k]);
    if (const std::optional<DirectionPair> pair = form.pair(numbers)) {
      pairs.push_back(*pair);
      continue;
    }
    std::string found;
    for (const double number : numbers) found += (found.empty() ? "" : ",") + format("%g", number);
    faults.add_from([&] {
      return InputFault{table.file, table.lines[row], 0, joined_names(form.columns), found, std::string(form.expected)};
    });
  }
  faults.throw_if_any();
  return pairs;
}

std::optional<DirectionPair> pair_from(std::string_view text, const PairForm& form) {
  std::vector<double> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    double number = 0;
    if (read_number(text.substr(start, end - start), number) != NumberText::good) return std::nullopt;
    numbers.push_back(number);
    start = end + 1;
  }
  if (numbers.size() != form.columns.size()) return std::nullopt;
  return form.pair(numbers);
}

} // namespace

std::vector<DirectionPair> pairs_of(const NumberTable& table) {
  std::string expected;
  for (const PairForm* const form : {&in_out_form(), &half_difference_form(), &vectors_form()}) {
    if (const auto places = columns_of(table, *form)) return read_pairs(table, *form, *places);
    expected += (expected.empty() ? "" : " or ") + joined_names(form->columns);
  }
  throw InputError(InputFault{table.file, 0, 0, "", header_of(table), "among them " + expected});
}

std::array<std::size_t, 3> rgb_columns(const NumberTable& table) {
  std::array<std::size_t, 3> places{};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::optional<std::size_t> place = table.column(std::string_view("rgb").substr(c, 1));
    if (!place)
      throw InputError(InputFault{table.file, 0, 0, "", header_of(table), "among them r,g,b: values in 1/sr"});
    places[c] = *place;
  }
  return places;
}

std::optional<DirectionPair> in_out_from(std::string_view text) {
  return pair_from(text, in_out_form());
}
std::optional<DirectionPair> half_difference_from(std::string_view text) {
  return pair_from(text, half_difference_form());
}
std::optional<DirectionPair> directions_from(std::string_view text) {
  return pair_from(text, vectors_form());
}

} // namespace refraster
