#include "suite/actions/input_digests.h"

#include <refraster/notes.h>

#include "io/file/find_file.h"
#include "io/file/input_file.h"
#include "io/file/sha256.h"

#include <algorithm>

#include <sys/stat.h>

namespace refraster::suite {
namespace {

bool is_before(const timespec& a, const timespec& b) {
  return a.tv_sec < b.tv_sec || (a.tv_sec == b.tv_sec && a.tv_nsec < b.tv_nsec);
}

std::string digest_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return {};
  try {
    return file_sha256(path);
  } catch (const InputError&) { // a folder, empty, may not be read
    return "unreadable";
  }
}

} // namespace

FileTime file_time_now() {
  FileTime now;
  clock_gettime(CLOCK_REALTIME_COARSE, &now.time);
  return now;
}

std::vector<InputDigest> digests_since(const std::vector<std::string>& paths, const std::string& except,
                                       const FileTime& started) {
  const std::string folder = except.empty() ? std::string() : canonical_path(except);
  std::vector<InputDigest> digests;
  for (const std::string& path : paths) {
    if (!folder.empty() && is_within(path, folder)) continue;
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !is_before(status.st_mtim, started.time)) return {};
    digests.push_back({path, digest_of(path)});
  }
  return digests;
}

const std::string& CurrentDigests::of(const std::string& path) {
  const auto [place, is_new] = known_.try_emplace(path);
  if (is_new) place->second = digest_of(path);
  return place->second;
}

bool CurrentDigests::are_current(const std::vector<InputDigest>& inputs) {
  return !inputs.empty() && std::all_of(inputs.begin(), inputs.end(),
                                        [&](const InputDigest& input) { return of(input.path) == input.sha256; });
}

} // namespace refraster::suite
