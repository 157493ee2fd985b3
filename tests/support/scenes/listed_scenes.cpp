#include "tests/support/scenes/listed_scenes.h"

#include <refraster/files.h>

#include <algorithm>
#include <filesystem>

namespace refraster {

static const std::filesystem::path scenes = std::filesystem::path(REFRASTER_SOURCE_DIR) / "scenes";

std::vector<std::string> listed_scenes() {
  std::vector<std::string> paths = {scenes / "lecture" / "config.json"};
  for (const auto& entry : std::filesystem::directory_iterator(scenes / "gallery"))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<std::string> quick_scenes() {
  const std::filesystem::path gallery = scenes / "gallery";
  return {scenes / "lecture" / "config.json", gallery / "extreme.json", gallery / "grazing.json",
          gallery / "still_life.json"};
}

const Scene& listed_scene(const std::string& path) {
  static std::string cached_path;
  static Scene cached;
  if (path != cached_path) {
    cached = read_scene(path);
    cached_path = path;
  }
  return cached;
}

} // namespace refraster
