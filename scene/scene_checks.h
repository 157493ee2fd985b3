#pragma once
// The checks behind validate(), and those that a frame pays for.

#include <refraster/scene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace refraster {

/// The first fault that is refused, of what a frame reads once for each object: all but indices of vertices, which it
/// checks where it reads them.
std::optional<SceneFault> first_refused_fault(const Scene& scene);

/// Whether each index is below `vertices`.
bool indices_within(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices);

/// Throws std::invalid_argument.
[[noreturn]] void refuse(const SceneFault& fault);

/// The same with the first index that names no vertex.
void refuse_indices(const Scene& scene);

} // namespace refraster
