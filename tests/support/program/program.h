#pragma once
// Runs the program as a user does, in a folder of its own.

#include "tests/support/files/malformed_inputs.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace refraster {

using test::TemporaryFolder;

/// Names of what is in a folder, sorted.
std::vector<std::string> files_in(const TemporaryFolder& folder);

/// What starts the program: its path, after an emulator and its options where it is built for another machine.
std::vector<std::string> program_words();
/// The same for a shell.
std::string program_command();

/// What a finished run left.
struct Finished {
  int exit_code = -1; // 128 + signal if it was killed
  std::string out, err;
  std::uint64_t peak_bytes = 0; // the most memory that was resident at once; not less than this process has
};

/// A run that has started.
class Running {
public:
  /// standard_error: a device; by default a file, which wait() gives back.
  Running(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
          const std::string& standard_error = "");
  void send(int signal) const;
  Finished wait();

private:
  TemporaryFolder texts_;
  int process_ = -1;
};

/// Runs `refraster ARGUMENTS` with `folder` as the current directory, standard output and error being files.
Finished run_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments);

std::string text_of(const std::filesystem::path& file);
void save_text(const std::filesystem::path& file, const std::string& text);

} // namespace refraster
