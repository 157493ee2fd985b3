#pragma once
// The page of a run: a wall of thumbnails.

#include "suite/results/summary.h"

#include <string>

namespace refraster::suite {

/// One file that needs nothing but, for what a click leads to, the pages and images beside it. The results are in the
/// order in which they are shown. The same results give the same bytes. Without JavaScript all is there, but no
/// filters.
std::string wall_html(const RunResults& results);

/// suite/results/page: the page's frame, with {{name}} where its parts go, its style, and its script.
struct WallText {
  std::string_view html, style, script;
};
extern const WallText wall_text;

} // namespace refraster::suite
