#include "app/parts/part_list.h"

namespace refraster {

void PartList::add(const std::string& path, const Shard& shard, FaultList& faults) {
  if (paths_.empty()) of_ = shard.of;
  const std::string text = shard_text(shard);
  if (shard.of != of_)
    return faults.add(
        {path, 0, 0, "shard", text, "one of " + std::to_string(of_) + ", as " + paths_.begin()->second + " is"});
  const auto [there, is_new] = paths_.try_emplace(shard.part, path);
  if (!is_new)
    faults.add({path, 0, 0, "shard", text + " a second time", "each part once: " + there->second + " is it too"});
}

void PartList::check_complete(FaultList& faults) const {
  if (paths_.empty()) return;
  for (int part = 1; part <= of_; ++part)
    if (!paths_.contains(part))
      faults.add({paths_.begin()->second, 0, 0, "shard", "no part " + shard_text({part, of_}) + " beside it",
                  "all " + std::to_string(of_) + " parts"});
}

} // namespace refraster
