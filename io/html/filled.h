#pragma once
// A page's template.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// The template with each {{name}} replaced; what replaces it is not looked into. Throws std::invalid_argument for a
/// name that is not among the parts.
std::string filled(std::string_view html, const std::vector<std::pair<std::string_view, std::string>>& parts);

} // namespace refraster
