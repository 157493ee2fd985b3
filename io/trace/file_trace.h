#pragma once
// Which files a result depends on.

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// While it lives, every file that this process looks for is written down: those that are read, and those that are not
/// there, whose appearing would change what is read. One at a time; files may be looked for from any thread.
class FileTrace {
public:
  FileTrace();
  ~FileTrace();
  FileTrace(const FileTrace&) = delete;
  FileTrace& operator=(const FileTrace&) = delete;

  /// As they were named, each once, sorted by bytes.
  std::vector<std::string> paths() const;
};

/// Writes a path down in the trace that lives; nothing without one. For whoever opens a file, or asks whether it is
/// there.
void trace_file(std::string_view path);

} // namespace refraster
