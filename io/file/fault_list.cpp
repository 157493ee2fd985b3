#include "io/file/fault_list.h"

#include <algorithm>
#include <span>

namespace refraster {

void FaultList::add(const InputError& error) {
  std::span<const InputFault> listed = error.faults();
  if (error.unlisted() > 0) listed = listed.first(listed.size() - 1); // the last one only says how many more there are
  for (const InputFault& fault : listed) add(fault);
  count_ += error.unlisted();
}

void FaultList::add(const FaultList& others) {
  for (const InputFault& fault : others.faults_) add(fault);
  count_ += others.count_ - others.faults_.size();
}

void FaultList::sort_by_place() {
  std::stable_sort(faults_.begin(), faults_.end(), [](const InputFault& a, const InputFault& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
}

void FaultList::throw_if_any() const {
  if (empty()) return;
  std::vector<InputFault> list = faults_;
  if (count_ > max_faults) {
    InputFault rest;
    const std::string& file = faults_.back().file;
    const auto is_there = [&](const InputFault& fault) { return fault.file == file; };
    if (std::all_of(faults_.begin(), faults_.end(), is_there)) rest.file = file;
    rest.found = std::to_string(count_ - max_faults) + " more faults";
    list.push_back(std::move(rest));
  }
  throw InputError(std::move(list), count_ > max_faults ? count_ - max_faults : 0);
}

} // namespace refraster
