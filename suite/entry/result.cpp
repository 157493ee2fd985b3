#include "suite/entry/result.h"

#include <algorithm>
#include <tuple>

namespace refraster::suite {

bool is_worse(const EntryResult& a, const EntryResult& b) {
  // State's order is that of badness.
  return std::tuple(a.state, -a.severity, std::string_view(a.name)) <
         std::tuple(b.state, -b.severity, std::string_view(b.name));
}

int exit_code_of(const std::vector<EntryResult>& results) {
  constexpr int by_gravity[] = {70, 4, 3, 1, 5};
  for (const int code : by_gravity)
    if (std::any_of(results.begin(), results.end(),
                    [&](const EntryResult& result) { return facts_of(result.state).exit_code == code; }))
      return code;
  return 0;
}

} // namespace refraster::suite
