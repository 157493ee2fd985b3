#pragma once
// Two image files, ready to be compared.

#include <refraster/compare.h>
#include <refraster/memory.h>
#include <refraster/notes.h>

#include "math/vec.h"
#include "verify/images/stored_precision.h"

#include <array>
#include <string>
#include <string_view>

namespace refraster {

/// What is done with an alpha channel. Missing alpha is 1.
enum class AlphaUse {
  refused_unless_one, // left out where it is 1 everywhere, with a note; else an InputError that names the choices
  ignored,            // left out; colours as they are stored
  compared,           // as a fourth channel, beside premultiplied colours where the two files differ in this
  composited          // colours over a background
};

/// Whether colours are stored multiplied by alpha. By format: those of EXR files are, others not.
enum class AlphaEncoding { by_format, premultiplied, straight };

/// How two files become images that can be compared.
struct PairRequest {
  AlphaUse alpha = AlphaUse::refused_unless_one;
  std::array<double, 3> background = {0, 0, 0}; // R G B, 1 is full scale; of AlphaUse::composited
  AlphaEncoding encoding = AlphaEncoding::by_format;
  double limit_levels = 0; // within which sizes are judged: "b is a at half size"
  std::string layer = {};  // of EXR files: "ViewLayer.Combined"; empty: the one with the colour (colour_channels.h)
};

/// Two images of one size and number of channels, whose numbers count to the same full scale.
struct ImagePair {
  Image<float> a, b;
  double full_scale = 255; // 255, 65535, or 1 for values
  StoredPrecision precision_a, precision_b;
  Image<float> alpha; // as stored beside a or b, 1 is opaque; empty if neither has any but 1
  NoteList notes;     // what of the files is left out, or is not as it is stored
};

/// Reads two images. Two of 8 bits count to 255; one of 16 bits beside one of 8 or 16, to 65535 (exact: n of 255 is 257
/// n of 65535); beside floats a level is the float nearest to its share of the full scale. Throws InputError if one
/// cannot be read, or if they differ in size (and says whether one is the other at half or double size), in the number
/// of channels, or, where both files name them (EXR) and they are no colours, in these names.
ImagePair read_image_pair(const std::string& path_a, const std::string& path_b, const PairRequest& request = {},
                          const MemoryBudget& memory = {});

} // namespace refraster
