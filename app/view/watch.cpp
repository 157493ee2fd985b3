#include "app/view/watch.h"

#include <sys/stat.h>

namespace refraster {

FileWatch::Mark FileWatch::mark_of(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return {};
  return {true,
          status.st_dev,
          status.st_ino,
          static_cast<std::uint64_t>(status.st_size),
          status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

void FileWatch::set(const std::vector<std::string>& paths) {
  std::map<std::string, Mark> files;
  for (const std::string& path : paths) {
    const auto known = files_.find(path);
    files[path] = known != files_.end() ? known->second : mark_of(path);
  }
  files_ = std::move(files);
}

bool FileWatch::has_changed(double now_seconds) {
  for (auto& [path, mark] : files_) {
    const Mark now = mark_of(path);
    if (now == mark) continue;
    mark = now, pending_ = true, last_change_seconds_ = now_seconds;
  }
  if (!pending_ || now_seconds - last_change_seconds_ < quiet_seconds) return false;
  pending_ = false;
  return true;
}

} // namespace refraster
