#include "verify/explain/bounds_story.h"

#include "verify/bounds/pixel_bounds.h"

#include <algorithm>
#include <cmath>

namespace refraster {

std::optional<BoundsStory> bounds_story(const Scene& scene, const ExplainRequest& request,
                                        const DeviceProfile& profile) {
  RenderOptions options;
  options.width = request.width, options.height = request.height;
  options.samples = request.samples, options.memory = request.memory;
  options.want_rgb8 = false;
  options.crop = PixelRect{request.x, request.y, 1, 1};
  options.aovs = {Aov::object, Aov::triangle};
  const Frame frame = render(scene, options);
  const auto object = static_cast<std::size_t>(frame.aovs[0].values[0]);
  if (object == 0) return std::nullopt;
  options.crop.reset();
  options.aovs.clear();
  const DeviceFrame device(scene, options, profile, ShaderMatrices::three);
  const DeviceTriangle triangle(device,
                                device.number_of(object - 1, static_cast<std::uint32_t>(frame.aovs[1].values[0]) - 1));
  PixelBounder bounder(device);
  const auto box_of = [&](BoundCauses causes) { return bounder.bounds(triangle, request.x, request.y, causes).colour; };
  const ColourBox all = box_of(BoundCauses::all());
  BoundsStory story{all.lo, all.hi, {}};
  double sum = 0;
  for (std::size_t i = 0; i < bound_cause_names.size(); ++i) {
    const double width = box_of(BoundCauses::only(static_cast<BoundCause>(i))).width();
    story.causes.push_back({std::string(bound_cause_names[i]), width});
    sum += width;
  }
  const bool tells = all.is_finite() && std::isfinite(sum) && sum > 0;
  if (!tells) story.causes.clear();
  for (BoundsStory::Cause& cause : story.causes) cause.fraction /= sum;
  std::erase_if(story.causes, [](const BoundsStory::Cause& cause) { return cause.fraction < 0.005; });
  std::stable_sort(story.causes.begin(), story.causes.end(),
                   [](const auto& a, const auto& b) { return a.fraction > b.fraction; });
  return story;
}

} // namespace refraster
