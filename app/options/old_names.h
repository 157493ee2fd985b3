#pragma once
// Words of the command line that had another name in an earlier version: nobody can guess the new one. The only place
// of the code base that may use the old ones.

#include <string_view>

namespace refraster {

struct OldName {
  std::string_view old_name, name; // of an option, with its dashes; or of a command
};

inline constexpr OldName old_names[] = {
    {"--rung", "--precision"}, {"--rungs", "--precisions"}, {"rungs", "precisions"}, {"merl", "brdf"}};

} // namespace refraster
