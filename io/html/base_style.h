#pragma once
// What all pages look like.

#include <string_view>

namespace refraster {

/// io/html/base.css: colours in light and dark, letters, tables.
extern const std::string_view base_style;

} // namespace refraster
