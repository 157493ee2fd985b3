// fuzz_replay FOLDER...: runs every file of FOLDER/<target>/ through its target, without a fuzzer: seeds, and inputs
// that once were faults.

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace {
namespace fs = std::filesystem;
using namespace refraster::fuzz;

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t replay(const fs::path& folder, const Target& target) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::fprintf(stderr, "%s\n", file.c_str()); // the last line names the culprit, should this be the end
    target.run(bytes_of(file));
  }
  return files.size();
}

} // namespace

int main(int count, char** words) {
  std::size_t all = 0;
  for (const Target& target : targets) {
    std::size_t files = 0;
    for (int i = 1; i < count; ++i) files += replay(fs::path(words[i]) / target.name, target);
    std::printf("%-12.*s %6zu inputs\n", static_cast<int>(target.name.size()), target.name.data(), files);
    all += files;
    if (files == 0) {
      std::printf("a target without inputs tests nothing\n");
      return 1;
    }
  }
  std::printf("%zu inputs, every law holds; memory is %s\n", all, memory_is_counted() ? "counted" : "not counted");
}
