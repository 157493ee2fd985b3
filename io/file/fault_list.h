#pragma once
// Faults are collected while a file is read, so that a user sees all of them at once.

#include <refraster/notes.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// The faults of one input. Keeps the first 100 and counts the rest: a million broken lines need no million messages.
class FaultList {
public:
  /// `make()` gives the fault; it is called only for those kept.
  template <class Make>
  void add_from(Make&& make) {
    if (++count_ <= max_faults) faults_.push_back(std::forward<Make>(make)());
  }
  void add(InputFault fault) {
    add_from([&] { return std::move(fault); });
  }
  /// Takes over what another reader threw.
  void add(const InputError& error);

  void add(const FaultList& others);

  /// Into the order of the file.
  void sort_by_place();

  bool empty() const { return count_ == 0; }
  /// Throws InputError if there is any fault: those kept, then one that says how many more there are.
  void throw_if_any() const;

private:
  static constexpr std::size_t max_faults = 100;
  std::vector<InputFault> faults_;
  std::size_t count_ = 0;
};

} // namespace refraster
