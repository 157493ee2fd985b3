#include "verify/images/actual_pixel.h"

namespace refraster {

ColourImage read_actual_image(const std::string& path, const std::string& layer, const MemoryBudget& memory,
                              NoteList& notes) {
  ColourImage image = read_colour_image(path, layer, memory, notes);
  if (!layer.empty() && !image.has_layer)
    throw InputError(
        InputFault{path, 0, 0, "", "no layer \"" + layer + "\" with R, G and B", "--layer to name one of this file"});
  if (image.kind == ColourChannels::Kind::data)
    throw InputError(InputFault{path, 0, 0, "", std::to_string(image.colour.channels) + " channels that are no colour",
                                "red, green and blue, or grey"});
  if (!image.alpha.empty()) notes.add({path, 0, "", "the alpha channel is left out"});
  return image;
}

ActualPixel actual_pixel(const ColourImage& image, int x, int y) {
  const float* const at = image.colour.at(x, y);
  const bool grey = image.colour.channels < 3;
  const auto channel = [&](int c) { return static_cast<double>(at[grey ? 0 : c]); };
  return {image.path, {channel(0), channel(1), channel(2)}, image.full_scale, image.precision};
}

} // namespace refraster
