#pragma once
// A command of the program: its options, and what it does.

#include "app/options/option.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// The same in every command.
enum class ExitCode {
  ok = 0,           // done; images are equal
  differ = 1,       // images differ
  usage = 2,        // wrong arguments
  bad_input = 3,    // a file that cannot be read, is not what it should be, or needs more memory than there may be
  cannot_write = 4, // an output file, or standard output
  no_opengl = 5,    // no OpenGL, or no display, on this machine
  internal = 70,    // our own mistake
  interrupted = 130 // by SIGINT, as a shell counts it; or by SIGTERM, SIGHUP
};

/// What a command does once all arguments are known to be right. May throw InputError, OutputError and, where only
/// files show that arguments are wrong, UsageError.
using Action = std::function<ExitCode()>;

/// A command, declared: either one that does something, or one with further commands, of which one must follow.
struct Command {
  std::string name, meaning;            // meaning: a phrase without a full stop
  std::vector<OptionGroup> groups = {}; // help_group() is further to these, in every command
  std::vector<std::string> notes = {};  // paragraphs of the help, below the options
  std::vector<Command> commands = {};   // that may follow
  /// Called once all options have read their values: checks what a single one does not show, which may throw
  /// UsageError, and gives what is to be done. Keeps alive what the options read into.
  std::function<Action()> finish = {};
};

/// --help and --version.
const OptionGroup& help_group();

/// From the program down to a command: refraster, brdf, synth.
using CommandPath = std::vector<const Command*>;
/// "refraster brdf synth".
std::string full_name(const CommandPath& path);
/// "brdf synth", as messages name it behind "refraster: "; of the program itself "".
std::string place_name(const CommandPath& path);

/// Every command below and including this one, parents first, in the order of declaration.
std::vector<CommandPath> all_commands(const Command& program);

/// All options and arguments, in the order of the help.
std::vector<const Option*> all_options(const Command& command);

/// What --version prints at every level.
std::string version_text();

// One file each.
Command render_command();    // render_command.cpp
Command turntable_command(); // turntable_command.cpp
Command assemble_command();  // parts/assemble_command.cpp
Command compare_command();   // compare_command.cpp
Command verify_command();    // verify_command.cpp
Command explain_command();   // explain_command.cpp
Command gl_command();        // gl_command.cpp
Command bench_command();     // bench_command.cpp
Command view_command();      // view_command.cpp
Command scene_command();     // scene_command.cpp
Command mesh_command();      // mesh_command.cpp
Command suite_command();     // suite/suite_command.cpp
Command brdf_command();      // brdf/brdf_command.cpp
Command list_command();      // list_command.cpp

/// The program: all of them.
Command refraster_command();

} // namespace refraster
