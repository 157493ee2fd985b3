#pragma once
// Whether the files that a result depends on are as they were.

#include "suite/entry/result.h"

#include <map>
#include <string>
#include <vector>

#include <ctime>

namespace refraster::suite {

/// By the clock that file systems of this machine stamp files with.
struct FileTime {
  timespec time{};
};
FileTime file_time_now();

/// Of each path its digest; but for those in the folder `except`, which are results. Nothing at all if a file was
/// changed at or after `started`, for then it is not known what was read. A file system that another machine's clock
/// stamps may not show that.
std::vector<InputDigest> digests_since(const std::vector<std::string>& paths, const std::string& except,
                                       const FileTime& started);

/// Asks each file once, whichever results depend on it.
class CurrentDigests {
public:
  /// "" for a file that is not there.
  const std::string& of(const std::string& path);
  /// Whether all of them are as they were. False for none: nothing is known then.
  bool are_current(const std::vector<InputDigest>& inputs);

private:
  std::map<std::string, std::string> known_;
};

} // namespace refraster::suite
