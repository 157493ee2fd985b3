#pragma once
// Triangles that floats can number.

#include <refraster/scene.h>

#include <string>

namespace refraster {

/// Throws InputError for an object with more triangles than floats can number: where a number would stand for several
/// triangles, none is written. `option` is what asked for the numbers.
void check_triangle_numbers(const std::string& path, const Scene& scene, const std::string& option);

} // namespace refraster
