#include <refraster/notes.h>

#include "verify/images/colour_image.h"
#include "verify/report_text.h"

#include <algorithm>

namespace refraster {
namespace {

/// The first pixel that is not opaque.
const float* first_not_one(const ColourImage& image) {
  const auto& values = image.alpha.values;
  const auto found = std::find_if(values.begin(), values.end(), [&](float alpha) {
    return !(static_cast<double>(alpha) == image.full_scale); // NaN is not 1 either
  });
  return found == values.end() ? nullptr : &*found;
}

[[noreturn]] void refuse(const ColourImage& image, const float* alpha) {
  const auto place = static_cast<int>(alpha - image.alpha.values.data());
  throw InputError(InputFault{
      image.path, 0, 0, "",
      "an alpha channel that is not 1 everywhere: " + rounded_text(static_cast<double>(*alpha) / image.full_scale, 4) +
          " at (" + std::to_string(place % image.alpha.width) + ", " + std::to_string(place / image.alpha.width) + ")",
      "--alpha ignore (compare colours as they are stored), --alpha compare (alpha too) or --alpha over:R,G,B "
      "(colours over this background)"});
}

bool is_premultiplied(const ColourImage& image, AlphaEncoding encoding) {
  return encoding == AlphaEncoding::by_format ? image.names_channels : encoding == AlphaEncoding::premultiplied;
}

/// Colour times alpha, plus what of the background is seen through; alpha and background count to 1.
void blend(ColourImage& image, AlphaEncoding from, const std::array<double, 3>& background) {
  const bool premultiplied = is_premultiplied(image, from);
  Image<float>& colour = image.colour;
  const auto channels = static_cast<std::size_t>(colour.channels);
  for (std::size_t i = 0; i < image.alpha.values.size(); ++i) {
    const double alpha = static_cast<double>(image.alpha.values[i]) / image.full_scale;
    for (std::size_t c = 0; c < channels; ++c) {
      float& value = colour.values[i * channels + c];
      const double own = static_cast<double>(value) * (premultiplied ? 1 : alpha);
      value = static_cast<float>(own + (1 - alpha) * background[c] * image.full_scale);
    }
  }
  // Half a step of the colour, and half a step of alpha times a colour of at most 1. No multiple of a step any more.
  image.precision.absolute *= 2;
  image.precision.relative *= 2;
  image.precision.step = 0;
}

void append_alpha(ColourImage& image) {
  const Image<float>& colour = image.colour;
  Image<float> result(colour.width, colour.height, colour.channels + 1);
  for (int y = 0; y < colour.height; ++y)
    for (int x = 0; x < colour.width; ++x) {
      float* const to = std::copy_n(colour.at(x, y), colour.channels, result.at(x, y));
      *to = image.alpha.empty() ? static_cast<float>(image.full_scale) : *image.alpha.at(x, y);
    }
  image.colour = std::move(result);
  image.names.push_back("A");
}

} // namespace

void resolve_alpha(ColourImage& a, ColourImage& b, const PairRequest& request, Image<float>& kept, NoteList& notes) {
  const bool any = !a.alpha.empty() || !b.alpha.empty();
  for (const ColourImage* const image : {&a, &b}) {
    const float* const see_through = first_not_one(*image);
    if (see_through) {
      if (request.alpha == AlphaUse::refused_unless_one) refuse(*image, see_through);
      kept = image->alpha;
      for (float& alpha : kept.values) alpha = static_cast<float>(static_cast<double>(alpha) / image->full_scale);
    } else if (!image->alpha.empty() && request.alpha == AlphaUse::refused_unless_one &&
               (image == &a || a.path != b.path)) {
      notes.add({image->path, 0, "", "alpha is 1 everywhere and is left out"});
    }
  }
  switch (request.alpha) {
  case AlphaUse::refused_unless_one:
  case AlphaUse::ignored:
    break;
  case AlphaUse::composited:
    for (ColourImage* const image : {&a, &b})
      if (first_not_one(*image)) blend(*image, request.encoding, request.background);
    break;
  case AlphaUse::compared:
    if (!any) break;
    if (is_premultiplied(a, request.encoding) != is_premultiplied(b, request.encoding)) {
      ColourImage& straight = is_premultiplied(a, request.encoding) ? b : a;
      if (first_not_one(straight)) {
        blend(straight, AlphaEncoding::straight, {0, 0, 0});
        notes.add({straight.path, 0, "", "colours are multiplied by alpha, as those of the other file are"});
      }
    }
    append_alpha(a);
    append_alpha(b);
  }
  a.alpha = b.alpha = {};
}

} // namespace refraster
