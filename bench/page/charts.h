#pragma once
// The pictures of a run, each an SVG element.

#include "bench/measure/results.h"

#include "io/html/svg.h"

#include <span>
#include <string>
#include <vector>

namespace refraster::bench {

/// The precisions of a run in the order in which they first appear: their index is their colour.
std::vector<std::string> precisions_of(const Run& run);
std::size_t index_of(const std::vector<std::string>& precisions, const std::string& precision);

/// The class of the n-th precision's colour.
std::string precision_class(std::size_t n);

/// The precisions of a run and their colours.
std::vector<LegendEntry> precision_legend(const Run& run);

/// A scene's path without folders and ending.
std::string short_name(const SceneResult& scene);
/// The same, with its size where the run has several.
std::string label(const Run& run, const SceneResult& scene);

/// Mean relative error against `exact`, over ns a shaded pixel: a point for each scene and precision, those of a scene
/// joined. Empty if there is no such error.
std::string error_chart(const Run& run);

/// Of one scene: a bar for each precision and number of threads, made of the parts of a frame.
std::string split_chart(const SceneResult& scene);

/// OpenGL's time over ours: a row for each scene, a dot for each precision and number of threads. Empty without OpenGL.
std::string ratio_chart(const Run& run);

/// What curves of one growth show: time (of threads: the speed-up), and peak memory, over what grows.
std::string growth_chart(const Run& run, std::span<const ScalingCurve* const> curves);
std::string memory_chart(const Run& run, std::span<const ScalingCurve* const> curves);

} // namespace refraster::bench
