#pragma once
// The story for people: plain text to be read beside a shader, in the order of the pipeline, 80 columns wide.

#include "verify/explain/pixel_story.h"

#include <cstddef>
#include <string>

namespace refraster {

/// How much of the story is told.
struct StoryTextOptions {
  std::size_t lights = 3; // described in full, those that give most; the others are in the sum only
};

/// Numbers are rounded for reading; story_json() has them in full.
std::string story_text(const PixelStory& story, const StoryTextOptions& options = {});

} // namespace refraster
