#include "tests/long/fuzz/targets.h"

#include "tests/support/files/malformed_inputs.h"

#include <cstdio>
#include <cstdlib>

namespace refraster::fuzz {

void require(bool holds, std::string_view law) {
  if (holds) return;
  std::fprintf(stderr, "a law is broken: %.*s\n", static_cast<int>(law.size()), law.data());
  std::abort();
}

void require_none(const std::string& fault, std::string_view of) {
  require(fault.empty(), std::string(of) + ": " + fault);
}

std::string file_of(std::string_view name, Bytes bytes) {
  static const test::TemporaryFolder folder;
  std::string path = folder / std::string(name);
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  require(file && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fclose(file) == 0,
          "the file can be written");
  return path;
}

} // namespace refraster::fuzz
