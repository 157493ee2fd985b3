#pragma once
// The files of the repository as text, for tests that read them all.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace refraster::test {

struct SourceFile {
  std::string name; // from the root of the repository
  std::string text;
};

/// Files of all layers, tests, docs, scripts and cmake whose names end so, and of the root itself, sorted.
std::vector<SourceFile> source_files(const std::vector<std::string>& endings);

/// Without line ends.
std::vector<std::string_view> lines_of(std::string_view text);

/// Characters of UTF-8.
std::size_t columns(std::string_view line);

} // namespace refraster::test
