#include "tests/unit/app/shell.h"

#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include <sys/wait.h>

namespace refraster::test {

Answer answer(std::string command, const std::string& input) {
  const TemporaryFolder folder;
  const std::string in = folder.path / "input", out = folder.path / "output";
  std::ofstream(in) << input;
  if (const std::size_t place = command.find("FILE"); place != std::string::npos) command.replace(place, 4, in);
  const int status = std::system(("(" + command + ") </dev/null >" + out + " 2>&1").c_str());
  std::ifstream file(out);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, {std::istreambuf_iterator<char>(file), {}}};
}

bool installed(const std::string& program) {
  if (answer("command -v " + program, "").exit_code == 0) return true;
  MESSAGE("skipped: there is no " << program);
  return false;
}

} // namespace refraster::test
