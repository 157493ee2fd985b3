// make_strip OUT.png IN.png …: images of one height side by side.

#include <refraster/files.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

namespace refraster {
namespace {

constexpr int gap = 4; // pixels, black

Image<std::uint8_t> strip(const std::vector<Image<float>>& images) {
  int width = -gap;
  for (const Image<float>& image : images) {
    if (image.height != images[0].height || image.channels != 3)
      throw std::runtime_error("found images of different heights or not of three channels");
    width += image.width + gap;
  }
  Image<std::uint8_t> result(width, images[0].height, 3);
  int left = 0;
  for (const Image<float>& image : images) {
    for (int y = 0; y < image.height; ++y)
      std::transform(image.at(0, y), image.at(0, y) + image.width * 3, result.at(left, y),
                     [](float level) { return static_cast<std::uint8_t>(level); });
    left += image.width + gap;
  }
  return result;
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: make_strip OUT.png IN.png ...\n";
    return 2;
  }
  try {
    std::vector<refraster::Image<float>> images;
    for (int i = 2; i < argc; ++i) images.push_back(refraster::read_image(argv[i]).values);
    refraster::write_image(argv[1], refraster::strip(images));
    std::cout << argv[1] << "\n";
  } catch (const std::exception& error) {
    std::cerr << "make_strip: " << error.what() << "\n";
    return 3;
  }
}
