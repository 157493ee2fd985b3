#include "verify/image_pair.h"

#include "io/image_file.h"
#include "io/input_error.h"
#include "io/text.h"

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
bool mean_the_same(const ImageFile& a, const ImageFile& b) {
  return !a.names_channels || !b.names_channels || a.channels.size() == 1 || a.channels == b.channels;
}

void scale_to_values(ImageFile& image) {
  if (image.full_scale == 1) return;
  for (float& value : image.values.values) value = static_cast<float>(static_cast<double>(value) / image.full_scale);
}

} // namespace

ImagePair read_image_pair(const std::string& path_a, const std::string& path_b, const MemoryBudget& memory) {
  ImageFile a = read_image(path_a, memory), b = read_image(path_b, memory);
  const bool same_shape =
      a.values.width == b.values.width && a.values.height == b.values.height && a.values.channels == b.values.channels;
  if (!same_shape) {
    InputFault fault;
    fault.file = path_b;
    fault.found = shape_text(b.values);
    fault.expected = shape_text(a.values) + " as " + path_a + " has";
    throw InputError(fault);
  }
  if (!mean_the_same(a, b))
    throw InputError(InputFault{path_b, 0, 0, "", listed(b.channels), listed(a.channels) + " as " + path_a + " has"});
  const CompareUnit unit = a.bits == 8 && b.bits == 8 ? CompareUnit::levels : CompareUnit::values;
  if (unit == CompareUnit::values) {
    scale_to_values(a);
    scale_to_values(b);
  }
  return {std::move(a.values), std::move(b.values), unit};
}

} // namespace refraster
