#pragma once
// One image file, taken apart into what is compared and its alpha.

#include <refraster/files.h>

#include "verify/images/colour_channels.h"
#include "verify/images/image_pair.h"
#include "verify/images/stored_precision.h"

#include <string>
#include <vector>

namespace refraster {

/// The colour of a file, or its data where it has no colour, in the numbers of the file.
struct ColourImage {
  std::string path;
  ColourChannels::Kind kind = ColourChannels::Kind::rgb;
  std::vector<std::string> names; // of the channels that are compared
  bool has_layer = false;         // the one that was asked for
  bool names_channels = false;    // whether the file says them: then it is an EXR file
  Image<float> colour;
  Image<float> alpha; // 1 channel; empty if the file has none
  double full_scale = 255;
  StoredPrecision precision;

  bool is_float() const { return full_scale == 1; }
};

/// Reads one. Notes say what of the file is not compared. Throws InputError.
ColourImage read_colour_image(const std::string& path, const std::string& layer, const MemoryBudget& memory,
                              NoteList& notes);

/// Does with the alpha channels what is asked for; afterwards neither image has one. An alpha that is not 1 everywhere
/// is put into `kept` as it is stored, 1 for opaque (that of b before that of a), for those who ask whether it explains
/// a difference. Throws InputError where the request leaves open what to do.
void resolve_alpha(ColourImage& a, ColourImage& b, const PairRequest& request, Image<float>& kept, NoteList& notes);

} // namespace refraster
