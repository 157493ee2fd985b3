#include "app/options/shared_options.h"

#include "app/memory_limit.h"

namespace refraster {

Option scene_argument(std::string& path) {
  return argument("SCENE", path, "scene file; docs/scene-format.md");
}

Option size_option(Size& size) {
  return parsed_option("--size", "WxH", size, size_from, "WIDTHxHEIGHT, each 1 to " + std::to_string(largest_side),
                       "pixels of the image")
      .by_default("1280x720");
}

Option outside_option(Outside& outside) {
  return flag(
      "--allow-outside", [&outside] { outside = Outside::allowed; },
      "let the scene name files outside its own folder: only for scenes that you trust");
}

Option cache_option(std::string& folder) {
  return folder_option("--cache", folder,
                       "folder, made if need be, where the triangles of large OBJ files are cached, so that they are "
                       "read faster the next time");
}

Option memory_option(std::uint64_t& bytes) {
  return parsed_option("--max-memory", "SIZE", bytes, memory_from, "a size of at least 64M, as 512M or 2G",
                       "most memory that the run may take; what needs more is refused (exit code 3)");
}

Option strict_option(Diagnostics& diagnostics) {
  return flag(
      "--strict", [&diagnostics] { diagnostics.file_notes = FileNotes::refused; },
      "a note on an input file is an error: exit code 3");
}

Option quiet_option(Diagnostics& diagnostics, const std::string& meaning) {
  return flag(
      "-q,--quiet", [&diagnostics] { diagnostics.verbosity = Verbosity::quiet; }, meaning);
}

} // namespace refraster
