#pragma once
// A sub-command of the program: its options, and what it does.

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace refraster {

/// The same in every command.
enum class ExitCode {
  ok = 0,           // done; images are equal
  differ = 1,       // images differ
  usage = 2,        // wrong arguments
  bad_input = 3,    // a file that cannot be read, is not what it should be, or needs more memory than there may be
  cannot_write = 4, // an output file, or standard output
  no_opengl = 5,    // no OpenGL on this machine
  internal = 70,    // our own mistake
  interrupted = 130 // by SIGINT, as a shell counts it; or by SIGTERM, SIGHUP
};

/// What a command does once all arguments are known to be right. May throw InputError and OutputError.
using Action = std::function<ExitCode()>;

/// Adds a command to the program; the action of the one that the user named is put into `chosen`.
using AddCommand = void (*)(CLI::App& program, Action& chosen);

/// A sub-command with --help and --version, which prints the default of each option.
CLI::App& add_sub_command(CLI::App& parent, const std::string& name, const std::string& description);

/// What --version prints at every level.
std::string version_text();

// One file each.
void add_render(CLI::App& program, Action& chosen);  // render_command.cpp
void add_compare(CLI::App& program, Action& chosen); // compare_command.cpp
void add_gl(CLI::App& program, Action& chosen);      // gl_command.cpp
void add_bench(CLI::App& program, Action& chosen);   // bench_command.cpp
void add_mesh(CLI::App& program, Action& chosen);    // mesh_command.cpp
void add_merl(CLI::App& program, Action& chosen);    // merl_command.cpp
void add_list(CLI::App& program, Action& chosen);    // list_command.cpp

} // namespace refraster
