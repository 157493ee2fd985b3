#pragma once
// A device's image from files.

#include <refraster/notes.h>

#include "verify/images/image_pair.h"
#include "verify/verdict/verdict.h"

namespace refraster {

/// Which row of an image is the first in its file.
enum class RowOrder { top_first, bottom_first };

/// Files, and how they are to be read.
struct DeviceImageRequest {
  std::string colour, ids, depth; // paths; ids and depth may be empty
  Transfer transfer = Transfer::linear;
  RowOrder rows = RowOrder::top_first;           // of all three
  AlphaUse alpha = AlphaUse::refused_unless_one; // not `compared`
  std::array<double, 3> background = {0, 0, 0};  // R G B, 1 is full scale; of AlphaUse::composited
  AlphaEncoding encoding = AlphaEncoding::by_format;
  std::string layer = {}; // of an EXR file
  MemoryBudget memory = {};
};

/// Reads them. Notes say what of the files is not judged. Throws InputError if one cannot be read, holds no colour, or
/// has another size than the first.
DeviceImage read_device_image(const DeviceImageRequest& request, NoteList& notes);

} // namespace refraster
