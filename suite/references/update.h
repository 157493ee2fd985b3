#pragma once
// New references: made beside the old ones, compared, and put in their place at once.

#include "suite/entry/result.h"
#include "suite/references/references.h"

#include <functional>
#include <string>
#include <vector>

namespace refraster::suite {

/// What an update does to one reference.
enum class Change { added, changed, same };

struct UpdatedReference {
  std::string name;
  Change change = Change::same;
  Reference before, now;
  double max_levels = 0;         // largest difference of two images, where both are of one size
  std::uint64_t pixels_over = 0; // that differ
};

/// Puts what has changed into the folder. All of it counts from one moment on, when refs.json is renamed: until then
/// nothing does, and an update that ends before has changed nothing. Images wait in the folder under waiting_name().
/// Throws OutputError.
void store_references(const References& old, const std::vector<UpdatedReference>& updated);

/// Removes images that wait in the folder and that no record names: of updates that were ended.
void remove_waiting(const std::string& folder, const std::map<std::string, Reference>& all);

/// What `suite update` prints: a line for each that changes, and one for all.
std::string update_text(const std::vector<UpdatedReference>& updated, const std::string& folder);

} // namespace refraster::suite
