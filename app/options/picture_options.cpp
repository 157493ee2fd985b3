#include "app/options/picture_options.h"

#include <string>
#include <vector>

namespace refraster {

Picture PictureArguments::over(const Picture& of_scene) const {
  Picture picture = of_scene;
  if (size) picture.width = size->width, picture.height = size->height;
  if (samples) picture.samples = *samples;
  if (transfer) picture.transfer = *transfer;
  check_frame_samples(picture.width, picture.height, picture.samples);
  return picture;
}

Option size_option(PictureArguments& picture, const std::string& meaning) {
  return parsed_option("--size", "WxH", picture.size, size_from,
                       "WIDTHxHEIGHT, each 1 to " + std::to_string(largest_side), meaning)
      .by_default("what the scene says, or 1280x720");
}

Option samples_option(PictureArguments& picture, const std::string& meaning) {
  static constexpr int counts[] = {1, 2, 4, 8, 16};
  std::vector<std::string> words;
  for (const int count : counts) words.push_back(std::to_string(count));
  return word_option(
             "--samples", words, [&picture](std::size_t i) { picture.samples = counts[i]; }, meaning)
      .by_default("what the scene says, or 1");
}

Option srgb_option(PictureArguments& picture, const std::string& meaning) {
  return flag(
      "--srgb", [&picture] { picture.transfer = Transfer::srgb; }, meaning);
}

Option linear_option(PictureArguments& picture) {
  return flag(
      "--linear", [&picture] { picture.transfer = Transfer::linear; }, "no sRGB curve, whatever the scene says");
}

} // namespace refraster
