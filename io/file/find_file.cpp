#include "io/file/find_file.h"

#include "io/file/input_file.h"
#include "io/trace/file_trace.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace refraster {
namespace {
namespace fs = std::filesystem;

char lower(char c) {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
bool same_letters(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

/// The path with each component as a folder spells it; empty if there is none.
std::string spelled_as_found(const fs::path& folder, const fs::path& path) {
  fs::path at = folder.empty() ? fs::path(".") : folder;
  for (const fs::path& part : path) {
    const std::string name = part.string();
    if (name == "..") return {}; // leads out, as a rule; and then it was written for this folder
    if (name.empty() || name == ".") continue;
    std::error_code error;
    std::string found;
    for (fs::directory_iterator i(at, error), end; !error && i != end; i.increment(error))
      if (const std::string entry = i->path().filename().string(); same_letters(entry, name))
        if (found.empty() || entry < found) found = entry;
    if (found.empty()) return {};
    at /= found;
  }
  return at.string();
}

} // namespace

bool is_within(const std::string& path, const std::string& canonical_folder) {
  const fs::path folder = canonical_folder, real = canonical_path(path);
  return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

FoundFile find_file(const std::string& folder, const std::string& beside, std::string_view written,
                    const std::function<bool(const std::string&)>& is_outside) {
  bool outside = false;
  const auto is_there = [&](const std::string& path) {
    if (path.empty()) return false;
    if (is_outside(path)) {
      outside = true;
      return false;
    }
    trace_file(path);
    std::error_code none; // what cannot be asked is not there
    return fs::is_regular_file(path, none);
  };
  std::string slashed(written);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path last = fs::path(slashed).filename();
  const std::string as_written = (fs::path(folder) / std::string(written)).string();
  if (is_there(as_written)) return {as_written, FoundBy::path};
  if (const std::string path = (fs::path(folder) / slashed).string(); is_there(path)) return {path, FoundBy::slashes};
  if (last.empty()) return {{}, outside ? FoundBy::none_outside : FoundBy::none};
  if (const std::string path = (fs::path(beside) / last).string(); is_there(path)) return {path, FoundBy::last_name};
  if (fs::path(slashed).is_relative())
    if (const std::string path = spelled_as_found(folder, slashed); is_there(path)) return {path, FoundBy::letters};
  if (const std::string path = spelled_as_found(beside, last); is_there(path)) return {path, FoundBy::letters};
  return {{}, outside ? FoundBy::none_outside : FoundBy::none};
}

} // namespace refraster
