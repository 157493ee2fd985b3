#pragma once
// How large anything may be. Each limit is checked before memory is taken for what it limits, so that a small file
// cannot make a large demand. docs/limits.md is printed from this list; --max-memory bounds what is left.

#include <refraster/scene.h>

#include "raster/vertex/subpixel.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace refraster {

struct Limit {
  std::string_view what;          // is limited
  std::uint64_t value;            // the largest that is taken
  std::string_view unit;          // of which that many
  std::string_view found;         // what a message says was found, with N for the number
  std::string_view reason;        // why not more
  std::string_view expected = {}; // what a message says was expected; "at most so many" if empty
};

namespace limit {

// Files
inline constexpr Limit scene_bytes{"a scene file, or a file of limits for `compare`", std::uint64_t{16} << 20, "bytes",
                                   "N bytes", "a value of JSON takes at most 75 bytes a character: 1.2 GB"};
inline constexpr Limit json_depth{"nesting of JSON", 64, "levels", "N levels of nesting",
                                  "no key of a scene is deeper than 8"};
inline constexpr Limit obj_bytes{"an OBJ file", std::numeric_limits<std::int32_t>::max(), "bytes", "N bytes",
                                 "no list of it can have more entries than 31 bits count"};
inline constexpr Limit mtl_bytes{"a material library", std::uint64_t{1} << 24, "bytes", "N bytes",
                                 "30,000 materials, each with five textures"};
inline constexpr Limit image_bytes{"an image file", std::uint64_t{1} << 33, "bytes", "N bytes",
                                   "twice the largest image of four floats a pixel"};
inline constexpr Limit glsl_bytes{"a GLSL file", std::uint64_t{1} << 20, "bytes", "N bytes",
                                  "a shader is text that someone wrote"};
inline constexpr Limit csv_bytes{"a table of numbers (CSV)", std::uint64_t{1} << 28, "bytes", "N bytes",
                                 "a row for each bin of a MERL table takes half of it"};
// Images and textures
inline constexpr Limit image_side{"an image that is read, each side", 65536, "a side", "W x H pixels",
                                  "what stb_image takes; a JPEG has 65500 at most"};
inline constexpr Limit image_pixels{"an image that is read", std::uint64_t{1} << 28, "pixels", "W x H pixels",
                                    "16384 x 16384, the largest that is rendered"};
inline constexpr Limit image_channels{"channels of an EXR image", 64, "channels", "N channels",
                                      "each takes as much as a grey image"};
inline constexpr Limit jpeg_scans{"scans of a JPEG image", 500, "scans", "N scans",
                                  "ten are usual, and each, however few bytes it has, goes through the whole image"};
inline constexpr Limit texture_side{"a texture, each side", 16384, "texels a side", "W x H pixels",
                                    "the most that OpenGL drivers take: `gl` must draw the same"};
// The scene
inline constexpr Limit objects{"objects", 65536, "values", "an array of N values", "each may load four files"};
inline constexpr Limit materials{"materials of a mesh", 65536, "materials", "N materials", "each may load ten images"};
template <class Light>
inline constexpr Limit lights{Light::names.words, 65536, "values", "an array of N values",
                              "each shines on every fragment"};
inline constexpr Limit vertices{"vertices of all objects", std::uint64_t{1} << 28, "vertices", "N vertices",
                                "in the frame a vertex takes 72 bytes: 19 GB; they are numbered in 32 bits"};
inline constexpr Limit triangles{"triangles of all objects", std::uint64_t{1} << 28, "triangles", "N triangles",
                                 "a triangle in view takes 16 bytes and more: 4 GB; they are numbered in 32 bits"};
// The frame
inline constexpr Limit frame_side{"an image that is made, each side",
                                  max_image_side,
                                  "pixels a side",
                                  "\"Nx1\"",
                                  "edges of triangles are exact in 52 bits up to here (raster/vertex/subpixel.h)",
                                  "WIDTHxHEIGHT, each 1 to 16384"};
inline constexpr Limit frame_samples{"pixels x samples of an image, or of its crop", std::uint64_t{1} << 31, "samples",
                                     "N samples", "a sample of a small triangle may take 16 bytes: 34 GB"};
inline constexpr Limit threads{
    "threads", 1024, "threads", "N", "each has a stack and the memory of a tile", "a number in 0..1024"};

} // namespace limit

/// In the order of docs/limits.md.
inline constexpr std::array all_limits = std::apply(
    []<class... Light>(std::vector<Light> Scene::*...) {
      return std::array{&limit::scene_bytes,  &limit::json_depth,     &limit::obj_bytes,        &limit::mtl_bytes,
                        &limit::image_bytes,  &limit::glsl_bytes,     &limit::csv_bytes,        &limit::image_side,
                        &limit::image_pixels, &limit::image_channels, &limit::jpeg_scans,       &limit::texture_side,
                        &limit::objects,      &limit::materials,      &limit::lights<Light>..., &limit::vertices,
                        &limit::triangles,    &limit::frame_side,     &limit::frame_samples,    &limit::threads};
    },
    light_lists);

/// What a message says was expected: "at most 65536 pixels a side".
std::string at_most(const Limit& limit);

/// What a message says of too much: "70000 pixels".
std::string found_of(const Limit& limit, std::uint64_t count);

/// The table of docs/limits.md.
std::string limits_markdown();

} // namespace refraster
