#include "io/trace/file_trace.h"

#include <atomic>
#include <mutex>
#include <set>

namespace refraster {
namespace {

// Of the process: what reads files is far below whoever wants to know of it, and meshes are read by several threads.
std::atomic<FileTrace*> living = nullptr;
std::mutex paths_mutex;
std::set<std::string, std::less<>> traced;

} // namespace

FileTrace::FileTrace() {
  const std::lock_guard lock(paths_mutex);
  traced.clear();
  living = this;
}

FileTrace::~FileTrace() {
  living = nullptr;
}

std::vector<std::string> FileTrace::paths() const {
  const std::lock_guard lock(paths_mutex);
  return {traced.begin(), traced.end()};
}

void trace_file(std::string_view path) {
  if (living.load(std::memory_order_relaxed) == nullptr) return;
  const std::lock_guard lock(paths_mutex);
  if (!traced.contains(path)) traced.emplace(path);
}

} // namespace refraster
