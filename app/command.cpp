#include "app/command.h"

#include "io/file/build_info.h"

namespace refraster {
namespace {

void add_commands(const CommandPath& path, std::vector<CommandPath>& all) {
  all.push_back(path);
  for (const Command& command : path.back()->commands) {
    CommandPath longer = path;
    longer.push_back(&command);
    add_commands(longer, all);
  }
}

} // namespace

const OptionGroup& help_group() {
  const auto nothing = [] {}; // the parser answers them
  static const OptionGroup group = {"Help",
                                    {flag("-h,--help", nothing, "print this help and exit"),
                                     flag("--version", nothing, "print the version and exit")}};
  return group;
}

std::string full_name(const CommandPath& path) {
  std::string text;
  for (const Command* const command : path) text += (text.empty() ? "" : " ") + command->name;
  return text;
}

std::string place_name(const CommandPath& path) {
  return path.size() < 2 ? "" : full_name({path.begin() + 1, path.end()});
}

std::vector<CommandPath> all_commands(const Command& program) {
  std::vector<CommandPath> all;
  add_commands({&program}, all);
  return all;
}

std::vector<const Option*> all_options(const Command& command) {
  std::vector<const Option*> options;
  for (const OptionGroup& group : command.groups)
    for (const Option& option : group.options) options.push_back(&option);
  for (const Option& option : help_group().options) options.push_back(&option);
  return options;
}

std::string version_text() {
  const BuildInfo build = this_build();
  return "refraster " + build.version + " (" + build.compiler + ", " + build.type + ", " + build.isa + ")";
}

Command refraster_command() {
  return {.name = "refraster",
          .meaning = "A reference for images of triangles: renders, compares and explains them, without a GPU",
          .notes = {"Exit codes: 0 done or equal, 1 images differ, 2 wrong usage, 3 bad input or not enough memory, "
                    "4 cannot write, 5 no OpenGL or display, 70 a mistake of refraster's own, 130 interrupted.",
                    "`refraster COMMAND --help` says more."},
          .commands = {render_command(), turntable_command(), assemble_command(), verify_command(), explain_command(),
                       compare_command(), gl_command(), view_command(), bench_command(), suite_command(),
                       scene_command(), mesh_command(), brdf_command(), list_command()}};
}

} // namespace refraster
