#pragma once
// Files that may change while the window shows what they held.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace refraster {

/// How long nothing may have changed before files are read again: an editor writes a file in several steps, and a tool
/// several files.
inline constexpr double quiet_seconds = 0.3;

/// Looks at names, not at open files: one that is replaced, removed or made is seen as well. Asks the file system when
/// it is asked itself, which costs microseconds a file: notices of the kernel (inotify) do not come from file systems
/// of other machines.
class FileWatch {
public:
  /// From now on these. What was watched before goes on from what was seen of it.
  void set(const std::vector<std::string>& paths);
  /// Whether any has changed since it was last asked for, and then none for quiet_seconds. `now_seconds`: of any clock
  /// that does not go back.
  bool has_changed(double now_seconds);

private:
  /// What tells one state of a file from another.
  struct Mark {
    bool there = false;
    std::uint64_t device = 0, inode = 0, bytes = 0;
    std::int64_t seconds = 0, nanoseconds = 0; // when it was written
    bool operator==(const Mark&) const = default;
  };
  static Mark mark_of(const std::string& path);

  std::map<std::string, Mark> files_;
  bool pending_ = false;
  double last_change_seconds_ = 0;
};

} // namespace refraster
