#pragma once
// Files: scenes, meshes, measured tables, images. Every function that reads checks sizes before it takes memory, and
// throws InputError with everything that is wrong with a file; every function that writes puts a file in place as a
// whole or not at all, and throws OutputError.

#include <refraster/fields.h>
#include <refraster/image.h>
#include <refraster/material.h>
#include <refraster/memory.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>
#include <refraster/scene.h>
#include <refraster/texture.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

// Scenes: docs/scene-format.md.

/// Whether a scene may name files that lie outside its own folder, symbolic links followed. A scene from someone else
/// should not: it could show, or tell apart by what is said of them, files that are not its author's.
enum class Outside { refused, allowed };

/// How a scene is read.
struct SceneOptions {
  Outside outside = Outside::refused; ///< whether it may name files outside its folder
  MemoryBudget memory = {};           ///< asked for each file
  NoteList* notes = nullptr;          ///< where remarks on the files that are read go; nowhere if null
  /// Fragment functions of one's own that a scene may name: user_function() of the fragment kit makes them. A material
  /// has a copy, with its parameters.
  std::vector<std::shared_ptr<UserFunction>> user_functions = {};
  std::string mesh_cache = {}; ///< a folder of large meshes that were read before ; none if empty
  /// What keeps lights from surfaces, of those that have a shadow; each its own where nothing is said. A map is as the
  /// scene has it, or as one is where nothing is said of it.
  std::optional<Shadow> shadow = {};
  std::optional<int> shadow_map_size = {}; ///< of all maps: ShadowMap::size; each its own where nothing is said
  double exposure_stops = 0;   ///< all that shines is multiplied by 2^stops: the picture is as many stops brighter
  int threads = 0; ///< that read a mesh; 0: as many as the machine has. The scene is the same for any number
};

/// Reads a scene with every file that it names: meshes, textures, measured tables. A file named twice is loaded once.
/// Throws InputError with all faults: of the scene in the order of the file, then of the files it names; and
/// OutputError if a folder for meshes is given that lets nothing be written to it.
Scene read_scene(const std::string& path, const SceneOptions& options = {});

// Meshes: Wavefront OBJ.

/// Where the normals of a mesh that is read from a file come from.
enum class NormalsFrom {
  file,   ///< what the file says: see read_obj
  smooth, ///< one normal a vertex: of all faces around it
  flat,   ///< each face its own
  crease  ///< of those faces around a vertex that meet at no more than an angle: see crease_degrees
};

/// The words; the crease is an object of JSON.
template <>
struct EnumNames<NormalsFrom> {
  static constexpr std::pair<NormalsFrom, std::string_view> names[] = {
      {NormalsFrom::file, "file"}, {NormalsFrom::smooth, "smooth"}, {NormalsFrom::flat, "flat"}};
};

/// Part of what makes two meshes of one file the same mesh. All but `file` compute every normal from the faces,
/// whatever vn and s say.
struct MeshNormals {
  NormalsFrom from = NormalsFrom::file; ///< of what
  double crease_degrees = 0;            ///< with NormalsFrom::crease only: 0 to 180
  /// Whether they make the same mesh.
  bool operator==(const MeshNormals&) const = default;
};

/// What the colours of an OBJ file's vertices, `v x y z r g b`, are taken as.
enum class VertexColours {
  linear, ///< linear values
  srgb,   ///< encoded by the sRGB curve: decoded before they are interpolated
  ignored ///< nothing: the mesh has none
};

template <>
struct EnumNames<VertexColours> {
  static constexpr std::pair<VertexColours, std::string_view> names[] = {
      {VertexColours::linear, "linear"}, {VertexColours::srgb, "srgb"}, {VertexColours::ignored, "ignored"}};
};

/// How an OBJ file is read.
struct ObjOptions {
  MeshNormals normals = {};                      ///< where they come from
  NoteList* notes = nullptr;                     ///< where remarks on the file go; nowhere if null
  VertexColours colours = VertexColours::linear; ///< what those of the vertices are taken as
  int threads = 0; ///< that read it; 0: as many as the machine has. The mesh is the same for any number, bit for bit
};

/// Reads all faces of an OBJ file as one mesh, triangles in the order of the file.
///   v, vt, vn   each coordinate is rounded once, to float. A face without vt at all its corners has none
///               `v x y z r g b` has a colour: from 0 to 1, or, where one of the file exceeds 1, from 0 to 255. In a
///               file in which some have one, the others are white; so is one that is not finite. Below 0 counts as 0
///   f           3 or more corners, also concave; indices from 1, or negative: counted back from the last one given.
///               A polygon with n corners becomes n - 2 triangles of the same winding; a convex one the fan of its
///               first corner. Refused if many thousand corners fold so that cutting takes more than seconds
///   s           corners without vn get the mean normal, weighted by angle, of those faces around the vertex that have
///               no vn there either and belong together: those in the same smoothing group. Faces before the first `s`
///               and after `s off` are flat. In a file without any `s` they are those that share an edge there and
///               enclose at most crease_degrees_of_files, and the faces that so belong to one of these
///   others      say nothing about the shape, or are not read: see NoteList
/// Two corners of a face in one place, named twice or not told apart by floats, count as one. A sum of normals that
/// rounding may have left of nothing is 0: so is the vertex's normal, and that of a face without area.
/// Vertices are one for each different (v, vt, vn), numbered as they appear, those with a vt first. At most 2 GiB.
/// What is unusual but has one meaning is read, and noted; so is what is left out.
/// Throws InputError with all faults, each with its line.
Mesh read_obj(const std::string& path, const ObjOptions& options = {});

/// Writes a mesh so that read_obj gives it back: the same triangles, and each coordinate bit for bit; but for texture
/// coordinates of triangles of which not all corners have some.
/// Throws OutputError.
void write_obj(const std::string& path, const Mesh& mesh);

// Measured BRDFs: the MERL database's `.binary` files.

/// Reads a table; what was never measured stays negative. Throws InputError: size, dimensions, NaN or infinity.
std::shared_ptr<const MerlTable> read_merl(const std::string& path);

/// Writes a table so that read_merl gives each value back within an ulp: the scales are no powers of two.
void write_merl(const std::string& path, const MerlTable& table);

// Images: docs/image-formats.md.

/// An image as it is stored.
struct ImageFile {
  Image<float> values;               ///< 1 to 4 channels or, of an EXR file, as many as it has; row 0 at the top
  int bits = 8;                      ///< of a channel: 8, 16 or 32 (float)
  double full_scale = 255;           ///< the value that means 1: 255, 65535, or 1 for float
  std::vector<std::string> channels; ///< names, as R G B A, or Y for one channel
  bool names_channels = false;       ///< whether the file says them (EXR), or they follow from their number
  double unit_roundoff = 0x1p-24;    ///< of float values, relative to the largest of their pixel: half numbers 2^-11,
                                     ///< .hdr 2^-8; 8 and 16 bits have half a step instead
  NoteList notes;                    ///< what was read otherwise than it is stored
};

/// Reads any of the formats of io/image/image_formats.h: PNG, JPEG, TGA, BMP (8 or 16 bits), Radiance HDR, PFM, OpenEXR
/// (float). What it is, is seen from its content; docs/image-formats.md says what is read of each. Values are as
/// stored: no gamma, no colour profile and no EXIF orientation is applied. Throws InputError. The size it declares is
/// checked against the limits (io/file/limits.h), and against the size of the file, before any memory is taken.
ImageFile read_image(const std::string& path, const MemoryBudget& memory = {});

/// Reads an image of 8 or 16 bits, within limit::texture_side, as a texture with level 0 only: one channel becomes
/// grey, alpha is dropped. Else as read_image; its notes go to `notes`, if not null.
Texture read_texture(const std::string& path, const MemoryBudget& memory = {}, NoteList* notes = nullptr);

/// The same of a texture of single numbers: all three values of a texel are that of the channel.
Texture read_scalar_texture(const std::string& path, ScalarChannel channel, const MemoryBudget& memory = {},
                            NoteList* notes = nullptr);

/// What a file says that its colours are encoded by; no value depends on it.
enum class StatedCurve {
  none, ///< nothing: shown as they are, as OpenGL's default framebuffer shows them
  srgb  ///< IEC 61966-2-1: a PNG's chunk sRGB
};

/// How an image is written.
struct WriteOptions {
  StatedCurve curve = StatedCurve::none; ///< stated by `.png`; the other formats have no place for it
  int jpeg_quality = 95;                 ///< 1 to 100; above 90 colours have the resolution of the image
  int threads = 0;                       ///< 0: as many as the machine has. The file is the same for any number
};

/// Writes whole numbers in the format that the path's extension says, in any case: `.png`, 8 or 16 bits and 1 (grey),
/// 2 (grey, alpha), 3 (RGB) or 4 channels (RGB, alpha, straight); `.jpg`, 8 bits and 3 channels, lossy; `.npy`, any
/// channels and bits. Throws OutputError; InputError for another extension or number of channels.
void write_image(const std::string& path, const Image<std::uint8_t>& image, const WriteOptions& options = {});
/// The same of 16 bits.
void write_image(const std::string& path, const Image<std::uint16_t>& image, const WriteOptions& options = {});
/// The same of 32 bits: `.npy` alone.
void write_image(const std::string& path, const Image<std::uint32_t>& image, const WriteOptions& options = {});

/// Writes float values likewise: `.hdr` (3 channels, 8-bit mantissas: lossy), `.pfm` (1 or 3 channels), `.exr` and
/// `.npy` (any channels, 32-bit float). `channels` names those of a file that has names; by default R G B, or Y for a
/// single one.
void write_image(const std::string& path, const Image<float>& image, std::vector<std::string> channels = {},
                 const WriteOptions& options = {});

} // namespace refraster
