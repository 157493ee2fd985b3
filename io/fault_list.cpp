#include "io/fault_list.h"

#include <algorithm>

namespace refraster {

void FaultList::add(const InputError& error) {
  for (const InputFault& fault : error.faults()) add(fault);
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
  if (count_ > kept) {
    InputFault rest;
    rest.file = faults_.back().file;
    rest.found = std::to_string(count_ - kept) + " more faults";
    list.push_back(std::move(rest));
  }
  throw InputError(std::move(list));
}

} // namespace refraster
