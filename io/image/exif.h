#pragma once
// What a camera says of how it was held.

#include "io/image/image_reading.h"

namespace refraster {

/// The tag Orientation, 1 to 8, of EXIF data as a JPEG's APP1 segment has them behind "Exif\0\0", and a PNG's chunk
/// eXIf from its beginning: a TIFF structure. 1, which is "as stored", where there is none, or where the data are
/// damaged. CIPA DC-008 (EXIF 2.32), 4.6.4 A; TIFF 6.0, section 2.
int exif_orientation(std::string_view tiff);

/// Adds the note that the orientation is not applied, unless it is 1.
void note_orientation(ImageFile& image, const std::string& path, int orientation);

} // namespace refraster
