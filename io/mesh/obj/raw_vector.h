#pragma once
// Lists of millions of numbers, written by several threads.

#include <memory>
#include <utility>
#include <vector>

namespace refraster {

/// Elements that resize() adds are not cleared: who asks for them writes each before it is read, and so each page is
/// first touched by the thread that works on it.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  UninitializedAllocator() = default;
  template <class U>
  UninitializedAllocator(const UninitializedAllocator<U>&) {}

  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using RawVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace refraster
