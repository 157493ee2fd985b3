#pragma once
// How much memory may be taken; and the memory of tables.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// More memory is needed than a MemoryBudget allows. what() says what for.
class OutOfMemory : public std::bad_alloc {
public:
  /// What is needed, for what, and how much there is.
  explicit OutOfMemory(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
  /// The same.
  const char* what() const noexcept override { return text_->c_str(); }

private:
  std::shared_ptr<const std::string> text_; ///< so that copies cannot fail
};

/// Asked before anything large is made: what it is known to need at least must be there. What cannot be foreseen, as
/// the lists of triangles in a frame, is not asked for; who must hold to a limit in every case lets the system
/// see to it as well, and gets std::bad_alloc (app/memory_limit.h).
class MemoryBudget {
public:
  /// Without a limit.
  MemoryBudget() = default;
  /// in_use_bytes: what is taken at the moment it is called, by whatever.
  MemoryBudget(std::uint64_t limit_bytes, std::function<std::uint64_t()> in_use_bytes)
      : limit_bytes_(limit_bytes), in_use_bytes_(std::move(in_use_bytes)) {}

  /// Throws OutOfMemory if there is not so much left. `what` needs it: "the image".
  void need(std::uint64_t bytes, std::string_view what) const {
    if (!in_use_bytes_) return;
    const std::uint64_t used = in_use_bytes_();
    const std::uint64_t left = limit_bytes_ > used ? limit_bytes_ - used : 0;
    if (bytes > left)
      throw OutOfMemory("needs " + megabytes(bytes) + " of memory for " + std::string(what) + ", and of " +
                        megabytes(limit_bytes_) + " only " + megabytes(left) + " are left");
  }

private:
  static std::string megabytes(std::uint64_t bytes) {
    constexpr std::uint64_t mebi = 1 << 20;
    return std::to_string((bytes + mebi - 1) / mebi) + "M";
  }

  std::uint64_t limit_bytes_ = 0;
  std::function<std::uint64_t()> in_use_bytes_; ///< none: no limit
};

/// At least so many bytes, aligned to 16. From 2 MiB on in pages of 2 MiB instead of 4 KiB, where the system has them:
/// a table of 35 MB is there after 17 page faults instead of 8500, which take as long as reading its file does. To be
/// given back with free_memory. Throws std::bad_alloc.
void* allocate_memory(std::size_t bytes);
/// Gives back what allocate_memory gave.
void free_memory(void* memory) noexcept;

/// Asks for the room of four more elements than it is told to: they may be read, whatever is in them, never written.
template <class T>
struct PaddedAllocator {
  using value_type = T;                                 ///< as std::vector asks
  static constexpr std::size_t padding = 4 * sizeof(T); ///< bytes more

  PaddedAllocator() = default;
  /// All are alike.
  template <class U>
  PaddedAllocator(const PaddedAllocator<U>&) {}

  /// Throws std::bad_alloc.
  T* allocate(std::size_t n) {
    constexpr std::size_t most = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()) / sizeof(T) - 4;
    if (n > most) throw std::bad_alloc();
    return static_cast<T*>(allocate_memory(n * sizeof(T) + padding));
  }
  /// What allocate gave.
  void deallocate(T* memory, std::size_t) { free_memory(memory); }
  /// All are alike.
  template <class U>
  bool operator==(const PaddedAllocator<U>&) const {
    return true;
  }
};

/// A std::vector of which a row of four may be loaded from the place of any of its elements: textures and measured
/// tables are read four numbers at a time, wherever one is wanted, the last ones too.
template <class T>
using PaddedVector = std::vector<T, PaddedAllocator<T>>;

} // namespace refraster
