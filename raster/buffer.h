#pragma once
// Memory for millions of small things that are all written before they are read.

#include "math/large_memory.h"

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace refraster {

/// An array that is not cleared when it is made: a stage fills it in parallel, and so each page is first touched by
/// the thread that works on it. Memory is kept when it shrinks, so that the next frame finds it warm.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
  /// What it held is lost.
  void resize_uninitialized(std::size_t size) {
    if (size > capacity_) {
      size_ = capacity_ = 0; // should there be no memory
      memory_.reset();
      memory_.reset(static_cast<T*>(::operator new(size * sizeof(T), alignment)));
      advise_large_pages(memory_.get(), size * sizeof(T));
      capacity_ = size;
    }
    size_ = size;
  }
  std::size_t size() const { return size_; }
  T* data() { return memory_.get(); }
  const T* data() const { return memory_.get(); }
  T& operator[](std::size_t i) { return memory_.get()[i]; }
  const T& operator[](std::size_t i) const { return memory_.get()[i]; }

private:
  struct Free {
    void operator()(T* memory) const { ::operator delete(memory, alignment); }
  };
  // A line of the cache, and the widest register: of those that are stored one after the other none lies across two.
  static constexpr std::align_val_t alignment{64};

  std::unique_ptr<T, Free> memory_;
  std::size_t size_ = 0, capacity_ = 0;
};

} // namespace refraster
