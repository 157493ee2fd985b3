#pragma once
// The ladder as Markdown.

#include "bench/merl_ladder/measure.h"

namespace refraster::ladder {

std::string markdown(const std::vector<Material>& materials, const std::vector<Cost>& costs, int pairs);

/// The page with what stands between `<!-- refraster_merl_ladder -->` and `<!-- end -->` replaced.
std::string updated_page(std::string page, const std::string& ladder);

} // namespace refraster::ladder
