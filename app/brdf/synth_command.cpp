// refraster brdf synth NAME -o TABLE

#include <refraster/files.h>

#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

/// Reads a parameter's value.
template <class Value>
Option parameter_option(const std::string& name, std::string form, Value& value, const Range& range,
                        std::string meaning) {
  const auto read = [&value, range](const std::string& text) -> std::optional<ValueFault> {
    if (!read_parameter(value, text, range)) return ValueFault{expected_parameter(value, range)};
    return std::nullopt;
  };
  return value_option(name, std::move(form), std::move(meaning), read).by_default(parameter_text(value));
}

Option declared_option(const std::string& name, double& value, const Range& range, std::string_view meaning) {
  return parameter_option(name, "X", value, range, std::string(meaning));
}
Option declared_option(const std::string& name, Double3& value, const Range& range, std::string_view meaning) {
  return parameter_option(name, "R,G,B", value, range, std::string(meaning));
}
template <NamedEnum Enum>
Option declared_option(const std::string& name, Enum& value, const Range&, std::string_view meaning) {
  return enum_option(name, value, std::string(meaning));
}

/// An option for each parameter that changes f.
template <class Block>
std::vector<Option> parameter_options(Block& block) {
  std::vector<Option> options;
  Block::fields(block, [&](std::string_view name, auto& value, const Range& range, std::string_view meaning) {
    if (!is_of_f(name)) return;
    std::string with_dashes = "--" + std::string(name);
    std::replace(with_dashes.begin(), with_dashes.end(), '_', '-');
    options.push_back(declared_option(with_dashes, value, range, meaning));
  });
  return options;
}

/// `brdf synth NAME -o FILE`. model() is asked when the options have been read.
Command table_command(std::string name, std::string meaning, std::vector<Option> parameters,
                      std::function<BrdfModel()> model) {
  struct Arguments {
    std::string output;
    std::uint64_t max_memory = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  arguments->output = name + ".binary";
  Command command{.name = std::move(name), .meaning = std::move(meaning)};
  if (!parameters.empty()) command.groups.push_back({"Formula", std::move(parameters)});
  command.groups.push_back({"Run",
                            {file_option("-o,--output", "FILE", arguments->output, "table to write"),
                             memory_option(arguments->max_memory)}});
  command.finish = [model = std::move(model), arguments]() -> Action {
    return [model, arguments] {
      set_memory_limit(arguments->max_memory, 1);
      check_writable(arguments->output);
      {
        const ProgressLine line("making " + arguments->output);
        const BrdfModel made = model();
        write_merl(arguments->output, merl_table_from([&](const Double3&, const Double3& i, const Double3& o) {
                     return model_value(made, {i, o});
                   }));
      }
      std::cout << arguments->output << "\n";
      return ExitCode::ok;
    };
  };
  return command;
}

template <class Block>
Command model_command(const Block& model) {
  const auto block = std::make_shared<Block>(model);
  return table_command(std::string(Block::name), std::string(model_meaning(model)), parameter_options(*block),
                       [block]() -> BrdfModel { return *block; });
}

} // namespace

Command brdf_synth_command() {
  Command command{.name = "synth", .meaning = "Make a table from a formula"};
  for_each_model([&](const auto& model) { command.commands.push_back(model_command(model)); });
  for (const BrdfPreset& preset : brdf_presets()) {
    if (preset.name == Lambert::name) continue; // is there, with a parameter
    const BrdfModel model = std::visit([](const auto& formula) -> BrdfModel { return formula; }, preset.brdf);
    command.commands.push_back(
        table_command(std::string(preset.name), std::string(preset.meaning), {}, [model] { return model; }));
  }
  return command;
}

} // namespace refraster
