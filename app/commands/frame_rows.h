#pragma once
// What the files of a frame are written from: the rows of its images, wherever these are.

#include <refraster/render.h>

#include "app/commands/write_frame.h"
#include "io/image/image_rows.h"

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace refraster {

/// The image, of 3 channels and of what output_values() says, before any alpha is added; and the AOVs that its files
/// ask for, once each. Where they are in a frame, it must outlive this.
struct FrameRows {
  std::variant<ImageRows<std::uint8_t>, ImageRows<std::uint16_t>, ImageRows<float>> image;
  std::vector<std::pair<Aov, ImageRows<float>>> aovs;

  /// Which must be there.
  const ImageRows<float>& rows_of(Aov aov) const;
};

/// Of a frame that was rendered with options that ask_for_output() has completed.
FrameRows rows_of(const FrameFiles& files, const std::string& output, const RenderOptions& options, const Frame& frame);

/// Writes the image and the AOVs, and gives the paths: write_frame(). Throws OutputError, std::bad_alloc, and what
/// reading rows throws.
std::vector<std::string> write_frame_rows(const FrameFiles& files, const std::string& output, Transfer transfer,
                                          int threads, const FrameRows& rows);

} // namespace refraster
