#include "app/bench/rung_errors.h"

#include "app/bench/image_error.h"
#include "math/rungs.h"
#include "verify/oracle/pixel_oracle.h"

#include <algorithm>
#include <cmath>

namespace refraster::bench {
namespace {

Frame image(const SceneTask& task, std::string_view rung, int threads) {
  RenderOptions options;
  options.width = task.width, options.height = task.height;
  options.rung = rung;
  options.threads = threads;
  options.want_radiance_double = true;
  if (rung == DoubleRung::name) options.aovs = {Aov::object, Aov::triangle};
  return render(task.scene, options);
}

/// Whether the AOVs name each triangle.
bool are_numbered(const Scene& scene) {
  return std::all_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.mesh->triangles.size() <= most_numbered_triangles; });
}

/// Some hundred of the pixels that show a surface, spread over all of them by the golden ratio: no two near each other
/// in the order of rows, no regular grid.
std::vector<SeenPixel> chosen_pixels(const Frame& reference) {
  constexpr std::size_t most = 400;
  constexpr double golden = 0.6180339887498949;
  const Image<float>& objects = reference.aovs[0];
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < objects.values.size(); ++i)
    if (objects.values[i] > 0) shown.push_back(i);
  std::vector<SeenPixel> pixels;
  const std::size_t count = std::min(most, shown.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double turns = golden * static_cast<double>(i);
    const auto place =
        count < most ? i : static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(shown.size()));
    const std::size_t at = shown[place], width = static_cast<std::size_t>(objects.width);
    pixels.push_back({static_cast<int>(at % width), static_cast<int>(at / width),
                      static_cast<std::size_t>(objects.values[at]) - 1,
                      static_cast<std::size_t>(reference.aovs[1].values[at]) - 1});
  }
  return pixels;
}

/// The right colours of chosen pixels.
class Answers {
public:
  Answers(const SceneTask& task, const Frame& reference) {
    if (!are_numbered(task.scene)) return;
    pixels_ = chosen_pixels(reference);
    const PixelOracle oracle(task.scene, task.width, task.height);
    for (const SeenPixel& pixel : pixels_) colours_.push_back(oracle.radiance(pixel));
  }

  OracleError error_of(const Frame& frame) const {
    OracleError error;
    error.asked = pixels_.size();
    double sum = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      if (!colours_[i]) continue;
      ++error.followed;
      const double* const found = frame.radiance_double.at(pixels_[i].x, pixels_[i].y);
      double off = 0, size = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Twofold<double>& exact = (*colours_[i])[c];
        off = std::max(off, std::abs((found[c] - exact.hi) - exact.lo));
        size = std::max(size, std::abs(exact.hi));
        error.max_levels =
            std::max(error.max_levels, 255 * std::abs(std::clamp(found[c], 0.0, 1.0) - std::clamp(exact.hi, 0.0, 1.0)));
      }
      const double relative = off == 0 ? 0 : off / size;
      error.max_relative = std::max(error.max_relative, relative);
      sum += relative;
    }
    error.mean_relative = sum / static_cast<double>(error.followed);
    if (error.asked == 0) error.reason = "no surface is seen, or an object has too many triangles to number";
    if (error.followed < error.asked)
      error.reason = "for the others a direction is undefined, or the fragment function has no "
                     "formula in verify/oracle";
    return error;
  }

private:
  std::vector<SeenPixel> pixels_;
  std::vector<std::optional<std::array<Twofold<double>, 3>>> colours_;
};

} // namespace

std::vector<RungError> rung_errors(const SceneTask& task, int threads) {
  std::vector<RungError> errors;
  if (static_cast<std::uint64_t>(task.width) * static_cast<std::uint64_t>(task.height) > most_compared_pixels)
    return errors;
  const Frame reference = image(task, DoubleRung::name, threads);
  const Answers answers(task, reference);
  for (const std::string& rung : task.rungs) {
    RungError& error = errors.emplace_back();
    error.rung = rung;
    if (rung == DoubleRung::name) {
      error.against_oracle = answers.error_of(reference);
      continue;
    }
    const Frame frame = image(task, rung, threads);
    error.against_double = image_error(frame, reference);
    error.against_oracle = answers.error_of(frame);
  }
  return errors;
}

} // namespace refraster::bench
