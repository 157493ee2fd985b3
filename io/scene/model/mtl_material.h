#pragma once
// What a material of a file means to a fragment function: docs/mtl.md.

#include <refraster/material.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>

namespace refraster {

/// The ambient light that files take for granted: a scene has none, so it is in ka. As in the defaults of viewers, it
/// lets shapes be told in shadow, and leaves what is lit as it is.
inline constexpr double ambient_light_of_files = 0.1;

/// Which formula shades what a file describes. Phong and Blinn-Phong have the same parameters.
enum class FileFunction { phong, blinn_phong, microfacet };

/// The parameters of Phong and Blinn-Phong, in double and linear. Without textures.
PhongParameters phong_parameters(const MeshMaterial& material);

/// Those of microfacets, in double and linear. Without textures. Where a file says nothing of roughness it is that of a
/// highlight about as wide as the one of `Ns`.
Microfacet microfacet_parameters(const MeshMaterial& material);

/// Light of its own, linear, without texture.
Double3 emissive_colour(const MeshMaterial& material);

/// Which channel of a map of single numbers is read: that of -imfchan, if an image has it.
ScalarChannel scalar_channel(const MeshTexture& map, ScalarChannel otherwise);

/// Notes what the file says of a material and the fragment function does not show, each kind once.
void note_what_is_not_shown(const MeshMaterial& material, FileFunction function, NoteList& notes);

} // namespace refraster
