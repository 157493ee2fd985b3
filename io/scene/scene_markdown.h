#pragma once
// docs/scene-format.md.

#include <string>

namespace refraster {

/// The keys of a scene file as Markdown tables, made from the declaration that the reader follows.
std::string scene_format_markdown();

} // namespace refraster
