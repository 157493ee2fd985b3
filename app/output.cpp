#include "app/output.h"

#include <refraster/files.h>
#include <refraster/notes.h>

#include "app/interrupt.h"
#include "app/usage_error.h"
#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/mesh/mesh_cache.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace refraster {

namespace fs = std::filesystem;

void check_writable(const std::string& path) {
  if (path == standard_output) return;
  std::error_code ignored;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  if (fs::is_directory(path, ignored)) throw OutputError(path, "it is a folder");
  if (!fs::exists(folder, ignored)) throw OutputError(path, "there is no folder " + folder.string());
  if (!fs::is_directory(folder, ignored)) throw OutputError(path, folder.string() + " is not a folder");
  // A device or pipe is opened once, when it is written: what reads from it would take a trial for the end.
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return;
  clean_when_interrupted(fs::path(canonical_path(path)).parent_path());
  AtomicFile trial(path); // leaves nothing: permissions alone do not say it, for root and for /proc
}

namespace {
/// By whatever names they are called; also of files that are not there yet.
bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  if (fs::exists(a, error) && !fs::is_regular_file(a, error)) return false;
  return fs::equivalent(a, b, error) || canonical_path(a) == canonical_path(b);
}
} // namespace

void check_different(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (same_file(outputs[i], outputs[j]))
        throw UsageError(outputs[i], "would be written twice, expected a file for each output");
    for (const std::string& input : inputs)
      if (same_file(outputs[i], input)) throw UsageError(outputs[i], "would be written over what is read");
  }
}

void prepare_cache(const std::string& folder) {
  if (folder.empty()) return;
  clean_when_interrupted(folder);
  check_cache_folder(folder);
}

void prepare_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) throw OutputError(folder, "it is no folder, and none can be made there");
}

void write_text(const std::string& path, const std::string& text) {
  if (path == standard_output) std::cout << text;
  else write_file(path, text);
}

void check_extension(const std::string& option, const std::string& path, std::initializer_list<ImageContent> contents) {
  if (!format_to_write(path, contents))
    throw UsageError(option, "\"" + path + "\"", "a name ending in " + writable_extensions(contents));
}

void write_values(const std::string& path, const ImageRows<float>& image, std::vector<std::string> channels,
                  const WriteOptions& options) {
  if (image.channels == 2 && channels.empty()) channels = {"U", "V"};
  if (image.channels != 2 || format_to_write(path, {{ImageValues::floats, 2}}))
    return write_rows(path, image, std::move(channels), options);
  const ImageRows<float> padded(image.width, image.height, 3, [&image](int y, std::vector<float>& scratch) {
    std::vector<float> two;
    const float* const from = image.row(y, two);
    scratch.assign(3 * static_cast<std::size_t>(image.width), 0);
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x)
      std::copy_n(from + 2 * x, 2, scratch.data() + 3 * x);
    return static_cast<const float*>(scratch.data());
  });
  write_rows(path, padded, {}, options);
}

std::string stem(const std::string& path) {
  const std::string name = fs::path(path).stem().string();
  return name.empty() || name == "." || name == ".." ? "image" : name; // "": then the scene is what is wrong
}

} // namespace refraster
