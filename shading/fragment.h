#pragma once
// What a fragment function is given.

#include "math/vec.h"
#include "shading/undefined.h"

namespace refraster::inline REFRASTER_KIT {

/// What a material's further textures say of a fragment, where it has any: Material::has_fragment_maps().
template <class T>
struct FragmentMaps {
  Rgb<T> specular; // multiplies ks; of Microfacet: its green multiplies roughness, its blue metallic
  Rgb<T> emission; // light of its own
};

/// One visible sample of a surface (or one a lane). All in world space; unit vectors point away from the surface.
template <class T>
struct Fragment {
  Vec3<T> position;
  Vec3<T> normal; // unit; as the mesh gives it: turned toward the eye on two-sided objects only. 0 if there is none
  Vec3<T> to_eye; // unit; 0 with the eye at the surface
  Rgb<T> texture; // texture colour, white without a texture
  const UndefinedTally<T>* tally = nullptr;
  const FragmentMaps<T>* maps = nullptr; // null: parameters as the material has them, and no light of its own

  /// Counts a case that the mathematics leaves undefined, where `where` says so. See shading/undefined.h.
  void undefined(Undefined which, const MaskOf<T>& where) const {
    if (tally) tally->note(which, where);
  }
};

/// The light that one light source sends to a fragment.
template <class T>
struct Incident {
  Vec3<T> direction; // unit, from the surface to the light; 0 with the light at the surface
  Rgb<T> radiance;   // C: radiance times attenuation times visibility
};

} // namespace refraster::inline REFRASTER_KIT
