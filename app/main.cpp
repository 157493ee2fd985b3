// The command line: picks a command, runs it, and turns what went wrong into a message and an exit code.

#include "app/command.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "io/file/input_error.h"

#include <cstdio>
#include <iostream>
#include <new>

namespace refraster {
namespace {

constexpr AddCommand commands[] = {add_render, add_compare, add_gl, add_bench, add_mesh, add_merl, add_list};

/// Takes no memory: there may be none.
ExitCode failed(ExitCode code, const char* message, const char* more = "") {
  std::fprintf(stderr, "refraster: %s%s\n", message, more);
  return code;
}

ExitCode out_of_memory(const char* what) {
  return failed(ExitCode::bad_input, what, memory_limit() > 0 ? "; --max-memory allows no more" : "");
}

ExitCode run(int argc, char** argv) {
  CLI::App program("A reference for images of triangles: renders, compares and explains them. Without a GPU.",
                   "refraster");
  program.set_version_flag("--version", version_text(), "Print the version and exit");
  program.require_subcommand(1);
  program.footer("Exit codes: 0 done or equal, 1 images differ, 2 wrong usage, 3 bad input or not enough memory,\n"
                 "4 cannot write, 5 no OpenGL, 130 interrupted.\n`refraster COMMAND --help` says more.");
  Action chosen;
  for (const AddCommand add : commands) add(program, chosen);

  try {
    program.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? ExitCode::ok : ExitCode::usage; // prints help, version, or what is wrong
  }
}

ExitCode run_and_report(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    const ExitCode code = failed(ExitCode::bad_input, error.what());
    std::fputs(error.advice().c_str(), stderr);
    return code;
  } catch (const OutputError& error) {
    return failed(ExitCode::cannot_write, error.what());
  } catch (const OutOfMemory& error) {
    return out_of_memory(error.what());
  } catch (const std::bad_alloc&) {
    return out_of_memory("out of memory");
  } catch (const std::exception& error) {
    return failed(ExitCode::internal, "internal error: ", error.what());
  }
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  using namespace refraster;
  stop_when_interrupted();
  ExitCode code = run_and_report(argc, argv);
  std::cout.flush();
  if (!std::cout && code == ExitCode::ok) code = failed(ExitCode::cannot_write, "standard output: cannot write");
  if (interrupted()) code = ExitCode::interrupted; // also if all was done before anyone looked
  return static_cast<int>(code);
}
