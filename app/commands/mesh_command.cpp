// refraster mesh sphere | cube | plane | torus | knot: the shapes of a scene's "mesh", with the same parameters, as a
// file; and refraster mesh info: what is in one.

#include <refraster/files.h>

#include "app/command.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "io/scene/model_facts.h"
#include "io/scene/shape_mesh.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

/// "tube_radius" in a scene file is "--tube-radius" here.
std::string option_name(std::string_view key) {
  std::string name = "--" + std::string(key);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

template <class S>
Command shape_command() {
  struct Arguments {
    S shape;
    std::string output = std::string(S::name) + ".obj";
    std::uint64_t max_memory = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  std::vector<Option> parameters;
  S::fields(arguments->shape,
            [&](std::string_view key, auto& value, const Range& range, std::string_view meaning, Presence) {
              parameters.push_back(number_option(option_name(key), value, range, std::string(meaning)));
            });
  Command command{.name = std::string(S::name), .meaning = std::string(S::meaning)};
  if (!parameters.empty()) command.groups.push_back({"Shape", parameters});
  command.groups.push_back({"Run",
                            {file_option("-o,--output", "FILE", arguments->output, "OBJ file to write"),
                             memory_option(arguments->max_memory)}});
  command.finish = [arguments]() -> Action {
    return [arguments] {
      const MemoryBudget memory = set_memory_limit(arguments->max_memory, 1);
      check_writable(arguments->output);
      {
        const ProgressLine line("making " + arguments->output);
        const MeshCounts counts = mesh_counts(arguments->shape);
        memory.need(counts.size_bytes(), std::to_string(counts.triangles) + " triangles");
        write_obj(arguments->output, *make_mesh(arguments->shape));
      }
      std::cout << arguments->output << "\n";
      return ExitCode::ok;
    };
  };
  return command;
}

template <class... S>
std::vector<Command> shape_commands(const std::variant<S...>*) {
  return {shape_command<S>()...};
}

struct InfoArguments {
  std::string model, json;
  SceneOptions reading;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

ExitCode print_info(const InfoArguments& a) {
  check_different({a.json}, {a.model});
  if (!a.json.empty()) check_writable(a.json);
  NoteList notes;
  SceneOptions reading = a.reading;
  reading.notes = &notes;
  auto line = progress_line(a.diagnostics, "reading " + a.model);
  const ModelFacts facts = model_facts(a.model, reading);
  line.reset(); // before anything is printed
  print_file_notes(notes, a.diagnostics);
  if (!a.json.empty()) write_text(a.json, model_facts_json(a.model, facts));
  if (a.json != standard_output) std::cout << model_facts_text(facts);
  return ExitCode::ok;
}

Command info_command() {
  const auto arguments = std::make_shared<InfoArguments>();
  InfoArguments& a = *arguments;
  return {.name = "info",
          .meaning = "What is in an OBJ file and the files it names, and what is missing",
          .groups = {{"Mesh", {argument("FILE", a.model, "mesh, .obj"), outside_option(a.reading.outside)}},
                     {"Run",
                      {memory_option(a.max_memory),
                       file_option("--json", "FILE", a.json, "write it as JSON; - is standard output"),
                       strict_option(a.diagnostics), quiet_option(a.diagnostics)}}},
          .finish = [arguments]() -> Action {
            return [arguments] {
              arguments->reading.memory = set_memory_limit(arguments->max_memory, 1);
              return print_info(*arguments);
            };
          }};
}

} // namespace

Command mesh_command() {
  std::vector<Command> commands = shape_commands(static_cast<const Shape*>(nullptr));
  commands.push_back(info_command());
  return {.name = "mesh", .meaning = "Make a mesh and write it as OBJ, or look into one", .commands = commands};
}

} // namespace refraster
