#include "tests/support/files/malformed_inputs.h"

#include <fstream>
#include <stdexcept>

#include <stdlib.h>

namespace refraster::test {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "refraster-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

void write_files(const fs::path& folder, const std::vector<TestFile>& files) {
  for (const TestFile& file : files) {
    const fs::path path = folder / file.name;
    if (file.name.ends_with('/')) {
      fs::create_directories(path);
      continue;
    }
    fs::remove(path); // ext4 waits for its disk where a file is cut to nothing and written again
    std::ofstream(path, std::ios::binary) << file.content;
    if (file.size_bytes > file.content.size()) fs::resize_file(path, file.size_bytes);
    if (file.patch.empty()) continue;
    std::fstream patched(path, std::ios::binary | std::ios::in | std::ios::out);
    patched.seekp(static_cast<std::streamoff>(file.patch_at));
    patched << file.patch;
  }
}

std::string scene_with(const std::string& from, const std::string& to) {
  std::string text = R"({"scene": {
  "camera": {"position": "0 0 6"},
  "point_lights": [{"position": "1 2 3", "radiance": "1 1 1", "constant": 1, "linear": 0, "quadratic": 0}],
  "direction_lights": [{"direction": "0 0 -1", "radiance": "1 1 1"}],
  "objects": [{
    "mesh": {"sphere": {"segments": 8, "rings": 4}},
    "fragment_function": "phong",
    "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
    "material": {"ka": "0 0 0", "kd": "0.5 0.5 0.5", "ks": "1 1 1", "glossiness": 8}
  }]
}}
)";
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
    throw std::logic_error("not there exactly once: " + from);
  return text.replace(at, from.size(), to);
}

} // namespace refraster::test
