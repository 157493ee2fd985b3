#pragma once
// Parts of an image, joined.

#include "app/commands/frame_rows.h"
#include "app/diagnostics.h"
#include "io/parts/image_part.h"

#include <string>
#include <vector>

namespace refraster {

/// Writes the rows of a part, AOVs included; the header's images are filled in. Throws OutputError.
void write_part(const std::string& path, PartHeader header, const FrameRows& rows);

/// What is known to be the whole of an image.
struct WholeImage {
  std::vector<ImagePart> parts; // from the top down
  FrameFiles files;             // as the options of `render` said
  Transfer transfer = Transfer::linear;
};

/// Reads the headers of parts, in any order, and all of their values. Throws InputError with what is missing, there
/// twice, of another image than the first, or not what was written.
WholeImage read_parts(const std::vector<std::string>& paths);

/// Throws UsageError unless `render` would write these values to a file of this name.
void check_whole_output(const WholeImage& whole, const std::string& output);

/// Writes the image and its AOVs as `render -o OUTPUT` would, and gives the paths. Reads rows as they are written: a
/// few for each thread are in memory, and all of an 8-bit image only where its format wants that. Throws InputError,
/// OutputError, OutOfMemory.
std::vector<std::string> write_whole(WholeImage whole, const std::string& output, int threads,
                                     const MemoryBudget& memory);

} // namespace refraster
