#include "io/input_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace refraster {
namespace fs = std::filesystem;

std::optional<InputFault> file_fault(const std::string& path, std::string_view expected, std::uint64_t limit_bytes) {
  const auto fault = [&](std::string found, std::string_view wanted) {
    InputFault result;
    result.file = path;
    result.found = std::move(found);
    result.expected = wanted;
    return result;
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return fault("no such file", expected);
  if (error) return fault(error.message(), expected);
  if (fs::is_directory(status)) return fault("a folder", expected);
  if (!fs::is_regular_file(status)) return fault("a device or pipe", expected);
  if (access(path.c_str(), R_OK) != 0) return fault("a file that may not be read", expected);
  const std::uintmax_t size_bytes = fs::file_size(path, error);
  if (error) return fault(error.message(), expected);
  if (size_bytes == 0) return fault("an empty file", expected);
  if (size_bytes > limit_bytes)
    return fault(std::to_string(size_bytes) + " bytes", "at most " + std::to_string(limit_bytes) + " bytes");
  return {};
}

std::string read_file(const std::string& path, std::string_view expected, std::uint64_t limit_bytes) {
  if (auto fault = file_fault(path, expected, limit_bytes)) throw InputError(std::move(*fault));
  std::string bytes(static_cast<std::size_t>(fs::file_size(path)), '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    InputFault fault;
    fault.file = path;
    fault.found = "a file that ends after " + std::to_string(stream.gcount()) + " bytes while it is read";
    fault.expected = std::to_string(bytes.size()) + " bytes";
    throw InputError(std::move(fault));
  }
  return bytes;
}

std::string read_prefix(const std::string& path, std::size_t size_bytes) {
  std::string bytes(size_bytes, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(size_bytes));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

std::uint64_t file_size_bytes(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

std::string extension(const std::string& path) {
  std::string result = fs::path(path).extension().string();
  if (!result.empty()) result.erase(0, 1);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
  });
  return result;
}

} // namespace refraster
