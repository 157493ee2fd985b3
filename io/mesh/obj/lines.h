#pragma once
// The text of an OBJ file, with its lines as statements have them.

#include "io/file/text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// '\r' alone ends a line. A backslash at the end of a line that is no comment continues the line: both become blanks,
/// and where the line ended is remembered for messages. A byte order mark becomes blanks.
class ObjLines {
public:
  explicit ObjLines(std::string text);

  std::string_view text() const { return text_; }

  /// Where chunks of about so many bytes begin, each with a line; and the end of the text.
  std::vector<std::size_t> chunks_of(std::size_t bytes) const;

  /// A part of the text as the user sees it.
  TextPlace place_of(std::string_view part);
  /// How many lines continue one another before this part of the text.
  std::size_t joints_before(std::string_view part) const;

private:
  void blank(std::size_t begin, std::size_t end);

  std::string text_; // characters change, the size does not: views into it stay valid
  std::vector<std::size_t> joints_;
};

} // namespace refraster
