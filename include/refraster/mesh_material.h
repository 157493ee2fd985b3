#pragma once
// Materials as a file beside a mesh describes them: Wavefront's .mtl. What they mean to a fragment function is in
// docs/mtl.md.

#include <refraster/vector.h>

#include <optional>
#include <string>

namespace refraster {

/// An image that a material names, and how it is read.
struct MeshTexture {
  std::string path = {};     ///< as the file has it, which may be wrong; empty: none
  Double2 scale{1};          ///< -s: texture coordinates are multiplied by it,
  Double2 offset{0};         ///< -o: and this is added
  bool clamp = false;        ///< -clamp: the image does not repeat
  double bump_multiplier{1}; ///< -bm
  char channel = 0;          ///< -imfchan: r, g, b, m, l or z; 0: the key's own
  int line = 0;              ///< of the file, counted from 1
};

/// A material of the file. What it does not say is empty.
struct MeshMaterial {
  std::string name = {};                ///< as usemtl has it
  std::string file = {};                ///< the .mtl file that describes it; empty: none was found
  int line = 0;                         ///< where it does, counted from 1
  std::optional<Double3> ambient = {};  ///< Ka
  std::optional<Double3> diffuse = {};  ///< Kd
  std::optional<Double3> specular = {}; ///< Ks
  std::optional<Double3> emissive = {}; ///< Ke
  std::optional<double> exponent = {};  ///< Ns
  std::optional<double> dissolve = {};  ///< d, or 1 - Tr
  std::optional<double> roughness = {}; ///< Pr
  std::optional<double> metallic = {};  ///< Pm
  std::optional<int> illumination = {}; ///< illum
  MeshTexture ambient_map = {};         ///< map_Ka
  MeshTexture diffuse_map = {};         ///< map_Kd
  MeshTexture specular_map = {};        ///< map_Ks
  MeshTexture emissive_map = {};        ///< map_Ke
  MeshTexture dissolve_map = {};        ///< map_d
  MeshTexture bump_map = {};            ///< map_Bump, map_bump, bump
  MeshTexture normal_map = {};          ///< norm
  MeshTexture roughness_map = {};       ///< map_Pr
  MeshTexture metallic_map = {};        ///< map_Pm
};

/// What an OBJ file's `mtllib` says: one file or several.
struct MaterialLibrary {
  std::string text = {}; ///< as it stands
  int line = 0;          ///< counted from 1
};

} // namespace refraster
