#pragma once
// Image files.

#include <refraster/image.h>
#include <refraster/memory.h>

#include "io/file/notes.h"
#include "shading/texture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

/// An image as it is stored.
struct ImageFile {
  Image<float> values;               // 1 to 4 channels or, of an EXR file, as many as it has; row 0 at the top
  int bits = 8;                      // of a channel: 8, 16 or 32 (float)
  double full_scale = 255;           // the value that means 1: 255, 65535, or 1 for float
  std::vector<std::string> channels; // names, as R G B A, or Y for one channel
  bool names_channels = false;       // whether the file says them (EXR), or they follow from their number
  double unit_roundoff = 0x1p-24;    // of float values, relative to the largest of their pixel: half numbers 2^-11,
                                     // .hdr 2^-8; 8 and 16 bits have half a step instead
  NoteList notes;                    // what was read otherwise than it is stored
};

/// Reads any of the formats of io/image/image_formats.h: PNG, JPEG, TGA, BMP (8 or 16 bits), Radiance HDR, PFM, OpenEXR
/// (float). What it is, is seen from its content; docs/image-formats.md says what is read of each. Values are as
/// stored: no gamma, no colour profile and no EXIF orientation is applied. Throws InputError. The size it declares is
/// checked against the limits (io/file/limits.h), and against the size of the file, before any memory is taken.
ImageFile read_image(const std::string& path, const MemoryBudget& memory = {});

/// Reads an image of 8 or 16 bits, within limit::texture_side, as a texture with level 0 only: one channel becomes
/// grey, alpha is dropped. Else as read_image; its notes go to `notes`, if not null.
Texture read_texture(const std::string& path, const MemoryBudget& memory = {}, NoteList* notes = nullptr);

/// Writes whole numbers of 8 bits, with no colour profile, in the format that the path's extension says, in any case:
/// `.png`, 1 channel (grey) or 3 (RGB). Throws OutputError; InputError for another extension or number of channels.
void write_image(const std::string& path, const Image<std::uint8_t>& image);

/// Writes float values likewise: `.hdr` (3 channels, 8-bit mantissas: lossy), `.pfm` (1 or 3 channels), `.exr` (any
/// channels, 32-bit float). `channels` names those of a file that has names; by default R G B, or Y for a single one.
void write_image(const std::string& path, const Image<float>& image, std::vector<std::string> channels = {});

} // namespace refraster
