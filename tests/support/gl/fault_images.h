#pragma once
// Seeded faults as they show: drawn by llvmpipe, each on the first scene where it can be seen.

#include "tests/support/gl/seeded_faults.h"
#include "tests/support/scenes/fault_scenes.h"
#include "verify/verdict/verdict.h"

#include <optional>
#include <vector>

namespace refraster {

/// Of every image here.
inline constexpr FaultImageSize fault_image_size{128, 96};

/// Each of fault_scenes(), as llvmpipe draws it without a fault: 3 channels of radiance. Throws NoOpenGl.
std::vector<Image<float>> right_fault_images();

/// A fault on the first scene where it changes ten pixels by more than a level.
struct ShownFault {
  std::size_t scene = 0; ///< in fault_scenes()
  Image<float> image;    ///< that has the fault: 3 channels of radiance
};

/// Nothing if it shows nowhere. `right`: right_fault_images(). Throws NoOpenGl.
std::optional<ShownFault> shown_fault(const SeededFault& fault, const std::vector<Image<float>>& right);

enum class StoredAs { floats, rgb8 };

/// An image as a file of that kind holds it.
DeviceImage stored_image(const Image<float>& radiance, StoredAs as);

} // namespace refraster
