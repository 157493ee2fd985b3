#pragma once
// Several images as the layers of one OpenEXR file.

#include <refraster/files.h>

#include "io/image/image_rows.h"

#include <span>
#include <string>
#include <vector>

namespace refraster {

/// What the channels of a layer are stored as.
enum class LayerValues { floats, uint32 };

/// Some channels of an OpenEXR file.
struct ExrLayer {
  ImageRows<float> image;
  std::vector<std::string> channels;        // their full names, "N.X"; as many as the image has
  LayerValues values = LayerValues::floats; // uint32: the image holds whole numbers that are
};

/// Writes images of one size as the layers of one OpenEXR file, as a whole or not at all. No more than some rows for
/// each thread are in memory at a time. Throws OutputError, and what reading rows throws.
void write_exr_layers(const std::string& path, std::span<const ExrLayer> layers, const WriteOptions& options);

} // namespace refraster
