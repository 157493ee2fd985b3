#pragma once
// The story for programs.

#include "verify/explain/pixel_story.h"

#include <string>

namespace refraster {

/// Every number in full, members always in the same order. docs/reports.md describes them.
std::string story_json(const PixelStory& story);

} // namespace refraster
