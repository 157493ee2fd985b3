#include "app/output.h"

#include "io/atomic_file.h"
#include "io/input_error.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <unistd.h>

namespace refraster {

namespace fs = std::filesystem;

void check_writable(const std::string& path) {
  if (path == standard_output) return;
  std::error_code ignored;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  if (fs::is_directory(path, ignored)) throw OutputError(path, "it is a folder");
  if (!fs::exists(folder, ignored)) throw OutputError(path, "there is no folder " + folder.string());
  if (!fs::is_directory(folder, ignored)) throw OutputError(path, folder.string() + " is not a folder");
  // The file itself is replaced, so only the folder's permission counts.
  if (access(folder.c_str(), W_OK | X_OK) != 0) throw OutputError(path, std::strerror(errno));
}

void write_text(const std::string& path, const std::string& text) {
  if (path == standard_output) std::cout << text;
  else write_atomically(path, text);
}

std::string stem(const std::string& path) {
  return fs::path(path).stem().string();
}

} // namespace refraster
