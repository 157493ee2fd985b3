#include "io/mesh/obj/lines.h"

#include <algorithm>
#include <utility>

namespace refraster {

ObjLines::ObjLines(std::string text) : text_(std::move(text)) {
  if (text_.starts_with("\xef\xbb\xbf")) blank(0, 3);
  for (std::size_t at = text_.find('\r'); at != std::string::npos; at = text_.find('\r', at + 1))
    if (at + 1 == text_.size() || text_[at + 1] != '\n') text_[at] = '\n';
  // Each character is looked at once, however many lines are joined to one.
  bool in_comment = false;
  std::size_t seen = 0;
  for (std::size_t at = text_.find('\\'); at != std::string::npos; at = text_.find('\\', at + 1)) {
    const std::size_t end = text_.find_first_not_of('\r', at + 1);
    if (end == std::string::npos || text_[end] != '\n') continue;
    for (; seen < at; ++seen) in_comment = text_[seen] != '\n' && (in_comment || text_[seen] == '#');
    if (in_comment) continue;
    blank(at, end + 1);
    joints_.push_back(end);
    seen = end + 1;
  }
}

void ObjLines::blank(std::size_t begin, std::size_t end) {
  std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.begin() + static_cast<std::ptrdiff_t>(end), ' ');
}

std::vector<std::size_t> ObjLines::chunks_of(std::size_t bytes) const {
  std::vector<std::size_t> begin{0};
  while (text_.size() - begin.back() > bytes) {
    const std::size_t end = text_.find('\n', begin.back() + bytes);
    if (end == std::string::npos || end + 1 == text_.size()) break;
    begin.push_back(end + 1);
  }
  begin.push_back(text_.size());
  return begin;
}

TextPlace ObjLines::place_of(std::string_view part) {
  for (const std::size_t joint : joints_) text_[joint] = '\n'; // for a moment
  const TextPlace place = place_in(text_, static_cast<std::size_t>(part.data() - text_.data()));
  for (const std::size_t joint : joints_) text_[joint] = ' ';
  return place;
}

std::size_t ObjLines::joints_before(std::string_view part) const {
  const auto offset = static_cast<std::size_t>(part.data() - text_.data());
  return static_cast<std::size_t>(std::lower_bound(joints_.begin(), joints_.end(), offset) - joints_.begin());
}

} // namespace refraster
