// The command line: picks a command, runs it, and turns what went wrong into a message and an exit code.

#include <refraster/notes.h>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/options/help.h"
#include "app/options/parse.h"
#include "app/options/wrap.h"
#include "app/usage_error.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include <unistd.h>

namespace refraster {
namespace {

/// Takes no memory: there may be none.
ExitCode failed(ExitCode code, const char* message, const char* more = "") {
  std::fprintf(stderr, "refraster: %s%s\n", message, more);
  return code;
}

ExitCode out_of_memory(const char* what) {
  return failed(ExitCode::bad_input, what, memory_limit() > 0 ? "; --max-memory allows no more" : "");
}

/// What is wrong, in one line, but on a terminal in lines that fit; and who says more.
ExitCode wrong_usage(const UsageError& error, const CommandPath& path) {
  const std::string message = std::string("refraster: ") + error.what();
  if (isatty(STDERR_FILENO) == 1)
    for (const std::string& line : wrapped(message, terminal_width(STDERR_FILENO))) std::cerr << line << "\n";
  else std::cerr << message << "\n";
  if (dynamic_cast<const BareCommand*>(&error) != nullptr)
    std::cerr << "\n" << help_text(path, terminal_width(STDERR_FILENO));
  else std::cerr << "`" << full_name(path) << " --help` says more.\n";
  return ExitCode::usage;
}

ExitCode run(const std::vector<std::string>& words) {
  const Command program = refraster_command();
  const NamedCommand named = named_command(program, words);
  try {
    return action_of(named)();
  } catch (const UsageError& error) {
    return wrong_usage(error, named.path);
  }
}

ExitCode run_and_report(int argc, char** argv) {
  try {
    return run({argv + std::min(argc, 1), argv + argc}); // without its own name, if it was given one
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
