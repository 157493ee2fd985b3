#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace refraster {

inline constexpr std::size_t sha256_bytes = 32;

/// FIPS 180-4, part by part.
class Sha256 {
public:
  Sha256();
  ~Sha256();
  void add(const void* bytes, std::size_t size_bytes);
  /// Of everything added. To be asked once.
  std::array<unsigned char, sha256_bytes> result();

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// 64 hexadecimal digits.
std::string in_hexadecimal(const std::array<unsigned char, sha256_bytes>& digest);

/// The same, of a file's bytes and of a text's. Throws InputError.
std::string file_sha256(const std::string& path);
std::string text_sha256(std::string_view text);

} // namespace refraster
