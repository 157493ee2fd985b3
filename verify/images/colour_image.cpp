#include "verify/images/colour_image.h"

#include <refraster/notes.h>

#include "io/file/text.h"

#include <algorithm>

namespace refraster {
namespace {

/// "N.X, Z and 3 more".
std::string listed(const std::vector<std::string>& channels, const std::vector<std::size_t>& places) {
  constexpr std::size_t most = 8; // a file may have 64
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    text += (i > 0 ? ", " : "") + one_line(channels[places[i]]);
  if (places.size() > most) text += " and " + std::to_string(places.size() - most) + " more";
  return text;
}

Image<float> channels_of(const Image<float>& image, const std::vector<std::size_t>& places) {
  Image<float> result(image.width, image.height, static_cast<int>(places.size()));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < places.size(); ++c) result.at(x, y)[c] = image.at(x, y)[places[c]];
  return result;
}

} // namespace

ColourImage read_colour_image(const std::string& path, const std::string& layer, const MemoryBudget& memory,
                              NoteList& notes) {
  ImageFile file = read_image(path, memory);
  notes.add(file.notes);
  const ColourChannels chosen = colour_channels(path, file, layer);
  ColourImage result;
  result.path = path;
  result.kind = chosen.kind;
  const std::vector<std::string> layers = colour_layers(file.channels);
  result.has_layer = chosen.layer == layer || std::find(layers.begin(), layers.end(), layer) != layers.end();
  result.names_channels = file.names_channels;
  result.full_scale = file.full_scale;
  result.precision =
      file.bits == 32 ? StoredPrecision::floats(file.unit_roundoff) : StoredPrecision::integers(file.full_scale);
  for (const std::size_t place : chosen.compared) result.names.push_back(file.channels[place]);
  if (!chosen.others.empty()) {
    const std::string these = chosen.layer.empty() ? "" : listed(file.channels, chosen.compared) + " are compared, ";
    const bool one = chosen.others.size() == 1;
    notes.add({path, 0, "",
               these + (one ? "the channel " : "the channels ") + listed(file.channels, chosen.others) +
                   (one ? " is not" : " are not") + (these.empty() ? " compared" : "")});
  }
  memory.need(sizeof(float) * file.values.values.size(), path);
  if (chosen.alpha) result.alpha = channels_of(file.values, {*chosen.alpha});
  const bool all =
      chosen.compared.size() == file.channels.size() && std::is_sorted(chosen.compared.begin(), chosen.compared.end());
  result.colour = all ? std::move(file.values) : channels_of(file.values, chosen.compared);
  return result;
}

} // namespace refraster
