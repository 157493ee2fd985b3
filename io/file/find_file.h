#pragma once
// Files whose paths were written on another machine.

#include <functional>
#include <string>
#include <string_view>

namespace refraster {

/// Whether a path leads to a place within a folder, given by its canonical_path: symbolic links are followed.
bool is_within(const std::string& path, const std::string& canonical_folder);

/// How a file was found; or why not.
enum class FoundBy {
  path,         // as it is written
  slashes,      // with / for '\'
  last_name,    // its last component, in the second folder
  letters,      // without regard to case, by one of those
  none_outside, // there is none that may be looked for: the path leads outside
  none
};

struct FoundFile {
  std::string path; // empty: none
  FoundBy by = FoundBy::none;
};

/// A regular file that `written` may mean, tried in the order of FoundBy: relative to `folder`; its last component in
/// `beside`. Where is_outside(path), nothing is looked for. Letters are those of ASCII; of several names that differ in
/// case only, the first in the order of bytes.
FoundFile find_file(const std::string& folder, const std::string& beside, std::string_view written,
                    const std::function<bool(const std::string&)>& is_outside);

} // namespace refraster
