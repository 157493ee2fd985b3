// refraster list fragment-functions | rungs | scene-format

#include "app/command.h"
#include "io/scene_file.h"
#include "math/rungs.h"
#include "shading/models.h"

#include <algorithm>
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
void print_model() {
  std::cout << M::name << "\n  shader files  ";
  const char* separator = "";
  for (const std::string_view name : M::shader_stems) {
    std::cout << separator << name;
    separator = ", ";
  }
  std::cout << "\n";
  M model;
  M::fields(model, [](std::string_view name, const auto& value, const Range&, std::string_view meaning) {
    std::cout << "  " << padded(name, 14) << meaning << choices(value) << "\n";
  });
}

template <class... Models>
void print_models(const std::variant<Models...>*) {
  (print_model<Models>(), ...);
}

template <class... Rung>
void print_rungs(const std::tuple<Rung...>*) {
  ((std::cout << padded(Rung::name, 8) << Rung::purpose << "; " << NumberTraits<typename Rung::Number>::lanes
              << " lanes here\n"),
   ...);
}

} // namespace

void add_list(CLI::App& program, Action& chosen) {
  CLI::App& list = add_sub_command(program, "list", "Print what there is to choose from");
  list.require_subcommand(1);
  add_sub_command(list, "fragment-functions", "Fragment functions and their parameters").final_callback([&chosen] {
    chosen = [] {
      print_models(static_cast<const Model*>(nullptr));
      return ExitCode::ok;
    };
  });
  add_sub_command(list, "rungs", "Precisions that a frame can be rendered in").final_callback([&chosen] {
    chosen = [] {
      print_rungs(static_cast<const Rungs*>(nullptr));
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
