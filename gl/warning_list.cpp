#include "gl/warning_list.h"

#include <algorithm>

namespace refraster {

void WarningList::add(const std::string& object, const std::string& text) {
  auto same = std::find_if(warnings_.begin(), warnings_.end(), [&](const Warning& w) { return w.text == text; });
  if (same == warnings_.end()) same = warnings_.insert(same, {text, {}});
  if (!object.empty()) same->objects.push_back(object);
}

std::vector<std::string> WarningList::lines() const {
  constexpr std::size_t max_names = 3;
  std::vector<std::string> lines;
  for (const auto& [text, objects] : warnings_) {
    std::string names;
    if (objects.size() > max_names) names = objects[0] + " and " + std::to_string(objects.size() - 1) + " more";
    else
      for (const std::string& object : objects) names += (names.empty() ? "" : ", ") + object;
    lines.push_back(names.empty() ? text : names + ": " + text);
  }
  return lines;
}

} // namespace refraster
