#include "verify/explain/explain_pixel.h"

#include "raster/resolve/rgb8.h"
#include "raster/shade/shade.h"
#include "shading/srgb_curve.h"
#include "verify/explain/candidates.h"
#include "verify/explain/fragment_story.h"
#include "verify/explain/would_be.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

/// So many candidates are shaded: more are behind each other only in scenes of which nobody wants to know.
constexpr std::size_t max_shaded_candidates = 8;
constexpr std::size_t max_near_misses = 3;

/// The pixel as a frame of that precision has it: by the shading that makes frames.
PrecisionStory precision_story(const FrameContext& context, const VisibleTile& visible, Precision precision) {
  PrecisionStory story{precision, {}, {}, {}};
  const std::unique_ptr<TileShading> shading = make_tile_shading(precision);
  Frame frame;
  frame.rgb8 = Image<std::uint8_t>(1, 1, 3);
  frame.radiance_double = Image<double>(1, 1, 3);
  FrameCounts counts;
  TileSeconds seconds;
  for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
    RenderOptions options = context.options;
    options.precision = precision;
    options.transfer = transfer;
    shading->shade({{context.scene, options}, context.geometry, context.bins, context.shadows}, visible, frame,
                   {counts, seconds});
    std::array<int, 3>& levels = transfer == Transfer::srgb ? story.srgb : story.levels;
    std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), levels.begin());
  }
  const std::vector<double>& rgb = frame.radiance_double.values;
  story.radiance = {rgb[0], rgb[1], rgb[2]};
  return story;
}

/// In place of shading a frame of one pixel: writes down what it sees.
class StoryShading final : public TileShading {
public:
  explicit StoryShading(PixelStory& story) : story_(story) {}

  void shade(const FrameContext& context, const VisibleTile& visible, Frame&, const TileMeasures&) override {
    const PixelRect& pixel = visible.tile;
    std::vector<std::pair<std::uint32_t, int>> seen; // triangles and how many samples see them
    for (std::size_t s = 0; s < context.samples.size(); ++s) {
      const std::int32_t slot = visible.visibility.nearest(static_cast<int>(s), 0, 0);
      const std::optional<std::uint32_t> number =
          slot == nothing ? std::nullopt : std::optional(visible.triangles[static_cast<std::size_t>(slot)]);
      if (!number) ++story_.background_samples;
      else if (const auto at = std::find_if(seen.begin(), seen.end(), [&](auto& t) { return t.first == *number; });
               at != seen.end())
        ++at->second;
      else seen.emplace_back(*number, 1);
      story_.sample_stories.push_back(sample_story(context, context.samples[s], number));
    }
    for (const auto& [number, samples] : seen)
      story_.fragments.push_back(fragment_story(context, number, pixel.x, pixel.y, samples));
    if (seen.empty()) story_.near_misses = near_misses(context, pixel.x, pixel.y, max_near_misses);
    for (const auto& [precision, name] : EnumNames<Precision>::names)
      story_.precisions.push_back(precision_story(context, visible, precision));
  }

private:
  SampleStory sample_story(const FrameContext& context, const SamplePosition& at,
                           std::optional<std::uint32_t> seen) const {
    const std::int32_t x = story_.x * subpixels + at.x, y = story_.y * subpixels + at.y;
    SampleStory result{x / double{subpixels}, y / double{subpixels}, {}};
    for (NumberedCandidate& found : candidates_at(context, x, y, seen)) {
      if (context.samples.size() == 1 && found.candidate.weights && result.candidates.size() < max_shaded_candidates)
        found.candidate.radiance = fragment_radiance(context, found.number, story_.x, story_.y);
      result.candidates.push_back(std::move(found.candidate));
    }
    return result;
  }

  PixelStory& story_;
};

RenderOptions options_of(const ExplainRequest& request) {
  RenderOptions options;
  options.width = request.width, options.height = request.height;
  options.crop = PixelRect{request.x, request.y, 1, 1};
  options.samples = request.samples;
  options.threads = 1;
  options.tile_size = 8;
  options.memory = request.memory;
  options.want_rgb8 = false;
  return options;
}

/// The linear value that s stands for, 1 being white.
double linear_of(double s, Transfer transfer) {
  return transfer == Transfer::srgb ? srgb_decoded(s) : s;
}
double encoded_of(double x, Transfer transfer) {
  return transfer == Transfer::srgb ? srgb_encoded(std::clamp(x, 0.0, 1.0)) : x;
}

/// Between which linear values the actual one lies. Whole numbers stand for what rounds to them, the first and the last
/// for everything beyond; floats for what rounds to them, and are linear.
ActualStory actual_story(const ActualPixel& actual, const Double3& radiance, Transfer of_levels) {
  ActualStory story;
  story.path = actual.path;
  story.stored = actual.stored;
  story.full_scale = actual.full_scale;
  const bool whole = actual.precision.saturates();
  const Transfer transfer = whole ? of_levels : Transfer::linear;
  const double largest = std::max({std::abs(actual.stored.x), std::abs(actual.stored.y), std::abs(actual.stored.z)});
  constexpr double infinity = std::numeric_limits<double>::infinity();
  story.same = true;
  for (int c = 0; c < 3; ++c) {
    const double stored = actual.stored[c], scale = actual.full_scale;
    if (whole) {
      story.least[c] = stored <= 0 ? -infinity : linear_of((stored - 0.5) / scale, transfer);
      story.most[c] = stored >= scale ? infinity : linear_of((stored + 0.5) / scale, transfer);
    } else {
      const double off = actual.precision.relative * largest;
      story.least[c] = stored - off, story.most[c] = stored + off;
    }
    story.levels[c] = 255 * stored / scale;
    story.difference[c] = story.levels[c] - 255 * encoded_of(radiance[c], transfer);
    story.same = story.same && radiance[c] >= story.least[c] && radiance[c] <= story.most[c];
  }
  return story;
}

} // namespace

PixelStory explain_pixel(const Scene& scene, const ExplainRequest& request, const std::optional<ActualPixel>& actual) {
  PixelStory story;
  story.x = request.x, story.y = request.y;
  story.width = request.width, story.height = request.height;
  story.samples = request.samples;
  story.transfer = request.transfer;
  story.background = scene.background;
  Frame frame;
  render_with(
      scene, options_of(request), [&] { return std::make_unique<StoryShading>(story); }, frame);
  if (actual) {
    story.actual = actual_story(*actual, story.in(Precision::double_).radiance, request.transfer);
    if (!story.actual->same) story.actual->would_be = what_would_be(story);
  }
  return story;
}

} // namespace refraster
