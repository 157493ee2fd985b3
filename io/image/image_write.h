#pragma once
// Writing images of more types, and in more ways, than <refraster/files.h> offers to everybody.

#include <refraster/image.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace refraster {

/// What a file says that its colours are encoded by; no value depends on it.
enum class StatedCurve {
  none, // nothing: shown as they are, as OpenGL's default framebuffer shows them
  srgb  // IEC 61966-2-1: a PNG's chunk sRGB
};

/// How whole numbers are written.
struct WriteOptions {
  StatedCurve curve = StatedCurve::none; // stated by `.png`; the other formats have no place for it
  int jpeg_quality = 95;                 // 1 to 100; above 90 colours have the resolution of the image
  int threads = 0;                       // 0: as many as the machine has. The file is the same for any number
};

/// As write_image(path, image) of <refraster/files.h>, in the format that the path's extension says: `.png`, 8 or 16 bits
/// and 1 (grey), 2 (grey, alpha), 3 (RGB) or 4 channels (RGB, alpha, straight); `.jpg`, 8 bits and 3 channels, lossy;
/// `.npy`, any channels and bits. Throws OutputError; InputError for another extension or number of channels.
void write_image(const std::string& path, const Image<std::uint8_t>& image, const WriteOptions& options);
void write_image(const std::string& path, const Image<std::uint16_t>& image, const WriteOptions& options = {});
void write_image(const std::string& path, const Image<std::uint32_t>& image, const WriteOptions& options = {});

/// What the channels of a layer are stored as.
enum class LayerValues { floats, uint32 };

/// Some channels of an OpenEXR file.
struct ExrLayer {
  const Image<float>* image = nullptr;
  std::vector<std::string> channels; // their full names, "N.X"; as many as the image has
  LayerValues values = LayerValues::floats; // uint32: the image holds whole numbers that are
};

/// Writes images of one size as the layers of one OpenEXR file, as a whole or not at all. Throws OutputError.
void write_exr_layers(const std::string& path, std::span<const ExrLayer> layers);

} // namespace refraster
