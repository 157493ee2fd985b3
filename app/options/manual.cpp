#include "app/options/manual.h"

#include <algorithm>
#include <filesystem>

namespace refraster {
namespace {

namespace fs = std::filesystem;

/// The file of the page below the prefix that the program stands in, plain or packed; empty: there is none.
std::string installed_page(const std::string& name) {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  if (none) return {};
  const fs::path pages = program.parent_path().parent_path() / "share/man/man1";
  for (const char* const ending : {".1", ".1.gz"})
    if (fs::path file = pages / (name + ending); fs::is_regular_file(file, none)) return file;
  return {};
}

} // namespace

std::string page_name(const CommandPath& path) {
  std::string name = full_name(path);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string manual_note(const CommandPath& path) {
  const std::string name = page_name(path), file = installed_page(name);
  if (!file.empty()) return "Page of the manual: `man " + name + "`, " + file;
  const std::string command = place_name(path);
  return "Page of the manual: `refraster list man-page " + command + (command.empty() ? "" : " ") + "| man -l -`";
}

} // namespace refraster
