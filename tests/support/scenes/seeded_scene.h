#pragma once
// Random scenes that renderers are verified with.

#include <refraster/scene.h>

#include <cstdint>

namespace refraster::test {

/// A scene and the size of its image.
struct SeededScene {
  Scene scene;
  int width = 0, height = 0; // about 160 x 90, odd and even
};

/// Of what people draw, and of what is hard for a GPU: needles, slivers, soups of triangles, fans around a corner,
/// surfaces close to the eye, planes through it, corners behind it, surfaces in one place, mirrored and flat scales;
/// every fragment function with every lookup, angle, texture filter and gate; lights of both types with every kind of
/// attenuation. Unlike random_scene(), all numbers are such that floats have a chance. The same for the same seed,
/// everywhere. Tables are shared by all scenes: 140 MB once the first one has any.
SeededScene seeded_scene(std::uint64_t seed);

} // namespace refraster::test
