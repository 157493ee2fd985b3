#include "verify/images/image_pair.h"

#include <refraster/notes.h>

#include "io/file/text.h"
#include "verify/images/colour_image.h"
#include "verify/transformations/transformations.h"

#include <algorithm>

namespace refraster {
namespace {

std::string shape_text(const Image<float>& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels of " +
         std::to_string(image.channels) + (image.channels == 1 ? " channel" : " channels");
}

std::string listed(const std::vector<std::string>& channels) {
  std::string text;
  for (const std::string& name : channels) text += (text.empty() ? "" : ", ") + name;
  return "channels " + one_line(text);
}

/// A single channel is what it is, whatever it is called.
bool mean_the_same(const ColourImage& a, const ColourImage& b) {
  if (a.names.size() == 1 || (a.kind == b.kind && a.kind != ColourChannels::Kind::data)) return true;
  return !a.names_channels || !b.names_channels || a.names == b.names;
}

/// n / from becomes m / to. Exact from 255 to 65535, else the nearest float.
void rescale(Image<float>& image, double from, double to) {
  if (from == to) return;
  for (float& value : image.values) value = static_cast<float>(static_cast<double>(value) * to / from);
}

StoredImage stored(const ColourImage& image) {
  return {image.colour, image.full_scale, image.precision};
}

/// Throws unless both can be compared.
void check_shapes(const ColourImage& a, const ColourImage& b, double limit_levels) {
  const bool same_size = a.colour.width == b.colour.width && a.colour.height == b.colour.height;
  if (!same_size || a.colour.channels != b.colour.channels) {
    std::string expected = shape_text(a.colour) + " as " + a.path + " has";
    const auto found = find_size_transformation(stored(a), stored(b), limit_levels);
    if (found) expected += "; " + transformation_text(*found, CompareUnit::levels);
    throw InputError(InputFault{b.path, 0, 0, "", shape_text(b.colour), expected});
  }
  if (!mean_the_same(a, b))
    throw InputError(InputFault{b.path, 0, 0, "", listed(b.names), listed(a.names) + " as " + a.path + " has"});
}

} // namespace

ImagePair read_image_pair(const std::string& path_a, const std::string& path_b, const PairRequest& request,
                          const MemoryBudget& memory) {
  ImagePair pair;
  NoteList same_notes; // of a file beside itself
  ColourImage a = read_colour_image(path_a, request.layer, memory, pair.notes);
  ColourImage b = read_colour_image(path_b, request.layer, memory, path_a == path_b ? same_notes : pair.notes);
  if (!request.layer.empty() && !a.has_layer && !b.has_layer)
    throw InputError(InputFault{path_b, 0, 0, "", "no layer " + in_quotes(request.layer) + " with R, G and B",
                                "--layer to name one of this file or of " + path_a});
  check_shapes(a, b, request.limit_levels);
  resolve_alpha(a, b, request, pair.alpha, pair.notes);
  pair.full_scale = a.is_float() || b.is_float() ? 1 : std::max(a.full_scale, b.full_scale);
  for (ColourImage* const image : {&a, &b}) rescale(image->colour, image->full_scale, pair.full_scale);
  pair.a = std::move(a.colour), pair.b = std::move(b.colour);
  pair.precision_a = a.precision, pair.precision_b = b.precision;
  return pair;
}

} // namespace refraster
