// refraster list: what there is to choose from, and what is made of the declared options.

#include <refraster/files.h>
#include <refraster/render.h>

#include "app/command.h"
#include "app/options/completions/completions.h"
#include "app/options/man_page.h"
#include "app/options/manual.h"
#include "app/options/parse.h"
#include "app/options/unknown_words.h"
#include "app/output.h"
#include "app/usage_error.h"
#include "app/view/keys.h"
#include "io/file/limits.h"
#include "io/scene/scene_markdown.h"
#include "math/precisions.h"
#include "shading/fragment_functions.h"
#include "shading/precision_bounds.h"
#include "verify/device/profile_markdown.h"
#include "verify/device/read_profile.h"

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
    const int lanes = precision_lanes(R::id); // of the library, which may be for a newer processor than this program
    std::cout << padded(R::name, 8) << R::purpose << "; " << lanes << (lanes == 1 ? " lane\n" : " lanes here\n");
    if (const std::string errors = stated_errors<R>(); !errors.empty())
      std::cout << padded("", 8) << "at most from double: " << errors << "\n";
  };
  (print(Precision{}), ...);
  std::cout << "Errors are of the radiance from a light of radiance 1, in ordinary directions; docs/precision.md.\n";
}

void print_devices() {
  std::size_t width = 0;
  for (const std::string_view name : device_profile_names()) width = std::max(width, name.size() + 2);
  for (const std::string_view name : device_profile_names())
    std::cout << padded(name, width) << device_profile(std::string(name)).meaning << "\n";
}

/// A list without options.
Command printing_command(std::string name, std::string meaning, void (*print)()) {
  return {.name = std::move(name), .meaning = std::move(meaning), .finish = [print]() -> Action {
            return [print] {
              print();
              return ExitCode::ok;
            };
          }};
}

Command completions_command() {
  struct Arguments {
    std::size_t shell = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  std::vector<std::string> names;
  for (const Shell& shell : shells) names.emplace_back(shell.name);
  const auto set_shell = [arguments](std::size_t i) { arguments->shell = i; };
  return {.name = "completions",
          .meaning = "What makes a shell complete commands and options",
          .groups = {{"Shell", {word_option("SHELL", names, set_shell, "bash, zsh or fish").required()}}},
          .notes = {"bash: source <(refraster list completions bash)",
                    "zsh: write it to a file _refraster in a folder of $fpath.",
                    "fish: refraster list completions fish | source"},
          .finish = [arguments]() -> Action {
            return [arguments] {
              std::cout << shells[arguments->shell].completions(refraster_command());
              return ExitCode::ok;
            };
          }};
}

/// Goes down from the program. Throws UsageError.
CommandPath path_of(const Command& program, const std::vector<std::string>& words) {
  const NamedCommand named = named_command(program, words);
  if (named.rest.empty()) return named.path;
  if (named.path.back()->commands.empty())
    throw UsageError(place_name(named.path), "\"" + named.rest[0] + "\"", "no further command");
  throw unknown_command(named.path, named.rest[0]);
}

/// A file each, as `man` finds them.
void write_pages(const CommandPath& of, const std::string& folder) {
  prepare_folder(folder);
  for (const CommandPath& below : all_commands(*of.back())) {
    CommandPath path = of;
    path.insert(path.end(), below.begin() + 1, below.end());
    write_text(folder + "/" + page_name(path) + ".1", man_page(path));
  }
}

Command man_page_command() {
  struct Arguments {
    std::vector<std::string> words;
    std::string folder;
  };
  const auto arguments = std::make_shared<Arguments>();
  Option command = refraster::arguments("COMMAND", arguments->words,
                                        "command to describe, as render, or brdf info; by default refraster");
  command.completes = Completes::commands;
  return {.name = "man-page",
          .meaning = "Page of the manual, for man -l",
          .groups = {{"Command", {std::move(command)}},
                     {"Output",
                      {folder_option("--folder", arguments->folder,
                                     "write the page, and those of all commands below it, to files of this folder, "
                                     "made if need be: refraster-render.1")}}},
          .notes = {"refraster list man-page render | man -l -"},
          .finish = [arguments]() -> Action {
            const auto program = std::make_shared<Command>(refraster_command());
            return [arguments, program, path = path_of(*program, arguments->words)] {
              if (arguments->folder.empty()) std::cout << man_page(path);
              else write_pages(path, arguments->folder);
              return ExitCode::ok;
            };
          }};
}

} // namespace

Command list_command() {
  return {
      .name = "list",
      .meaning = "Print what there is to choose from, completions for shells, pages of the manual",
      .commands = {
          printing_command("fragment-functions", "Fragment functions and their parameters",
                           [] { print_fragment_functions(static_cast<const FragmentFunction*>(nullptr)); }),
          printing_command("precisions", "Precisions that a frame can be rendered in",
                           [] { print_precisions(static_cast<const Precisions*>(nullptr)); }),
          printing_command("devices", "Devices whose profiles the program has: docs/devices.md", print_devices),
          printing_command("device-values", "What the profile of each device says, as Markdown",
                           [] { std::cout << device_profiles_markdown(); }),
          printing_command("limits", "How large anything may be, as Markdown", [] { std::cout << limits_markdown(); }),
          printing_command("scene-format", "Every key of a scene file, as Markdown",
                           [] { std::cout << scene_format_markdown(); }),
          printing_command("keys", "Keys of the window of view, as Markdown", [] { std::cout << keys_markdown(); }),
          completions_command(), man_page_command()}};
}

} // namespace refraster
