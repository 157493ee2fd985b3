#include "app/turntable/frame_names.h"

namespace refraster {

std::optional<FrameNames> FrameNames::of(std::string_view pattern) {
  const std::size_t part = pattern.rfind('/') == std::string_view::npos ? 0 : pattern.rfind('/') + 1;
  const std::size_t begin = pattern.find('#');
  if (begin == std::string_view::npos || begin < part) return std::nullopt;
  const std::size_t end = std::min(pattern.find_first_not_of('#', begin), pattern.size());
  if (pattern.find('#', end) != std::string_view::npos) return std::nullopt;
  FrameNames names;
  names.before_ = pattern.substr(0, begin);
  names.after_ = pattern.substr(end);
  names.digits_ = end - begin;
  return names;
}

std::string FrameNames::name(std::size_t i) const {
  std::string number = std::to_string(i + 1);
  if (number.size() < digits_) number.insert(0, digits_ - number.size(), '0');
  return before_ + number + after_;
}

std::string FrameNames::report_name() const {
  std::string stem = before_;
  while (!stem.empty() && (stem.back() == '_' || stem.back() == '-' || stem.back() == '.' || stem.back() == ' '))
    stem.pop_back();
  if (stem.empty() || stem.back() == '/') stem += "turntable";
  return stem + ".json";
}

} // namespace refraster
