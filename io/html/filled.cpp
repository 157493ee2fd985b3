#include "io/html/filled.h"

#include <algorithm>
#include <stdexcept>

namespace refraster {

std::string filled(std::string_view html, const std::vector<std::pair<std::string_view, std::string>>& parts) {
  std::string text;
  while (true) {
    const std::size_t begin = html.find("{{"), end = html.find("}}", begin);
    text += html.substr(0, begin);
    if (begin == std::string_view::npos) return text;
    const std::string_view name = html.substr(begin + 2, end - begin - 2);
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& one) { return one.first == name; });
    if (part == parts.end()) throw std::invalid_argument("found a template with an unknown part " + std::string(name));
    text += part->second;
    html.remove_prefix(end + 2);
  }
}

} // namespace refraster
