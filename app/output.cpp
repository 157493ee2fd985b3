#include "app/output.h"

#include "io/atomic_file.h"
#include "io/image_file.h"
#include "io/input_error.h"
#include "io/input_file.h"

#include <algorithm>
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
  else write_file(path, text);
}

std::optional<ImageFormat> image_format(const std::string& path) {
  const std::string ending = extension(path);
  if (ending == "png") return ImageFormat::png;
  if (ending == "hdr") return ImageFormat::hdr;
  if (ending == "pfm") return ImageFormat::pfm;
  if (ending == "exr") return ImageFormat::exr;
  return std::nullopt;
}

void write_values(const std::string& path, const Image<float>& image) {
  if (image.channels != 2) return write_float_image(path, image);
  if (image_format(path) == ImageFormat::exr) return write_float_image(path, image, {"U", "V"});
  Image<float> padded(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.at(x, y), 2, padded.at(x, y));
  write_float_image(path, padded);
}

std::string stem(const std::string& path) {
  return fs::path(path).stem().string();
}

} // namespace refraster
