#pragma once
// The pixel of another renderer's image, of which explain_pixel() says what it would take.

#include "verify/explain/explain_pixel.h"
#include "verify/images/colour_image.h"

#include <string>

namespace refraster {

/// Reads the image; what of it is left out is said in `notes`. layer: of an EXR file; empty: the one with the colour.
/// Throws InputError for a file that cannot be read, has no such layer or no colour.
ColourImage read_actual_image(const std::string& path, const std::string& layer, const MemoryBudget& memory,
                              NoteList& notes);

/// One pixel of it, which must be within.
ActualPixel actual_pixel(const ColourImage& image, int x, int y);

} // namespace refraster
