#include "verify/verdict/judge_pixel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace refraster {
namespace {

/// Combinations of what a pixel's samples may show that are tried one by one; of more, the hull of each sample counts.
constexpr std::size_t max_combinations = 512;

ColourBox hull(const ColourBox& a, const ColourBox& b) {
  return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

} // namespace

ColourBox PixelJudge::in_levels(const ColourBox& box) const {
  ColourBox result;
  for (int c = 0; c < 3; ++c) result.lo[c] = stored_.of(box.lo[c]), result.hi[c] = stored_.of(box.hi[c]);
  return result;
}

PixelBounds PixelJudge::bounds_of(const Surface& surface, const PixelPlace& at, BoundCauses causes) {
  if (surface) return bounder_.bounds(DeviceTriangle(frame_, *surface), at.x, at.y, causes);
  const Double3 background = frame_.scene().background;
  const double relative = frame_.profile().operations.relative;
  return {{background * (1 - relative), background * (1 + relative)}, false, false};
}

bool PixelJudge::matches_ids(const PixelCase& pixel, const Surface& surface) const {
  if (pixel.shown) return surface == pixel.shown;
  return !pixel.shows_background || !surface;
}

bool PixelJudge::matches_depth(const PixelCase& pixel, const Surface& surface) const {
  if (!pixel.depth) return true;
  if (!surface) return *pixel.depth == 1;
  const ValueRange range = DeviceTriangle(frame_, *surface).depth(pixel.at.x + 0.5, pixel.at.y + 0.5);
  return range.lo <= *pixel.depth && *pixel.depth <= range.hi;
}

/// Whether depth and colour are of that surface, on one side or the other of each comparison that is open.
PixelJudge::Match PixelJudge::match(const PixelCase& pixel, const Surface& surface) {
  if (!matches_depth(pixel, surface)) return Match::no;
  const PixelBounds bounds = bounds_of(surface, pixel.at);
  const auto is_one = [&](const PixelBounds& path) { return is_within(path.colour, pixel); };
  if (is_one(bounds) &&
      (!bounds.open || bounder_.for_each_path(DeviceTriangle(frame_, *surface), pixel.at.x, pixel.at.y, is_one)))
    return Match::yes;
  return bounds.undefined ? Match::undefined : Match::no;
}

/// First as if every comparison with a shadow map went as the reference's.
PixelClass PixelJudge::by_own_surface(const PixelCase& pixel, std::uint32_t number, JudgedDetail& detail) {
  if (!frame_.shadows()) return by_own_surface(pixel, number, BoundCauses::all(), detail);
  const PixelClass found = by_own_surface(pixel, number, BoundCauses::all().without(BoundCause::shadows), detail);
  if (found != PixelClass::unexplained) return found;
  const PixelClass with_open = by_own_surface(pixel, number, BoundCauses::all(), detail);
  const bool explained =
      with_open == PixelClass::shading || with_open == PixelClass::texel || with_open == PixelClass::branch;
  return explained ? PixelClass::shadow : with_open;
}

PixelClass PixelJudge::by_own_surface(const PixelCase& pixel, std::uint32_t number, BoundCauses causes,
                                      JudgedDetail& detail) {
  const TriangleRef ref = frame_.triangle(number);
  const Material& material = material_of(frame_.scene().objects[ref.object], ref.triangle);
  const auto explained = [&](PixelClass found) {
    double apart = 0;
    for (int c = 0; c < 3; ++c)
      apart = std::max(apart, std::abs(std::round(stored_.of(pixel.reference[c])) - pixel.actual[c]));
    return stored_.is_integer() && apart <= stored_.step() ? PixelClass::rounding : found;
  };
  const DeviceTriangle triangle(frame_, number);
  const bool textured = is_textured(material);
  if (textured) {
    const BoundCauses as_filtered = causes.without(BoundCause::texture).without(BoundCause::level_of_detail);
    const PixelBounds bounds = bounder_.bounds(triangle, pixel.at.x, pixel.at.y, as_filtered);
    detail.allowed = in_levels(bounds.colour);
    if (bounds.colour.is_finite() && !bounds.open && is_within(bounds.colour, pixel))
      return explained(PixelClass::shading);
  }
  const PixelBounds bounds = bounder_.bounds(triangle, pixel.at.x, pixel.at.y, causes);
  detail.allowed = in_levels(bounds.colour);
  if (!is_within(bounds.colour, pixel)) return bounds.undefined ? PixelClass::undefined : PixelClass::unexplained;
  if (!bounds.open) {
    if (!(detail.allowed.width() <= unverifiable_levels)) return PixelClass::unverifiable;
    return explained(textured ? PixelClass::texel : PixelClass::shading);
  }
  double width = 0;
  const auto is_one = [&](const PixelBounds& path) {
    if (!is_within(path.colour, pixel)) return false;
    width = in_levels(path.colour).width();
    return true;
  };
  if (!bounder_.for_each_path(triangle, pixel.at.x, pixel.at.y, is_one, causes))
    return bounds.undefined ? PixelClass::undefined : PixelClass::unexplained;
  if (!(width <= unverifiable_levels)) return PixelClass::unverifiable;
  const bool of_texels =
      any_texture(material, [](const TextureMap& map) { return map.filter == TextureFilter::nearest; });
  return explained(of_texels ? PixelClass::texel : PixelClass::branch);
}

PixelClass PixelJudge::by_other_surface(const PixelCase& pixel, JudgedDetail& detail) {
  const VisibleSet& set = *pixel.samples[0];
  const auto ours = std::find_if(set.candidates.begin(), set.candidates.end(),
                                 [&](const Candidate& c) { return pixel.ours == c.number; });
  const bool ours_is_certain = ours != set.candidates.end() && ours->certain;
  bool any_surface = false, any_undefined = false;
  const auto look = [&](const Surface& surface) {
    if (surface == pixel.ours || !matches_ids(pixel, surface)) return false;
    any_surface = true;
    const Match found = match(pixel, surface);
    any_undefined |= found == Match::undefined;
    return found == Match::yes;
  };
  if (set.background && look(std::nullopt)) return PixelClass::edge;
  for (const Candidate& c : set.candidates)
    if (look(c.number)) return c.certain && ours_is_certain ? PixelClass::depth : PixelClass::edge;
  if (any_undefined) return PixelClass::undefined; // it may be seen, and then have any colour
  const bool ours_may_be =
      (ours != set.candidates.end() || (!pixel.ours && set.background)) && matches_ids(pixel, pixel.ours);
  detail.objection = !any_surface && !ours_may_be ? Objection::surface : Objection::colour;
  return PixelClass::unexplained;
}

/// The mean of what the samples show, each one of its set: in every combination.
PixelClass PixelJudge::by_samples(const PixelCase& pixel, JudgedDetail& detail) {
  std::map<Surface, PixelBounds> bounds;
  std::vector<std::vector<const ColourBox*>> choices;
  std::size_t combinations = 1;
  bool edges = false, undefined = false, open = false;
  const auto box_of = [&](const Surface& surface) {
    const auto [at, is_new] = bounds.try_emplace(surface);
    if (is_new) at->second = bounds_of(surface, pixel.at);
    undefined |= at->second.undefined, open |= at->second.open;
    return &at->second.colour;
  };
  for (const VisibleSet* set : pixel.samples) {
    auto& options = choices.emplace_back();
    if (set->background) options.push_back(box_of(std::nullopt));
    for (const Candidate& c : set->candidates) options.push_back(box_of(c.number)), edges |= !c.certain;
    combinations = std::min(combinations * options.size(), max_combinations + 1);
  }
  const double weight = 1.0 / static_cast<double>(pixel.samples.size());
  // A driver may take the mean in its own format: by one step more.
  const double resolve = stored_.is_integer() ? stored_.step() / 255 : 0;
  const auto is_mean_within = [&](const std::vector<ColourBox>& of_samples, double brightest) {
    ColourBox mean{Double3(-resolve), Double3(resolve)};
    for (const ColourBox& box : of_samples)
      mean.lo += glm::min(box.lo, brightest) * weight, mean.hi += glm::min(box.hi, brightest) * weight;
    detail.allowed = in_levels(mean);
    return is_within(mean, pixel);
  };
  // A target of integers cuts each sample off at 1 before the mean; one of floats does not.
  const auto mean_is_within = [&](const std::vector<ColourBox>& of_samples) {
    return is_mean_within(of_samples, std::numeric_limits<double>::infinity()) ||
           (stored_.is_integer() && is_mean_within(of_samples, 1));
  };
  std::vector<ColourBox> chosen(choices.size());
  bool found = false;
  if (combinations > max_combinations) {
    for (std::size_t s = 0; s < choices.size(); ++s) {
      chosen[s] = *choices[s][0];
      for (const ColourBox* box : choices[s]) chosen[s] = hull(chosen[s], *box);
    }
    found = mean_is_within(chosen);
  } else {
    std::vector<std::size_t> at(choices.size(), 0);
    for (bool more = true; more && !found;) {
      for (std::size_t s = 0; s < choices.size(); ++s) chosen[s] = *choices[s][at[s]];
      found = mean_is_within(chosen);
      std::size_t s = 0;
      while (s < at.size() && ++at[s] == choices[s].size()) at[s++] = 0;
      more = s < at.size();
    }
  }
  if (!found) return undefined ? PixelClass::undefined : PixelClass::unexplained;
  if (!(detail.allowed.width() <= unverifiable_levels)) return PixelClass::unverifiable;
  if (combinations > 1) return edges ? PixelClass::edge : PixelClass::depth;
  return open ? PixelClass::branch : PixelClass::shading;
}

JudgedDetail PixelJudge::judge(const PixelCase& pixel) {
  JudgedDetail detail;
  detail.x = pixel.at.x, detail.y = pixel.at.y;
  detail.actual = pixel.actual;
  for (int c = 0; c < 3; ++c) detail.reference[c] = stored_.of(pixel.reference[c]);
  detail.allowed = {detail.reference, detail.reference};
  detail.surfaces = 0;
  for (const VisibleSet* set : pixel.samples)
    detail.surfaces = std::max(detail.surfaces, static_cast<int>(set->candidates.size()) + (set->background ? 1 : 0));
  if (pixel.samples.size() > 1) {
    detail.found = by_samples(pixel, detail);
    return detail;
  }
  const VisibleSet& set = *pixel.samples[0];
  detail.found = PixelClass::unexplained;
  const bool ours_is_seen = pixel.ours && std::any_of(set.candidates.begin(), set.candidates.end(),
                                                      [&](const Candidate& c) { return c.number == *pixel.ours; });
  if (ours_is_seen && matches_ids(pixel, pixel.ours)) {
    detail.found = by_own_surface(pixel, *pixel.ours, detail);
    if (detail.found != PixelClass::unexplained && !matches_depth(pixel, pixel.ours)) {
      detail.found = PixelClass::unexplained;
      detail.objection = Objection::depth;
    }
  } else if (!pixel.ours && set.background && matches_ids(pixel, std::nullopt) &&
             match(pixel, std::nullopt) == Match::yes) {
    detail.found = PixelClass::rounding;
  }
  if (detail.found == PixelClass::unexplained) {
    const Objection before = detail.objection;
    detail.found = by_other_surface(pixel, detail);
    if (before == Objection::depth) detail.objection = before;
  }
  return detail;
}

} // namespace refraster
