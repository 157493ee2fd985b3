#pragma once
// Which parts of how many are there.

#include "io/file/fault_list.h"
#include "io/parts/shard.h"

#include <map>
#include <string>

namespace refraster {

/// Collects the parts of one whole, and says what is wrong with them together.
class PartList {
public:
  /// A fault if it is one of another number of parts than the first, or there already.
  void add(const std::string& path, const Shard& shard, FaultList& faults);
  /// A fault for each that is missing; none where nothing was added, which has been said then.
  void check_complete(FaultList& faults) const;

private:
  std::map<int, std::string> paths_; // by number
  int of_ = 0;
};

} // namespace refraster
