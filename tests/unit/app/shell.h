#pragma once
// Programs that judge what is made for them: shells, formatters.

#include <string>

namespace refraster::test {

/// Whether there is a program of this name. If not, the test says so: it is skipped.
bool installed(const std::string& program);

/// What `command` answers to `input`, which it finds in a file in place of FILE: all that it prints.
struct Answer {
  int exit_code;
  std::string text;
};
Answer answer(std::string command, const std::string& input);

} // namespace refraster::test
