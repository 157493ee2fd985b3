#include "io/file/sha256.h"

#include "io/file/input_file.h"

#include <nettle/sha2.h>
#include <nettle/version.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace refraster {

struct Sha256::State {
  sha256_ctx context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
  sha256_init(&state_->context);
}
Sha256::~Sha256() = default;

void Sha256::add(const void* bytes, std::size_t size_bytes) {
  sha256_update(&state_->context, size_bytes, static_cast<const std::uint8_t*>(bytes));
}

std::array<unsigned char, sha256_bytes> Sha256::result() {
  std::array<unsigned char, sha256_bytes> digest{};
#if NETTLE_VERSION_MAJOR >= 4
  sha256_digest(&state_->context, digest.data());
#else
  sha256_digest(&state_->context, digest.size(), digest.data());
#endif
  return digest;
}

std::string in_hexadecimal(const std::array<unsigned char, sha256_bytes>& digest) {
  std::string text;
  for (const unsigned char byte : digest) text += {"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]};
  return text;
}

std::string file_sha256(const std::string& path) {
  constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max();
  const InputFile file(path, "a file", any_size);
  std::vector<char> part(std::size_t{1} << 18); // stays in the second level of cache
  Sha256 digest;
  for (std::uint64_t at = 0; at < file.size_bytes(); at += part.size()) {
    const std::size_t bytes = std::min<std::uint64_t>(part.size(), file.size_bytes() - at);
    file.read(at, part.data(), bytes);
    digest.add(part.data(), bytes);
  }
  return in_hexadecimal(digest.result());
}

std::string text_sha256(std::string_view text) {
  Sha256 digest;
  digest.add(text.data(), text.size());
  return in_hexadecimal(digest.result());
}

} // namespace refraster
