#pragma once
// Faults as people make them, to be planted in what OpenGL draws or in its image: what a verdict must not accept, and
// whose cause is to be named.

#include <refraster/image.h>
#include <refraster/scene.h>

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace refraster {

enum class FaultyStage { vertex, fragment };

/// Text of our own GLSL, and what stands there instead. In `to`, @WIDTH@ and @HEIGHT@ are those of the image,
/// @FIRST_TRIANGLE@ the number of triangles of all objects before, and @TRIANGLES@ that of all.
struct Replacement {
  FaultyStage stage;
  std::string_view from, to;
};

/// The size of an image in pixels.
struct FaultImageSize {
  int width = 0, height = 0;
};

/// One fault: in GLSL, in the scene that is drawn, or in the image that was made.
struct SeededFault {
  std::string_view name;
  /// Keys of the hypotheses that say what it is, any of them; none: no hypothesis covers it.
  std::vector<std::string_view> causes;
  std::vector<Replacement> glsl = {};
  Scene (*scene)(Scene right, const FaultImageSize& size) = nullptr;
  Image<float> (*image)(const Image<float>& right) = nullptr; // of values: before they are rounded to 8 bits
};

/// In GLSL first, then in scenes, then in images. Each changes nothing where what it is about is missing: a fault of
/// textures shows only on objects that have one.
const std::vector<SeededFault>& seeded_faults();

/// The scene as OpenGL is to draw it, instead of the right one that refraster draws: GLSL files are written to `folder`
/// and named by its objects. Nothing if no object's GLSL has the text that the fault is about. For a fault of images
/// the scene itself.
std::optional<Scene> with_fault(const Scene& right, const SeededFault& fault, const FaultImageSize& size,
                                const std::filesystem::path& folder);

} // namespace refraster
