#pragma once
// What a pixel sees, worked out triangle by triangle in long double from the rules in docs/conventions.md: no bins, no
// tiles, no edge functions, no fixed point.

#include <refraster/scene.h>

#include "tests/support/slow/slow_vector.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace refraster::slow {

struct Pixel {
  int x = 0, y = 0;
};

struct Seen {
  const Object* object = nullptr; // null: nothing but the background
  const Material* material = nullptr;
  std::uint32_t triangle = 0; // of the object's mesh
  Vec position, normal;       // world space; normal of unit length
  bool has_uv = false;        // all corners of the triangle have texture coordinates
  Real u = 0, v = 0;
  Vec colour = {1, 1, 1};                                // of the vertices
  Vec tangent;                                           // as interpolated; 0 without
  Real handedness = 0;                                   // of the frame
  bool turned = false;                                   // the normal is
  Real u_right = 0, v_right = 0, u_down = 0, v_down = 0; // their change by one pixel
};

/// Where corners come from: worked out here from the scene's numbers, or as the renderer's vertex stage stores them in
/// double, so that what follows it can be judged by itself.
enum class Vertices { own, of_the_renderer };

/// For each pixel what is seen at its centre. Nothing where that is not for this function to say: the centre lies on an
/// edge (the top-left rule decides), two surfaces are as good as equally deep, or there is no normal.
std::vector<std::optional<Seen>> seen_at(const Scene& scene, int width, int height, std::span<const Pixel> pixels,
                                         Vertices vertices = Vertices::own);

} // namespace refraster::slow
