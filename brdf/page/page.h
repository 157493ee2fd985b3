#pragma once
// A page to look at a reflectance, or at two.

#include "brdf/page/charts.h"

#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// What a page says beside its pictures.
struct BrdfPage {
  ShownBrdfs shown;
  std::string title;                                           // "brdf plot brass.binary"
  std::vector<std::pair<std::string, std::string>> facts = {}; // a line each, above the pictures
  std::string comparison = {};                                 // text in equal letters, below them; may be empty
};

/// The facts of one reflectance: what it is, its albedo, what no surface does.
std::vector<std::pair<std::string, std::string>> page_facts(const Brdf& brdf, const std::string& name);

/// One HTML document that needs nothing else: no network, no script. On light and on dark paper.
std::string brdf_page_html(const BrdfPage& page);

} // namespace refraster
