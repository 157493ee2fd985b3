// fuzz_replay FOLDER...: runs every file of FOLDER/<target>/ through its target, without a fuzzer: seeds, and inputs
// that once were faults. The last folder's come first, and each target has a process of its own, as it has under the
// fuzzer: what a library sets up when it is first needed counts as memory of the input that needed it.

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

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

/// Prints how many inputs there were; whether all went well, and there was any.
bool replay_all(const std::vector<fs::path>& folders, const Target& target) {
  std::size_t files = 0;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    files += replay(*folder / target.name, target);
  std::printf("%-12.*s %6zu inputs\n", static_cast<int>(target.name.size()), target.name.data(), files);
  if (files == 0) std::printf("a target without inputs tests nothing\n");
  std::fflush(stdout);
  return files > 0;
}

/// In a process of its own.
bool replayed(const std::vector<fs::path>& folders, const Target& target) {
  const pid_t child = fork();
  if (child == 0) std::exit(replay_all(folders, target) ? 0 : 1);
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

} // namespace

int main(int count, char** words) {
  const std::vector<fs::path> folders(words + 1, words + count);
  for (const Target& target : targets)
    if (!replayed(folders, target)) return 1;
  std::printf("every law holds; memory is %s\n", memory_is_counted() ? "counted" : "not counted");
}
