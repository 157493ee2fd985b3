#pragma once
// The frame: a scene becomes images.

#include <refraster/frame.h>
#include <refraster/memory.h>
#include <refraster/scene.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

/// Everything that a program calls, and what it passes and gets.
namespace refraster {

/// A rectangle of pixels; x, y from the top left.
struct PixelRect {
  int x = 0;      ///< of the leftmost column
  int y = 0;      ///< of the topmost row
  int width = 0;  ///< columns
  int height = 0; ///< rows
};

/// How radiance becomes levels: as it is, or by the curve of IEC 61966-2-1.
enum class Transfer { linear, srgb };

/// What a pixel shows where samples of it see no surface.
enum class Background {
  blended,    ///< the scene's background, in proportion to these samples
  transparent ///< nothing: colours are means over the samples that see a surface, 0 where none does; see Aov::alpha
};

/// What an AOV shows of a pixel of several samples.
enum class AovFilter {
  nearest, ///< the surface of the first sample that sees one
  resolve  ///< the mean over the samples that see one, where AovKind::mean says so
};

template <>
struct EnumNames<AovFilter> {
  static constexpr std::pair<AovFilter, std::string_view> names[] = {{AovFilter::nearest, "nearest"},
                                                                     {AovFilter::resolve, "resolve"}};
};

/// What is asked of a frame.
struct RenderOptions {
  int width = 1280;                         ///< of the full image: 1 to 16384 pixels
  int height = 720;                         ///< likewise
  std::optional<PixelRect> crop = {};       ///< within the image: only these pixels, with the same values
  Precision precision = Precision::double_; ///< of interpolation and shading
  int samples = 1;    ///< a pixel: 1, 2, 4, 8 or 16 at the standard positions; shaded once a triangle
  int threads = 0;    ///< 0: as many as the machine has
  int tile_size = 64; ///< 8 to 128, a power of two. Changes no pixel.
  // What to make. Only what is asked for is computed and takes memory.
  bool want_rgb8 = true;                     ///< 8-bit image
  bool want_radiance = false;                ///< float image
  bool want_radiance_double = false;         ///< the same before it is rounded to float, to measure a precision by
  Transfer transfer = Transfer::linear;      ///< of the 8-bit image
  std::vector<Aov> aovs = {};                ///< more images
  AovFilter aov_filter = AovFilter::nearest; ///< what these show of several samples
  Background background = Background::blended; ///< of all images of colours
  std::function<void(double)> progress = {}; ///< called with the fraction done, in [0, 1], from one thread at a time
  const std::atomic<bool>* cancel = nullptr; ///< when it becomes true, the frame is given up
  MemoryBudget memory = {};                  ///< asked for images and vertices
};

/// Renders frame after frame, and keeps its memory from one to the next: where frames are alike, none but the first
/// pays for it. A frame does not depend on the ones before. Not for several threads at once; each may have its own.
class Renderer {
public:
  Renderer();
  ~Renderer();
  /// Takes its memory.
  Renderer(Renderer&&) noexcept;
  /// Takes its memory.
  Renderer& operator=(Renderer&&) noexcept;

  /// Renders the scene into `frame`, whose images are used again if they are of the right size. Total: any finite or
  /// non-finite vertex, any scale. The same bits for every number of threads, tile size and crop. Pixels of a cancelled
  /// frame are those of this one or of the one before; of AOVs, those of this one or 0.
  /// Throws std::invalid_argument, with the first fault, for options out of their ranges and for a scene in which
  /// validate() finds something that is refused, before anything is drawn; OutOfMemory, if RenderOptions::memory does
  /// not allow what the frame is known to need. What a progress function throws, or std::bad_alloc, ends the frame and
  /// comes out. The next frame is not harmed.
  void render(const Scene& scene, const RenderOptions& options, Frame& frame);

private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// How many fragments of a precision are shaded at once, on the instruction set that this library was built for.
int precision_lanes(Precision precision);

/// A single frame.
Frame render(const Scene& scene, const RenderOptions& options);

} // namespace refraster
