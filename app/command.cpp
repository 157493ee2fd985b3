#include "app/command.h"

#include "io/file/build_info.h"

namespace refraster {

CLI::App& add_sub_command(CLI::App& parent, const std::string& name, const std::string& description) {
  CLI::App& command = *parent.add_subcommand(name, description);
  command.set_version_flag("--version", version_text(), "Print the version and exit");
  command.footer(""); // not the parent's
  command.option_defaults()->always_capture_default();
  return command;
}

std::string version_text() {
  const BuildInfo build = this_build();
  return "refraster " + build.version + " (" + build.compiler + ", " + build.type + ", " + build.isa + ")";
}

} // namespace refraster
