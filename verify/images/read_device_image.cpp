#include "verify/images/read_device_image.h"

#include <refraster/files.h>

#include "io/file/text.h"
#include "verify/images/colour_image.h"

#include <algorithm>

namespace refraster {
namespace {

std::string size_text(const Image<float>& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
}

/// The channels of these names or, in a file that names none, the first ones.
Image<float> data_channels(const std::string& path, const std::vector<std::string>& names, const Image<float>& colour,
                           const MemoryBudget& memory, NoteList& notes) {
  const ImageFile file = read_image(path, memory);
  notes.add(file.notes);
  if (file.values.width != colour.width || file.values.height != colour.height)
    throw InputError(InputFault{path, 0, 0, "", size_text(file.values), size_text(colour) + " as the image has"});
  if (file.bits != 32)
    throw InputError(
        InputFault{path, 0, 0, "", std::to_string(file.bits) + " bits a channel", "floating point: .exr or .pfm"});
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = std::find(file.channels.begin(), file.channels.end(), names[i]);
    places.push_back(file.names_channels && found != file.channels.end()
                         ? static_cast<std::size_t>(found - file.channels.begin())
                         : i);
  }
  if (file.channels.size() < names.size())
    throw InputError(InputFault{path, 0, 0, "", std::to_string(file.channels.size()) + " channel",
                                std::to_string(names.size()) + ": " + names.front() + " and " + names.back()});
  Image<float> result(colour.width, colour.height, static_cast<int>(names.size()));
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      for (std::size_t c = 0; c < places.size(); ++c) result.at(x, y)[c] = file.values.at(x, y)[places[c]];
  return result;
}

void turn_over(Image<float>& image) {
  const auto row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
  for (int y = 0; y < image.height / 2; ++y)
    std::swap_ranges(image.at(0, y), image.at(0, y) + row, image.at(0, image.height - 1 - y));
}

} // namespace

DeviceImage read_device_image(const DeviceImageRequest& request, NoteList& notes) {
  ColourImage colour = read_colour_image(request.colour, request.layer, request.memory, notes);
  if (!request.layer.empty() && !colour.has_layer)
    throw InputError(InputFault{request.colour, 0, 0, "", "no layer " + in_quotes(request.layer) + " with R, G and B",
                                "one of its layers"});
  if (colour.kind != ColourChannels::Kind::rgb || colour.colour.channels != 3)
    throw InputError(InputFault{request.colour, 0, 0, "", std::to_string(colour.colour.channels) + " channels to judge",
                                "red, green and blue"});
  ColourImage none;
  Image<float> kept;
  PairRequest alpha;
  alpha.alpha = request.alpha, alpha.background = request.background, alpha.encoding = request.encoding;
  resolve_alpha(none, colour, alpha, kept, notes);
  DeviceImage image;
  image.colour = std::move(colour.colour);
  image.full_scale = colour.full_scale;
  image.precision = colour.precision;
  image.transfer = request.transfer;
  if (!request.ids.empty())
    image.ids = data_channels(request.ids, {"object", "triangle"}, image.colour, request.memory, notes);
  if (!request.depth.empty()) image.depth = data_channels(request.depth, {"Z"}, image.colour, request.memory, notes);
  if (request.rows == RowOrder::bottom_first)
    for (Image<float>* const part : {&image.colour, &image.ids, &image.depth}) turn_over(*part);
  return image;
}

} // namespace refraster
