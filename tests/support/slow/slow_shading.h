#pragma once
// The colour of a surface, from the formulas of docs/conventions.md as a textbook has them: long double, the C
// library's pow and acos, one light after the other.

#include "tests/support/slow/slow_visibility.h"

namespace refraster::slow {

/// Light at a point of a surface.
struct Arriving {
  Vec direction, radiance; // direction: to the light
};

/// What a formula is given.
struct Lit {
  Vec normal, to_eye, texture;              // unit vectors; the texture's colour, times the vertices'
  std::vector<Arriving> lights;             // all of the scene
  Vec specular{1, 1, 1}, emission{0, 0, 0}; // what multiplies ks; light of its own, of all but tables
  bool doubtful = false;                    // whether a light is seen is not for us to say
  Real roughness = 1, metallic = 1;         // what multiplies those of microfacets
};
Lit lit(const Scene& scene, const Seen& seen); // seen.object is not null

struct Shaded {
  Vec radiance;  // toward the eye
  Vec magnitude; // the sum of what was added, with white for the texture: rounding errors are in proportion to it
};

/// Whether a surface is there, by its opacity; nothing where this is not for us to say: where a step of rounding
/// decides.
std::optional<bool> is_there(const Seen& seen); // seen.material is not null

/// Whether there is a formula here for this fragment function.
bool has_formula(const FragmentFunction& function);

/// Nothing for lookups that are not implemented here, those on logarithms, and where shadows are in doubt. Throws
/// std::logic_error, which names it, for a fragment function without a formula here, one of the user's own among them.
std::optional<Shaded> shaded(const Scene& scene, const Seen& seen);

} // namespace refraster::slow
