#pragma once
// The image of an entry, wherever it comes from.

#include "suite/actions/actions.h"

namespace refraster::suite {

/// An 8-bit image of three channels, and beside it what a digest is taken of.
struct MadeImage {
  Image<std::uint8_t> rgb8;
  Image<float> radiance;
  Transfer transfer = Transfer::linear;
};

/// Whether the floats are wanted too.
enum class Floats { wanted, unwanted };

/// Renders it here, draws it by OpenGL, or reads it, as the entry says; the scene is placed for it.
MadeImage make_image_of(Task& task, Floats floats);

/// Writes it to the folder of results, and enters it into the result.
void write_made(Task& task, const MadeImage& made);

} // namespace refraster::suite
