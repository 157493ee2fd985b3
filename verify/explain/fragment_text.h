#pragma once
// A fragment of the story in text: surface, texture, material, lights, sum.

#include "verify/explain/pixel_story.h"
#include "verify/explain/story_text.h"

#include <string>

namespace refraster::story {

std::string fragment_text(const FragmentStory& fragment, const StoryTextOptions& options);

/// `object 1 "knot"`, cut to a width.
std::string object_text(const NamedTriangle& of, std::size_t width = 40);

/// "point light 0".
std::string light_text(const LightStory& light);

} // namespace refraster::story
