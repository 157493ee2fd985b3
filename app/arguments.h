#pragma once
// Words of the command line that are more than a number or a name.

#include <refraster/fields.h>
#include <refraster/render.h>

#include "io/file/limits.h"
#include "io/scene/scene_file.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

struct Size {
  int width = 1280, height = 720;
  bool operator==(const Size&) const = default;
};
inline constexpr int largest_side = limit::frame_side.value; // pixels

/// "1280x720", each side 1 to largest_side.
std::optional<Size> size_from(std::string_view text);

/// "1280x720,1920x1080", each once.
std::optional<std::vector<Size>> sizes_from(std::string_view text);

/// "x,y,width,height", none negative, width and height at least 1.
std::optional<PixelRect> crop_from(std::string_view text);

/// "depth,normal": names from aov_names, each once.
std::optional<std::vector<Aov>> aovs_from(std::string_view text);

/// The names of all precisions.
std::vector<std::string> precision_names();

/// The names of those that are measured for their speed: all but `exact`.
std::vector<std::string> lane_precision_names();

/// "double,float": some of the latter, each once.
std::optional<std::vector<std::string>> precisions_from(std::string_view text);

/// Throws CLI::ValidationError for more than limit::frame_samples.
void check_frame_samples(int width, int height, int samples);

/// "1,2,4": numbers of threads, each 1 to limit::threads and once.
std::optional<std::vector<int>> thread_counts_from(std::string_view text);

/// "0.8" or "0.6,0.05,0.03": what is reflected of red, green and blue, each in [0, 1]. One number stands for all three.
std::optional<Double3> reflectance_from(std::string_view text);

/// A finite number, not negative.
std::optional<double> distance_from(std::string_view text);

/// A whole number, not negative.
std::optional<std::uint64_t> count_from(std::string_view text);

/// --allow-outside, for the commands that read scenes.
void add_outside_option(CLI::App& command, Outside& outside);
/// --cache, for the commands that read scenes: a folder of large meshes that were read before. check_cache_folder.
void add_cache_option(CLI::App& command, std::string& folder);

/// The number that the whole text is. from_chars takes no sign for an unsigned one, and no locale.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// An option for a number in a range; the help shows the range in place of the value. NaN is in none.
template <class Number>
CLI::Option* add_number_option(CLI::App& command, const std::string& name, Number& value, const Range& range,
                               const std::string& description) {
  const auto text = [](double x) { // not 1e+06
    const auto whole = static_cast<Number>(x);
    return static_cast<double>(whole) == x ? CLI::detail::to_string(whole) : CLI::detail::to_string(x);
  };
  const std::string form = range.ends == Ends::included ? text(range.min) + ".." + text(range.max)
                                                        : ">" + text(range.min) + "..<" + text(range.max);
  // Not as CLI11 reads numbers: to it, 010 is 8.
  const auto read = [&value, range, form, name](const std::string& given) {
    const std::optional<Number> number = number_from<Number>(given);
    if (!number || !range.contains(static_cast<double>(*number)))
      throw CLI::ValidationError(name, "found " + given + ", expected a number in " + form);
    value = *number;
  };
  return command.add_option_function<std::string>(name, read, description)
      ->type_name(form)
      ->default_str(CLI::detail::to_string(value));
}

/// An option for one of a few words or numbers; the help shows them.
template <class Value>
CLI::Option* add_choice_option(CLI::App& command, const std::string& name, Value& value,
                               const std::vector<Value>& choices, const std::string& description) {
  std::string form;
  for (const Value& choice : choices) form += (form.empty() ? "" : "|") + CLI::detail::to_string(choice);
  const auto fault = [choices, form](const std::string& given) {
    for (const Value& choice : choices)
      if (CLI::detail::to_string(choice) == given) return std::string();
    return "found \"" + given + "\", expected " + form;
  };
  return command.add_option(name, value, description)->type_name(form)->check(CLI::Validator(fault, ""));
}

/// An option whose text `parse` turns into a value; nothing from parse is wrong usage, and the message says what was
/// found and expected. `form` stands for the value in the help.
template <class Value, class Parsed>
CLI::Option* add_parsed_option(CLI::App& command, const std::string& name, Value& value,
                               std::optional<Parsed> (*parse)(std::string_view), const std::string& form,
                               const std::string& expected, const std::string& description) {
  const auto read = [&value, parse, name, expected](const std::string& text) {
    std::optional<Parsed> parsed = parse(text);
    if (!parsed) throw CLI::ValidationError(name, "found \"" + text + "\", expected " + expected);
    if constexpr (requires { value.push_back(*parsed); }) value.push_back(*parsed);
    else value = std::move(*parsed);
  };
  return command.add_option_function<std::string>(name, read, description)->type_name(form);
}

} // namespace refraster
