#pragma once
// PNG files: W3C, Portable Network Graphics, second edition; the pixels as zlib packs them (RFC 1950 and 1951).

#include <refraster/files.h>

#include <cstdint>
#include <string>

namespace refraster {

/// How hard zlib tries: its level, 1 to 9, and strategy.
struct PngPacking {
  int level, strategy;
};
/// Measured by bench/png on the gallery: see docs/image-formats.md.
extern const PngPacking png_packing;

/// The bytes of a PNG file of 1 (grey), 2 (grey, alpha), 3 (RGB) or 4 (RGB, alpha) channels of 8 or 16 bits, not
/// interlaced. Chunks: IHDR, sRGB where `options` say so, IDAT, IEND. The same bytes for any number of threads: rows
/// are packed in strips whose height follows from the image's size alone, each with the 32 KiB before it as its
/// dictionary. Takes the memory of the file, and of eight strips a thread. Throws std::bad_alloc.
std::string png_file(const Image<std::uint8_t>& image, const WriteOptions& options,
                     const PngPacking& packing = png_packing);
std::string png_file(const Image<std::uint16_t>& image, const WriteOptions& options,
                     const PngPacking& packing = png_packing);

} // namespace refraster
