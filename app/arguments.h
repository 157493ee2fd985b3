#pragma once
// Words of the command line that are more than a number or a name.

#include "raster/render.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

struct Size {
  int width = 1280, height = 720;
};
inline constexpr int largest_side = 16384; // pixels; as RenderOptions allows

/// "1280x720", each side 1 to largest_side.
std::optional<Size> size_from(std::string_view text);

/// "x,y,width,height", none negative, width and height at least 1.
std::optional<Crop> crop_from(std::string_view text);

/// "depth,normal": names from aov_names, each once.
std::optional<std::vector<Aov>> aovs_from(std::string_view text);

/// "0.8" or "0.6,0.05,0.03": what is reflected of red, green and blue, each in [0, 1]. One number stands for all three.
std::optional<Double3> reflectance_from(std::string_view text);

/// An option whose text `parse` turns into a value; nothing from parse is wrong usage, and the message says what was
/// found and expected. For an option of a list of words, shown as `form` in the help.
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
