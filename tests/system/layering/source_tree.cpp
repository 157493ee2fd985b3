#include "tests/system/layering/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace refraster::test {

namespace fs = std::filesystem;

std::vector<SourceFile> source_files(const std::vector<std::string>& endings) {
  const fs::path root = REFRASTER_SOURCE_DIR;
  std::vector<fs::path> paths;
  const auto add = [&](const fs::path& path) {
    const std::string name = path.filename().string();
    if (fs::is_regular_file(path) &&
        std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) { return name.ends_with(ending); }))
      paths.push_back(path);
  };
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) add(entry.path());
  for (const char* const folder : {"include", "math", "shading", "scene", "raster", "io", "gl", "verify", "scenes",
                                   "brdf", "bench", "suite", "app", "python", "tests", "docs", "cmake", "scripts"})
    if (fs::is_directory(root / folder))
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) add(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<SourceFile> files;
  for (const fs::path& path : paths) {
    std::ifstream file(path);
    files.push_back({path.lexically_relative(root).string(), {std::istreambuf_iterator<char>(file), {}}});
  }
  return files;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::size_t columns(std::string_view line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

} // namespace refraster::test
