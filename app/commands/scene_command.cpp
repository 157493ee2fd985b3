// refraster scene SCENE|MODEL -o scene.json: the scene written out, to go on from.

#include "app/command.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "io/scene/whole_scene.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct SceneArguments {
  std::string scene, output;
  SceneOptions reading;
  SceneChanges changes;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

ExitCode run(const SceneArguments& a) {
  check_different({a.output}, {a.scene});
  check_writable(a.output);
  prepare_cache(a.reading.mesh_cache);
  NoteList notes;
  SceneOptions reading = a.reading;
  reading.notes = &notes;
  auto line = progress_line(a.diagnostics, "reading " + a.scene);
  const std::string folder =
      a.output == standard_output ? "" : std::filesystem::path(a.output).parent_path().string();
  const WholeScene written = whole_scene(a.scene, reading, a.changes.edits(), folder);
  line.reset(); // before anything is printed
  print_file_notes(notes, a.diagnostics);
  write_text(a.output, written.text);
  if (written.names_outside)
    print_note(a.output + " names files outside its folder: reading it needs --allow-outside", a.diagnostics);
  if (a.output != standard_output) std::cout << a.output << "\n";
  return ExitCode::ok;
}

} // namespace

Command scene_command() {
  const auto arguments = std::make_shared<SceneArguments>();
  SceneArguments& a = *arguments;
  return {.name = "scene",
          .meaning = "Write the scene that shows a model, or a changed one, as a file",
          .groups = {{"Scene",
                      {scene_argument(a.scene), outside_option(a.reading.outside), cache_option(a.reading.mesh_cache)}},
                     scene_change_options(a.changes),
                     {"Run",
                      {file_option("-o,--output", "FILE", a.output,
                                   "scene file to write; - is standard output, for a file in the current directory; by "
                                   "default the scene's name with .json, in the current directory"),
                       memory_option(a.max_memory), strict_option(a.diagnostics), quiet_option(a.diagnostics)}}},
          .notes = {"All is written that rendering needs to know, materials of OBJ files as blocks under their names: "
                    "rendering the file gives the same image. docs/models.md"},
          .finish = [arguments]() -> Action {
            if (arguments->output.empty()) arguments->output = stem(arguments->scene) + ".json";
            return [arguments] {
              arguments->reading.memory = set_memory_limit(arguments->max_memory, 1);
              return run(*arguments);
            };
          }};
}

} // namespace refraster
