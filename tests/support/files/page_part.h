#pragma once
// What a page of the documentation has between two comments, written there by a program.

#include "io/file/input_file.h"

#include <doctest/doctest.h>

#include <string>

namespace refraster::test {

/// Between `<!-- mark -->` and the next `<!-- end -->`, whole lines. `page`: from the root of the repository.
inline std::string page_part(const std::string& page, const std::string& mark) {
  const std::string text = read_file(REFRASTER_SOURCE_DIR "/" + page, "the documentation", 1 << 20);
  const std::string begin = "<!-- " + mark + " -->\n", end = "<!-- end -->\n";
  const std::size_t at = text.find(begin);
  REQUIRE(at != std::string::npos);
  const std::size_t from = at + begin.size(), to = text.find(end, from);
  REQUIRE(to != std::string::npos);
  return text.substr(from, to - from);
}

} // namespace refraster::test
