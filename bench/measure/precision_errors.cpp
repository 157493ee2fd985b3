#include "bench/measure/precision_errors.h"

#include "bench/measure/image_error.h"
#include "math/precisions.h"
#include "raster/render_in.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace refraster::bench {
namespace {

Frame image(const SceneTask& task, std::string_view precision, int threads) {
  RenderOptions options;
  options.width = task.width, options.height = task.height;
  options.precision = value_named<Precision>(precision).value();
  options.threads = threads;
  options.want_radiance_double = true;
  if (precision == DoublePrecision::name) options.aovs = {Aov::object};
  return render(task.scene, options);
}

/// Some hundred of the pixels that show a surface, spread over all of them by the golden ratio: no two near each other
/// in the order of rows, no regular grid. Numbers of pixels in the order of rows, rising.
std::vector<std::size_t> chosen_pixels(const Frame& reference) {
  constexpr std::size_t most = 400;
  constexpr double golden = 0.6180339887498949;
  const Image<float>& objects = reference.aovs[0];
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < objects.values.size(); ++i)
    if (objects.values[i] > 0) shown.push_back(i);
  if (shown.size() <= most) return shown;
  std::set<std::size_t> pixels;
  for (std::size_t i = 0; pixels.size() < most; ++i) {
    const double turns = golden * static_cast<double>(i);
    pixels.insert(shown[static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(shown.size()))]);
  }
  return {pixels.begin(), pixels.end()};
}

/// The exact colours of chosen pixels.
class Answers {
public:
  Answers(const SceneTask& task, const Frame& reference, int threads) : pixels_(chosen_pixels(reference)) {
    colours_.resize(pixels_.size());
    const auto width = static_cast<std::size_t>(task.width);
    const auto place_of = [&](int x, int y) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      return std::lower_bound(pixels_.begin(), pixels_.end(), pixel);
    };
    RenderOptions options;
    options.width = task.width, options.height = task.height, options.threads = threads;
    SampleRequest<Exact> request;
    request.wanted = [&](int x, int y) {
      const auto place = place_of(x, y);
      return place != pixels_.end() && *place == static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    };
    request.take = [&](int x, int y, const Rgb<Exact>& rgb) {
      colours_[static_cast<std::size_t>(place_of(x, y) - pixels_.begin())] = rgb;
    };
    shade_in(task.scene, options, request);
  }

  ExactError error_of(const Frame& frame) const {
    ExactError error;
    error.pixels = pixels_.size();
    double sum = 0;
    std::size_t lit = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const double* const found = &frame.radiance_double.values[3 * pixels_[i]];
      Exact off(0), size(0);
      for (int c = 0; c < 3; ++c) {
        const Exact& exact = colours_[i][c];
        off = max(off, abs(Exact(found[c]) - exact));
        size = max(size, abs(exact));
        const double level = std::clamp(static_cast<double>(exact), 0.0, 1.0);
        error.max_levels = std::max(error.max_levels, 255 * std::abs(std::clamp(found[c], 0.0, 1.0) - level));
      }
      if (!(size > Exact(0))) continue; // black: nothing to be relative to, as in image_error
      const auto relative = static_cast<double>(off / size);
      error.max_relative = std::max(error.max_relative, relative);
      sum += relative, ++lit;
    }
    if (lit > 0) error.mean_relative = sum / static_cast<double>(lit);
    return error;
  }

private:
  std::vector<std::size_t> pixels_;
  std::vector<Rgb<Exact>> colours_;
};

} // namespace

std::vector<PrecisionError> precision_errors(const SceneTask& task, int threads) {
  std::vector<PrecisionError> errors;
  if (static_cast<std::uint64_t>(task.width) * static_cast<std::uint64_t>(task.height) > max_compared_pixels)
    return errors;
  const Frame reference = image(task, DoublePrecision::name, threads);
  const Answers answers(task, reference, threads);
  for (const std::string& precision : task.precisions) {
    PrecisionError& error = errors.emplace_back();
    error.precision = precision;
    if (precision == DoublePrecision::name) {
      error.against_exact = answers.error_of(reference);
      continue;
    }
    const Frame frame = image(task, precision, threads);
    error.against_double = image_error(frame, reference);
    error.against_exact = answers.error_of(frame);
  }
  return errors;
}

} // namespace refraster::bench
