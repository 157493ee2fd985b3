#pragma once
// The scenes that the repository shows, read once each.

#include <refraster/render.h>

#include <string>
#include <vector>

namespace refraster {

/// Paths of scenes/gallery/*.json and the lecture's config.json, sorted.
std::vector<std::string> listed_scenes();

/// A few of them that are quickly read and together use every fragment function, every set-up and every texture filter
/// but nearest.
std::vector<std::string> quick_scenes();

/// Kept until the next call with another path: a scene may hold 100 MB.
const Scene& listed_scene(const std::string& path);

} // namespace refraster
