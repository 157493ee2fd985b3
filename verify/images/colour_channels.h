#pragma once
// Which channels of an image are its colour.

#include <refraster/files.h>

#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// Places in the list of channels.
struct ColourChannels {
  enum class Kind { rgb, grey, data } kind = Kind::rgb;
  std::vector<std::size_t> compared; // red, green, blue; or grey; or, of data without a colour, all
  std::optional<std::size_t> alpha;  // of the colour
  std::vector<std::size_t> others;   // of other layers, depth, normals …
  std::string layer;                 // "ViewLayer.Combined" of ViewLayer.Combined.R; empty if there is none
};

/// Layers whose channels are R, G and B (or Red, Green, Blue; in any case), in the order of the file. "" is the one
/// without a name.
std::vector<std::string> colour_layers(const std::vector<std::string>& channels);

/// The channels of the layer of this name, a colour or data as N.X, N.Y and N.Z are, or the one channel of this name, as
/// Z; or, if it is empty or not in this file, the colour of the layer without a name; of the only layer with a colour;
/// of the only one called Combined, as Blender calls the image among its passes. Without red, green and blue, Y is grey
/// (unless X is there too: a vector); else the image is data, and all of its channels count. Throws InputError if it
/// remains open which layer is meant.
ColourChannels colour_channels(const std::string& path, const ImageFile& image, const std::string& layer);

} // namespace refraster
