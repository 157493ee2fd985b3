#include "verify/hypotheses/tally.h"

#include "raster/parallel.h"
#include "shading/srgb_curve.h"
#include "verify/hypotheses/fit.h"
#include "verify/transformations/whole_pixel_shift.h"

#include <algorithm>
#include <cmath>

namespace refraster::hypotheses {
namespace {

/// An object is suspect if at least so many of the unexplained pixels belong to it: a stray one is no reason to change
/// an object that is all right.
constexpr double min_suspect_share = 0.01;

/// The most common ratio of the actual and the right values, where neither is near an end of its range: their median.
double common_scale(const std::vector<JudgedPixel>& pixels) {
  std::vector<double> ratios;
  for (const JudgedPixel& pixel : pixels)
    for (int c = 0; c < 3; ++c)
      if (pixel.reference[c] > 1.0 / 32 && pixel.reference[c] < 1 && pixel.actual[c] < 1)
        ratios.push_back(pixel.actual[c] / pixel.reference[c]);
  if (ratios.empty()) return 1;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  // An image that is black, or nearly, is no copy of the right one.
  constexpr double min_scale = 1.0 / 64;
  return *middle >= min_scale ? *middle : 1;
}

/// So many of them, evenly spread.
template <class Add>
void spread(std::size_t all, std::size_t wanted, const Add& add) {
  const std::size_t count = std::min(all, wanted);
  for (std::size_t i = 0; i < count; ++i) add(i * all / count);
}

} // namespace

Tallying::Tallying(const RankRequest& request)
    : request_(request), image_{request.width, request.height, request.samples},
      threads_(thread_count({.threads = request.threads})),
      prepared_(request.scene), setting_{request.scene, prepared_, request.transfer, common_scale(request.unexplained),
                                         std::vector<bool>(request.scene.objects.size(), false)} {
  find_suspects();
  find_shift();
}

const WindowGeometry& Tallying::geometry(View view) {
  const Projection wanted = projection_of(view, request_.scene, image_);
  for (const auto& [projection, geometry] : geometries_)
    if (projection == wanted) return *geometry;
  Scene scene = request_.scene;
  scene.camera = wanted.camera;
  geometries_.emplace_back(wanted,
                           std::make_unique<WindowGeometry>(scene, wanted.width, wanted.height, request_.threads));
  return *geometries_.back().second;
}

std::vector<Tallying::Place> Tallying::places(View view, std::span<const Judged> pixels) {
  std::vector<Place> result(pixels.size());
  std::vector<WindowPoint> points;
  // As far as both sides' rounding may move a corner.
  const auto& raster = request_.device.raster;
  const auto step = static_cast<std::int32_t>(std::ceil(0.5 + raster.lattice * raster.snap_steps * subpixels));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    result[i].taps = taps_of(view, request_.scene, image_, shift_, pixels[i].pixel->x, pixels[i].pixel->y);
    constexpr WindowPoint beside[PixelColours::alternatives] = {{0, 0}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
    for (const WindowPoint& moved : beside)
      for (const Tap& tap : result[i].taps)
        points.push_back({tap.seen.x + step * moved.x, tap.seen.y + step * moved.y});
  }
  std::vector<std::vector<Covering>> covering = geometry(view).covering(points);
  auto next = covering.begin();
  for (Place& place : result) {
    const auto count = static_cast<std::ptrdiff_t>(place.taps.size() * PixelColours::alternatives);
    place.covering.assign(std::make_move_iterator(next), std::make_move_iterator(next + count));
    next += count;
  }
  return result;
}

void Tallying::find_suspects() {
  std::vector<Judged> all;
  for (const JudgedPixel& pixel : request_.unexplained) all.push_back({&pixel, false});
  for (const JudgedPixel& pixel : request_.explained) all.push_back({&pixel, true});
  const std::vector<Place> right = places(View::right, all);
  const std::size_t objects = request_.scene.objects.size();
  std::vector<std::size_t> owned(objects + 1, 0); // the last: of the background
  std::vector<std::size_t> owner(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint32_t object =
        PixelColours(setting_, geometry(View::right), right[i].taps, right[i].covering).object({});
    owner[i] = object == no_object ? objects : object;
    owned[owner[i]] += !all[i].explained;
  }
  const auto is_suspect = [&](std::size_t count) {
    return count > 0 &&
           static_cast<double>(count) >= min_suspect_share * static_cast<double>(request_.unexplained.size());
  };
  for (std::size_t i = 0; i < objects; ++i) setting_.suspect[i] = is_suspect(owned[i]);
  setting_.background_suspect = is_suspect(owned[objects]);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].explained && is_suspect(owned[owner[i]])) of_suspects_.push_back(all[i].pixel);
}

/// As `compare` finds it. Without the image there is none.
void Tallying::find_shift() {
  if (!request_.actual) return;
  RenderOptions options;
  options.width = image_.width, options.height = image_.height, options.samples = image_.samples;
  options.threads = request_.threads;
  options.want_rgb8 = false, options.want_radiance = true;
  Image<float> right = render(request_.scene, options).radiance;
  for (float& value : right.values) {
    const double x = std::clamp(static_cast<double>(value), 0.0, 1.0);
    if (request_.transfer == Transfer::srgb) value = static_cast<float>(srgb_encoded(x));
  }
  const StoredPrecision precision = StoredPrecision::floats(0x1p-24);
  const auto shifts = likely_shifts({right, 1, precision}, {*request_.actual, 1, precision}, 1);
  for (const PixelShift& shift : shifts)
    if (shift.x != 0 || shift.y != 0) {
      shift_ = {shift.x, shift.y};
      return;
    }
}

std::vector<Tallying::Judged> Tallying::chosen(std::size_t pixels) const {
  std::vector<Judged> result;
  spread(request_.unexplained.size(), pixels, [&](std::size_t i) {
    result.push_back({&request_.unexplained[i], false});
  });
  spread(of_suspects_.size(), pixels, [&](std::size_t i) { result.push_back({of_suspects_[i], true}); });
  return result;
}

std::vector<Tally> Tallying::over(std::span<const Steps> steps, std::size_t pixels) {
  const std::vector<Judged> judged = chosen(pixels);
  std::vector<Tally> tallies(steps.size());
  std::vector<std::vector<Fit>> fits(judged.size(), std::vector<Fit>(steps.size()));
  std::vector<Double3> noise(judged.size());
  {
    const std::vector<Place> right = places(View::right, judged);
    const WindowGeometry& seen = geometry(View::right);
    parallel_for(threads_, judged.size(), [&](std::size_t i, int) {
      PixelColours colours(setting_, seen, right[i].taps, right[i].covering);
      noise[i] = noise_of(colours, {}, request_);
    });
  }
  for (int v = 0; v < static_cast<int>(View::count_); ++v) {
    const auto view = static_cast<View>(v);
    if (std::none_of(steps.begin(), steps.end(), [&](const Steps& s) { return s.view == view; })) continue;
    const std::vector<Place> place = places(view, judged);
    const WindowGeometry& seen = geometry(view);
    parallel_for(threads_, judged.size(), [&](std::size_t i, int) {
      PixelColours colours(setting_, seen, place[i].taps, place[i].covering);
      for (std::size_t s = 0; s < steps.size(); ++s)
        if (steps[s].view == view) fits[i][s] = fit_of(colours, *judged[i].pixel, noise[i], steps[s], request_);
    });
  }
  for (std::size_t i = 0; i < judged.size(); ++i)
    for (std::size_t s = 0; s < steps.size(); ++s) {
      Tally& tally = tallies[s];
      const Fit& fit = fits[i][s];
      ++(judged[i].explained ? tally.explained : tally.unexplained);
      if (fit.fits) ++(judged[i].explained ? tally.kept : tally.fits);
      if (judged[i].explained) continue;
      const JudgedPixel& pixel = *judged[i].pixel;
      double away = 0;
      for (int c = 0; c < 3; ++c) away = std::max(away, std::abs(pixel.actual[c] - pixel.reference[c]));
      if (away > 0) tally.nearer += std::clamp(1 - fit.distance / away, -1.0, 1.0);
    }
  return tallies;
}

} // namespace refraster::hypotheses
