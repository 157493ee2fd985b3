#pragma once
// How much memory may be taken.

#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <string_view>

namespace refraster {

/// More memory is needed than a MemoryBudget allows. what() says what for.
class OutOfMemory : public std::bad_alloc {
public:
  explicit OutOfMemory(std::string text) : text_(std::make_shared<const std::string>(std::move(text))) {}
  const char* what() const noexcept override { return text_->c_str(); }

private:
  std::shared_ptr<const std::string> text_; // so that copies cannot fail
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
  std::function<std::uint64_t()> in_use_bytes_; // none: no limit
};

} // namespace refraster
