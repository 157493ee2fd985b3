#pragma once
// The text of a small scene file, for messages.

#include <string>

namespace refraster {

/// A scene that shows a lit sphere and needs no other file.
std::string example_scene();

} // namespace refraster
