// The command line: picks a command, runs it, and turns what went wrong into a message and an exit code.

#include "app/command.h"
#include "app/interrupt.h"
#include "io/input_error.h"

#include <cstdio>
#include <iostream>
#include <new>

namespace refraster {
namespace {

constexpr AddCommand commands[] = {add_render, add_compare, add_gl, add_bench, add_mesh, add_merl, add_list};

ExitCode failed(ExitCode code, const std::string& message) {
  std::cerr << "refraster: " << message << "\n";
  return code;
}

ExitCode run(int argc, char** argv) {
  CLI::App program("A reference for images of triangles: renders, compares and explains them. Without a GPU.",
                   "refraster");
  program.set_version_flag("--version", version_text(), "Print the version and exit");
  program.require_subcommand(1);
  program.footer("Exit codes: 0 done or equal, 1 images differ, 2 wrong usage, 3 bad input, 4 cannot write, "
                 "5 no OpenGL.\n`refraster COMMAND --help` says more.");
  Action chosen;
  for (const AddCommand add : commands) add(program, chosen);

  try {
    program.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? ExitCode::ok : ExitCode::usage; // prints help, version, or what is wrong
  } catch (const InputError& error) {
    return failed(ExitCode::bad_input, error.what());
  } catch (const OutputError& error) {
    return failed(ExitCode::cannot_write, error.what());
  } catch (const std::bad_alloc&) {
    return failed(ExitCode::internal, "out of memory");
  } catch (const std::exception& error) {
    return failed(ExitCode::internal, std::string("internal error: ") + error.what());
  }
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  using namespace refraster;
  stop_gently_when_interrupted();
  ExitCode code = run(argc, argv);
  std::cout.flush();
  if (!std::cout && code == ExitCode::ok) code = failed(ExitCode::cannot_write, "standard output: cannot write");
  return static_cast<int>(code);
}
