#include "app/options/scene_options.h"

#include <refraster/material.h>

#include "shading/srgb_curve.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace refraster {
namespace {

/// Numbers with commas between them, each finite; nothing for another count.
std::optional<std::vector<double>> finite_numbers(std::string_view text, std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> number = number_from<double>(part);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() < least || numbers.size() > most) return std::nullopt;
  return numbers;
}

/// "#3c6e71" as linear values: the eight bits of a channel are encoded by the sRGB curve, as everywhere on the web.
std::optional<Double3> colour_of_hex(std::string_view text) {
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  Double3 colour;
  for (int c = 0; c < 3; ++c) {
    const std::string_view digits = text.substr(1 + 2 * static_cast<std::size_t>(c), 2);
    int level = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + 2, level, 16);
    if (error != std::errc{} || end != digits.data() + 2 || digits.front() == '-') return std::nullopt;
    colour[c] = srgb_decoded(level / 255.0);
  }
  return colour;
}

std::string three(double x, double y, double z) {
  return "[" + json_number(x) + ", " + json_number(y) + ", " + json_number(z) + "]";
}

/// An option for three numbers that stand at `pointer`.
Option vector_option(const std::string& name, const std::string& form, const std::string& pointer,
                     const std::string& expected, SceneChanges& changes, const std::string& meaning) {
  return value_option(name, form, meaning, [=, &changes](const std::string& text) -> std::optional<ValueFault> {
    const auto v = finite_numbers(text, 3, 3);
    if (!v) return ValueFault{expected};
    changes.values.push_back({pointer, three((*v)[0], (*v)[1], (*v)[2]), name});
    return std::nullopt;
  });
}

Option camera_option(SceneChanges& changes) {
  const auto read = [&changes](const std::string& text) -> std::optional<ValueFault> {
    const auto v = finite_numbers(text, 2, 3);
    if (!v || std::abs((*v)[1]) > 90 || (v->size() == 3 && !((*v)[2] > 0)))
      return ValueFault{"azimuth,elevation or azimuth,elevation,distance: degrees, the second from -90 to 90, and a "
                        "distance > 0"};
    const auto add = [&changes](const std::string& key, const std::string& value) {
      changes.view.push_back({"/scene/camera/" + key, value, "--camera"});
    };
    // A camera that stands somewhere is moved, with its planes.
    for (const char* const key : {"position", "target", "near", "far"}) add(key, "");
    add("fit/azimuth", json_number((*v)[0]));
    add("fit/elevation", json_number((*v)[1]));
    add("fit/distance", v->size() == 3 ? json_number((*v)[2]) : "");
    return std::nullopt;
  };
  return value_option("--camera", "AZIMUTH,ELEVATION[,DISTANCE]",
                      "look from there at all that the scene shows: degrees about the up vector, 0 from the front "
                      "(+z where +y is up), and above the plane across it; from as near as lets all be seen, or from "
                      "this distance",
                      read);
}

Option fov_option(SceneChanges& changes) {
  const auto read = [&changes](const std::string& text) -> std::optional<ValueFault> {
    const std::optional<double> degrees = number_from<double>(text);
    if (!degrees || !(*degrees > 0 && *degrees < 180)) return ValueFault{"degrees > 0 and < 180"};
    changes.values.push_back({"/scene/camera/fov_y", json_number(*degrees), "--fov"});
    return std::nullopt;
  };
  return value_option("--fov", ">0..<180", "vertical field of view, degrees", read);
}

Option background_option(SceneChanges& changes) {
  const auto read = [&changes](const std::string& text) -> std::optional<ValueFault> {
    std::optional<Double3> colour = colour_of_hex(text);
    if (const auto v = finite_numbers(text, 3, 3)) colour = Double3((*v)[0], (*v)[1], (*v)[2]);
    if (!colour || !(colour->x >= 0 && colour->y >= 0 && colour->z >= 0))
      return ValueFault{"R,G,B (numbers >= 0; 1 is white) or #rrggbb"};
    changes.values.push_back({"/scene/background", three(colour->x, colour->y, colour->z), "--background"});
    return std::nullopt;
  };
  return value_option("--background", "R,G,B|#RRGGBB",
                      "colour where there is no surface: linear values, or as it looks with the sRGB curve", read);
}

template <class... Function>
std::vector<std::string> function_names(const std::variant<Function...>*) {
  return {std::string(Function::name)...};
}

Option fragment_function_option(SceneChanges& changes) {
  const std::vector<std::string> names = fragment_function_names();
  return word_option(
      "--fragment-function", names,
      [&changes, names](std::size_t i) { changes.values.push_back(fragment_function_edit(names[i])); },
      "which function shades all objects");
}

/// "/scene/camera/fov_y=30". An '=' may be part of a key, but no scene has such a key outside `materials`: the first
/// behind which JSON stands would not be told from it.
Option set_option(SceneChanges& changes) {
  const auto read = [&changes](const std::string& text) -> std::optional<ValueFault> {
    const std::size_t equals = text.find('=');
    if (!text.starts_with('/') || equals == std::string::npos || equals + 1 == text.size())
      return ValueFault{"/POINTER=VALUE, a JSON pointer and JSON, as /scene/camera/fov_y=30"};
    changes.set.push_back({text.substr(0, equals), text.substr(equals + 1), "--set"});
    return std::nullopt;
  };
  Option option = value_option("--set", "/POINTER=VALUE",
                               "set a value of the scene file before it is read, by its JSON pointer (RFC 6901; * "
                               "stands for each element of an array), as /scene/camera/fov_y=30; may be repeated",
                               read);
  option.occurs = Occurs::repeatedly;
  return option;
}

} // namespace

std::vector<SceneEdit> SceneChanges::edits() const {
  std::vector<SceneEdit> all = view;
  all.insert(all.end(), values.begin(), values.end());
  all.insert(all.end(), set.begin(), set.end());
  return all;
}

std::vector<std::string> fragment_function_names() {
  return function_names(static_cast<const FragmentFunction*>(nullptr));
}

SceneEdit fragment_function_edit(const std::string& name) {
  return {"/scene/objects/*/fragment_function", json_string(name), "--fragment-function"};
}

OptionGroup scene_change_options(SceneChanges& changes) {
  return {"View",
          {camera_option(changes),
           vector_option("--look-at", "X,Y,Z", "/scene/camera/target", "x,y,z: three numbers", changes,
                         "the point in the middle of the image, world space"),
           fov_option(changes),
           vector_option("--up", "X,Y,Z", "/scene/camera/up", "x,y,z: three numbers", changes,
                         "which way is up, world space: 0,0,1 for models with z up"),
           background_option(changes), fragment_function_option(changes), set_option(changes)}};
}

} // namespace refraster
