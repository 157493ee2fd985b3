#include "verify/hypotheses/pixel_colours.h"

#include "shading/srgb_curve.h"

#include <cmath>

namespace refraster::hypotheses {
namespace {

/// In which a depth test LEQUAL finds two depths equal: two steps of a float just below 1, of a depth that changes by
/// near / w at most.
constexpr double equal_depth = 0x1p-23;

struct DepthRange {
  double near, far;
};
DepthRange depth_range(const Camera& camera, DepthPlanes planes) {
  switch (planes) {
  case DepthPlanes::right:
    break;
  case DepthPlanes::near_farther:
    return {camera.near * 10, camera.far};
  case DepthPlanes::near_nearer:
    return {camera.near / 10, camera.far};
  case DepthPlanes::far_nearer:
    return {camera.near, camera.far / 10};
  case DepthPlanes::far_farther:
    return {camera.near, camera.far * 10};
  }
  return {camera.near, camera.far};
}

bool is_cut_out(const Covering& covering, Opacity opacity) {
  switch (opacity) {
  case Opacity::right:
    return covering.opacity < covering.threshold;
  case Opacity::missing:
    return false;
  case Opacity::inverted:
    return 1 - covering.opacity < covering.threshold;
  }
  return false;
}

bool is_drawn(const Covering& covering, const Scene& scene, const Steps& steps, const DepthRange& range) {
  // The depth planes belong to what is drawn, up to rounding.
  constexpr double rounding = 1e-12;
  if (covering.object == steps.missing_object || covering.object == steps.other_missing_object) return false;
  if (!(covering.inverse_w * range.near <= 1 + rounding && covering.inverse_w * range.far >= 1 - rounding))
    return false;
  if (is_cut_out(covering, steps.opacity)) return false;
  const bool back = covering.facing == Facing::back;
  switch (steps.culling) {
  case Culling::right:
    return !(back && scene.objects[covering.object].cull == Cull::back);
  case Culling::off:
    return true;
  case Culling::back:
    return !back;
  case Culling::front:
    return back;
  }
  return true;
}

/// What is left of a hypothesis for objects that are all right: what is about the frame.
Steps of_the_frame(const Steps& steps) {
  Steps result;
  result.view = steps.view;
  result.depth_test = steps.depth_test, result.depth_planes = steps.depth_planes;
  result.culling = steps.culling, result.opacity = steps.opacity, result.missing_object = steps.missing_object;
  result.other_missing_object = steps.other_missing_object;
  return result;
}

/// Whether a shader does it, before values are stored.
bool in_shader(Output output) {
  return output == Output::gamma_encoded || output == Output::gamma_decoded || output == Output::red_blue_exchanged;
}

} // namespace

std::optional<Covering> seen_of(std::span<const Covering> covering, const Scene& scene, const Steps& steps) {
  const DepthRange range = depth_range(scene.camera, steps.depth_planes);
  std::optional<Covering> seen;
  const auto nearer = [&](const Covering& c) {
    switch (steps.depth_test) {
    case DepthTest::less:
      return c.inverse_w > seen->inverse_w;
    case DepthTest::lequal:
      return (c.inverse_w - seen->inverse_w) * scene.camera.near >= -equal_depth;
    case DepthTest::greater:
      return c.inverse_w < seen->inverse_w;
    case DepthTest::always:
      return true;
    }
    return false;
  };
  for (const Covering& c : covering)
    if (is_drawn(c, scene, steps, range) && (!seen || nearer(c))) seen = c;
  return seen;
}

bool PixelColours::differs(const Steps& steps, int alternative) const {
  for (std::size_t t = 0; t < taps_.size(); ++t) {
    const std::optional<Covering> first = seen(steps, 0, t), other = seen(steps, alternative, t);
    if (first.has_value() != other.has_value() || (first && first->triangle != other->triangle)) return true;
  }
  return false;
}

std::uint32_t PixelColours::object(const Steps& steps) const {
  const std::optional<Covering> first = seen(steps, 0, 0);
  return first ? first->object : no_object;
}

const Material& PixelColours::material_of_covering(const Covering& covering) const {
  const std::uint32_t first = geometry_.context().geometry.first_triangle[covering.object];
  return material_of(setting_.scene.objects[covering.object], covering.triangle - first);
}

bool PixelColours::has_mip_levels(const Steps& steps) const {
  for (std::size_t t = 0; t < taps_.size(); ++t)
    if (const std::optional<Covering> first = seen(steps, 0, t)) {
      const Material& material = material_of_covering(*first);
      const TextureMap& map = material.diffuse_map;
      if (map.texture && steps.texture_filter.value_or(map.filter) == TextureFilter::trilinear) return true;
    }
  return false;
}

SampleData<double>& PixelColours::data_of(std::uint32_t triangle) {
  for (auto& [number, data] : data_)
    if (number == triangle) return *data;
  data_.emplace_back(triangle, std::make_unique<SampleData<double>>(geometry_.context(), triangle));
  return *data_.back().second;
}

Rgb<double> PixelColours::linear(const Covering& covering, const Tap& tap, const Steps& steps, const Nudge& nudge,
                                 double dx, double dy) {
  SampleData<double>& data = data_of(covering.triangle);
  const auto x = static_cast<std::int32_t>(std::floor(tap.shaded_x)),
             y = static_cast<std::int32_t>(std::floor(tap.shaded_y));
  data.move_to(x, y, tap.shaded_x - x + dx, tap.shaded_y - y + dy);
  const FrameContext& context = geometry_.context();
  const Surface surface = surface_at(context, data, setting_.prepared, steps, nudge);
  return colour_of(context.scene, material_of_covering(covering), setting_.prepared, surface, steps, nudge);
}

Double3 PixelColours::stored(const Steps& steps, int alternative, const Nudge& nudge, double dx, double dy) {
  const Steps others = of_the_frame(steps);
  Rgb<double> sum(0);
  bool suspect = false;
  std::optional<Covering> last;
  Rgb<double> last_colour(0);
  for (std::size_t t = 0; t < taps_.size(); ++t) {
    const std::optional<Covering> covering = seen(steps, alternative, t);
    const bool here = covering ? setting_.suspect[covering->object] : setting_.background_suspect;
    suspect |= here;
    const Steps& applied = here ? steps : others;
    // Of several samples of a triangle each is shaded at the pixel's centre.
    const bool again = t > 0 && covering && last && covering->triangle == last->triangle &&
                       taps_[t].shaded_x == taps_[t - 1].shaded_x && taps_[t].shaded_y == taps_[t - 1].shaded_y;
    Rgb<double> colour = !covering ? setting_.scene.background
                         : again   ? last_colour
                                   : linear(*covering, taps_[t], applied, nudge, dx, dy);
    last = covering, last_colour = colour;
    if (in_shader(applied.output)) colour = output_of(colour, applied.output, setting_.scale);
    sum += colour / static_cast<double>(taps_.size());
  }
  if (setting_.transfer == Transfer::srgb)
    for (int c = 0; c < 3; ++c) sum[c] = srgb_encoded(std::min(std::max(sum[c], 0.0), 1.0));
  return suspect && !in_shader(steps.output) ? output_of(sum, steps.output, setting_.scale) : sum;
}

} // namespace refraster::hypotheses
