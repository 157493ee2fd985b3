// refraster list fragment-functions | precisions | limits | scene-format

#include <refraster/render.h>

#include "app/command.h"
#include "io/file/limits.h"
#include "io/scene/scene_file.h"
#include "math/precisions.h"
#include "shading/fragment_functions.h"
#include "shading/precision_bounds.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <type_traits>

namespace refraster {
namespace {

std::string padded(std::string_view text, std::size_t width) {
  std::string result(text);
  result.resize(std::max(width, text.size()), ' ');
  return result;
}

/// ": nearest, trilinear (default)" for a parameter that is one of a few words; nothing for a number.
template <class Value>
std::string choices(const Value& chosen) {
  std::string text;
  if constexpr (NamedEnum<Value>) {
    for (const auto& [value, name] : EnumNames<Value>::names) {
      text += text.empty() ? ": " : ", ";
      text += name;
      if (value == chosen) text += " (default)";
    }
  }
  return text;
}

template <class M>
void print_fragment_function() {
  std::cout << M::name << "\n  shader files  ";
  const char* separator = "";
  for (const std::string_view name : M::shader_stems) {
    std::cout << separator << name;
    separator = ", ";
  }
  std::cout << "\n";
  M function;
  M::fields(function, [](std::string_view name, const auto& value, const Range&, std::string_view meaning) {
    std::cout << "  " << padded(name, 14) << meaning << choices(value) << "\n";
  });
}

template <class... Functions>
void print_fragment_functions(const std::variant<Functions...>*) {
  (print_fragment_function<Functions>(), ...);
}

std::string digits(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", x);
  return text.data();
}

/// "phong 9.5e-07, …": how far each fragment function may be from double.
template <class Precision>
std::string stated_errors() {
  std::string text;
  const auto add = [&](std::string_view function, double error) {
    text.append(text.empty() ? "" : ", ").append(function).append(" ").append(digits(error));
  };
  if constexpr (std::is_same_v<Precision, FloatPrecision>) {
    for (const PrecisionBound& bound : precision_bounds)
      if (bound.inputs == "ordinary") add(bound.function, bound.float_from_double);
  } else if constexpr (std::is_same_v<Precision, FastPrecision>) {
    for (const FastBound& bound : fast_bounds) add(bound.function, bound.max);
  }
  return text;
}

template <class... Precision>
void print_precisions(const std::tuple<Precision...>*) {
  const auto print = []<class R>(R) {
    std::cout << padded(R::name, 8) << R::purpose << "; " << R::lanes << (R::lanes == 1 ? " lane\n" : " lanes here\n");
    if (const std::string errors = stated_errors<R>(); !errors.empty())
      std::cout << padded("", 8) << "at most from double: " << errors << "\n";
  };
  (print(Precision{}), ...);
  std::cout << "Errors are of the radiance from a light of radiance 1, in ordinary directions; docs/precision.md.\n";
}

} // namespace

void add_list(CLI::App& program, Action& chosen) {
  CLI::App& list = add_sub_command(program, "list", "Print what there is to choose from");
  list.require_subcommand(1);
  add_sub_command(list, "fragment-functions", "Fragment functions and their parameters").final_callback([&chosen] {
    chosen = [] {
      print_fragment_functions(static_cast<const FragmentFunction*>(nullptr));
      return ExitCode::ok;
    };
  });
  add_sub_command(list, "precisions", "Precisions that a frame can be rendered in").final_callback([&chosen] {
    chosen = [] {
      print_precisions(static_cast<const Precisions*>(nullptr));
      return ExitCode::ok;
    };
  });
  add_sub_command(list, "limits", "How large anything may be, as Markdown").final_callback([&chosen] {
    chosen = [] {
      std::cout << limits_markdown();
      return ExitCode::ok;
    };
  });
  add_sub_command(list, "scene-format", "Every key of a scene file, as Markdown").final_callback([&chosen] {
    chosen = [] {
      std::cout << scene_format_markdown();
      return ExitCode::ok;
    };
  });
}

} // namespace refraster
