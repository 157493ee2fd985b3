#include "raster/parallel.h"
#include "verify/compare/clusters.h"
#include "verify/verdict/power.h"
#include "verify/verdict/witnesses.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>
#include <span>
#include <stdexcept>

namespace refraster {
namespace {

/// One image, judged in three tiers: the unrounded reference; two witnesses; and bounds for what is left.
class Judge {
public:
  Judge(const Scene& scene, const DeviceImage& image, const DeviceProfile& profile, const JudgeOptions& options)
      : scene_(scene), image_(image), profile_(profile), options_(options), stored_(image, profile) {
    render_.width = image.colour.width, render_.height = image.colour.height;
    render_.samples = options.samples, render_.threads = options.threads;
    render_.want_rgb8 = false, render_.want_radiance = true;
    render_.aovs = {Aov::object, Aov::triangle};
    render_.memory = options.memory;
  }

  Verdict judge() {
    check_sizes();
    Frame frame = render(scene_, render_);
    verdict_.width = render_.width, verdict_.height = render_.height;
    verdict_.reference = std::move(frame.radiance);
    verdict_.object = std::move(frame.aovs[0]), verdict_.triangle = std::move(frame.aovs[1]);
    verdict_.classes = Image<std::uint8_t>(verdict_.width, verdict_.height, 1);
    verdict_.width_levels = Image<float>(verdict_.width, verdict_.height, 1);
    progress(0.1);
    const DeviceFrame device(scene_, render_, profile_, options_.matrices);
    std::vector<PixelPlace> left = by_reference(device);
    if (!left.empty() && stored_.is_integer())
      if (const auto witnesses = texel_witnesses(scene_, render_, profile_)) by_witnesses(device, *witnesses, left);
    progress(0.2);
    by_bounds(device, left);
    const SampledBounds sampled =
        sample_bounds(device, stored_, options_.seed, [&](int x, int y) { return ours(device, x, y); });
    verdict_.power = power_of(sampled);
    verdict_.causes = shares_of(sampled);
    verdict_.biases = biases_of(verdict_, image_, stored_, sampled, scene_.objects.size(), threads());
    find_clusters();
    for (const std::uint8_t c : verdict_.classes.values) ++verdict_.counts[c];
    progress(1);
    return std::move(verdict_);
  }

private:
  void check_sizes() const {
    const auto fits = [&](const Image<float>& image, int channels) {
      return image.empty() ||
             (image.width == render_.width && image.height == render_.height && image.channels == channels);
    };
    if (image_.colour.empty() || !fits(image_.colour, 3) || !fits(image_.ids, 2) || !fits(image_.depth, 1))
      throw std::invalid_argument("images of colour, ids and depth must be of one size, with 3, 2 and 1 channels");
    if (!image_.samples.empty() && image_.samples.size() != static_cast<std::size_t>(options_.samples))
      throw std::invalid_argument("there must be a position for each sample");
  }
  void progress(double done) const {
    if (options_.progress) options_.progress(done);
  }
  void set_class(int x, int y, PixelClass found) { *verdict_.classes.at(x, y) = static_cast<std::uint8_t>(found); }
  /// The triangle that the reference shows, by its number in the frame.
  std::optional<std::uint32_t> ours(const DeviceFrame& device, int x, int y) const {
    const auto object = static_cast<std::size_t>(*verdict_.object.at(x, y));
    if (object == 0) return std::nullopt;
    return device.number_of(object - 1, static_cast<std::uint32_t>(*verdict_.triangle.at(x, y)) - 1);
  }
  Double3 actual(int x, int y) const {
    const float* const at = image_.colour.at(x, y);
    return {stored_.levels(at[0]), stored_.levels(at[1]), stored_.levels(at[2])};
  }

  /// Whether ids and depth, where there are any, speak of another surface than the reference's.
  bool shows_another(const DeviceFrame& device, int x, int y) const {
    if (!image_.ids.empty()) {
      const float* const at = image_.ids.at(x, y);
      if (at[0] != *verdict_.object.at(x, y) || (at[0] != 0 && at[1] != *verdict_.triangle.at(x, y))) return true;
    }
    if (image_.depth.empty()) return false;
    const auto depth = static_cast<double>(*image_.depth.at(x, y));
    const auto number = ours(device, x, y);
    if (!number) return depth != 1;
    const ValueRange range = DeviceTriangle(device, *number).depth(x + 0.5, y + 0.5);
    return !(range.lo <= depth && depth <= range.hi);
  }

  /// Classifies what is the reference, as it is stored. Returns the others, row by row.
  std::vector<PixelPlace> by_reference(const DeviceFrame& device) {
    static_assert(static_cast<int>(PixelClass::exact) == 0);
    const bool only_colour = image_.ids.empty() && image_.depth.empty();
    std::vector<std::vector<PixelPlace>> of_row(static_cast<std::size_t>(verdict_.height));
    parallel_for(threads(), of_row.size(), [&](std::size_t row, int) {
      const int y = static_cast<int>(row);
      std::vector<std::uint8_t> plain(3 * static_cast<std::size_t>(verdict_.width)); // of each channel
      if (stored_.has_plain_levels())
        stored_.are_plainly(verdict_.reference.at(0, y), image_.colour.at(0, y), plain);
      const auto first_doubt = [&](int x) { // from x on
        const std::uint8_t* const from = plain.data() + 3 * static_cast<std::size_t>(x);
        const void* const at = std::memchr(from, 0, 3 * static_cast<std::size_t>(verdict_.width - x));
        return at ? x + static_cast<int>((static_cast<const std::uint8_t*>(at) - from) / 3) : verdict_.width;
      };
      int doubt = first_doubt(0);
      for (int x = 0; x < verdict_.width; ++x) {
        if (x < doubt) { // all classes are exact until they are set
          if (only_colour) x = doubt - 1;
          else if (shows_another(device, x, y)) of_row[row].push_back({x, y});
          continue;
        }
        doubt = first_doubt(x + 1);
        const float* const reference = verdict_.reference.at(x, y);
        const Double3 levels = actual(x, y);
        bool exact = true, near = true;
        for (int c = 0; c < 3; ++c) {
          const auto radiance = static_cast<double>(reference[c]);
          exact &= stored_.is(reference[c], levels[c]);
          near &= stored_.may_be(radiance, radiance, levels[c]);
        }
        if (near && !shows_another(device, x, y)) set_class(x, y, exact ? PixelClass::exact : PixelClass::rounding);
        else of_row[row].push_back({x, y});
      }
    });
    std::vector<PixelPlace> left;
    for (const auto& row : of_row) left.insert(left.end(), row.begin(), row.end());
    return left;
  }

  void by_witnesses(const DeviceFrame& device, const Witnesses& witnesses, std::vector<PixelPlace>& left) {
    std::erase_if(left, [&](const PixelPlace& at) {
      const float *low = witnesses.low.at(at.x, at.y), *high = witnesses.high.at(at.x, at.y),
                  *reference = verdict_.reference.at(at.x, at.y);
      const Double3 levels = actual(at.x, at.y);
      double apart = 0;
      for (int c = 0; c < 3; ++c) {
        const auto [least, most] = std::minmax({low[c], high[c], reference[c]});
        if (!stored_.may_be(static_cast<double>(least), static_cast<double>(most), levels[c])) return false;
        apart = std::max(apart, std::abs(std::round(stored_.of(static_cast<double>(reference[c]))) - levels[c]));
      }
      if (shows_another(device, at.x, at.y)) return false;
      set_class(at.x, at.y, apart <= stored_.step() ? PixelClass::rounding : PixelClass::texel);
      return true;
    });
  }

  void by_bounds(const DeviceFrame& device, const std::vector<PixelPlace>& left) {
    std::vector<std::vector<VisibleSet>> sets;
    const std::span<const SamplePosition> standard = sample_pattern(options_.samples);
    for (const SamplePosition& sample : image_.samples.empty() ? standard : std::span(image_.samples))
      sets.push_back(find_candidates(device, left, sample));
    verdict_.details.resize(left.size());
    std::vector<std::unique_ptr<PixelJudge>> judges(static_cast<std::size_t>(threads()));
    constexpr std::size_t block = 64;
    const std::size_t blocks = (left.size() + block - 1) / block;
    std::atomic<std::size_t> done = 0;
    std::mutex telling;
    parallel_for(threads(), blocks, [&](std::size_t b, int thread) {
      auto& pixel_judge = judges[static_cast<std::size_t>(thread)];
      if (!pixel_judge) pixel_judge = std::make_unique<PixelJudge>(device, stored_);
      for (std::size_t i = b * block; i < std::min((b + 1) * block, left.size()); ++i) {
        PixelCase pixel = case_of(device, left[i]);
        for (const auto& of_sample : sets) pixel.samples.push_back(&of_sample[i]);
        JudgedDetail detail = pixel_judge->judge(pixel);
        detail.object = static_cast<std::uint32_t>(*verdict_.object.at(detail.x, detail.y));
        detail.triangle = static_cast<std::uint32_t>(*verdict_.triangle.at(detail.x, detail.y));
        const double width = detail.allowed.width();
        *verdict_.width_levels.at(detail.x, detail.y) = static_cast<float>(width);
        set_class(detail.x, detail.y, detail.found);
        verdict_.details[i] = detail;
      }
      const std::size_t now = ++done;
      if (options_.progress && now % 16 == 0) {
        const std::lock_guard lock(telling);
        progress(0.2 + 0.75 * static_cast<double>(now) / static_cast<double>(blocks));
      }
    });
  }

  PixelCase case_of(const DeviceFrame& device, const PixelPlace& at) const {
    PixelCase pixel;
    pixel.at = at;
    pixel.ours = ours(device, at.x, at.y);
    pixel.actual = actual(at.x, at.y);
    for (int c = 0; c < 3; ++c) pixel.reference[c] = static_cast<double>(verdict_.reference.at(at.x, at.y)[c]);
    if (!image_.ids.empty()) {
      const float* const ids = image_.ids.at(at.x, at.y);
      const auto object = static_cast<std::size_t>(ids[0]), triangle = static_cast<std::size_t>(ids[1]);
      if (object == 0) pixel.shows_background = true;
      else if (object <= scene_.objects.size() && triangle >= 1 &&
               triangle <= scene_.objects[object - 1].mesh->triangles.size())
        pixel.shown = device.number_of(object - 1, static_cast<std::uint32_t>(triangle - 1));
      else pixel.shown = device.triangles(); // of no triangle: nothing matches it
    }
    if (!image_.depth.empty()) pixel.depth = static_cast<double>(*image_.depth.at(at.x, at.y));
    return pixel;
  }

  void find_clusters() {
    if (std::none_of(verdict_.details.begin(), verdict_.details.end(),
                     [](const JudgedDetail& detail) { return detail.found == PixelClass::unexplained; }))
      return;
    Image<std::uint8_t> marked(verdict_.width, verdict_.height, 1);
    Image<double> differences(verdict_.width, verdict_.height, 1);
    for (const JudgedDetail& detail : verdict_.details) {
      if (detail.found != PixelClass::unexplained) continue;
      *marked.at(detail.x, detail.y) = 1;
      double most = 0;
      for (int c = 0; c < 3; ++c) {
        const double apart = std::abs(detail.actual[c] - detail.reference[c]);
        most = std::max(most, std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart);
      }
      *differences.at(detail.x, detail.y) = most;
    }
    for (const Cluster& cluster : clusters_of(marked, differences)) {
      const auto object = static_cast<std::size_t>(*verdict_.object.at(cluster.worst_x, cluster.worst_y));
      verdict_.clusters.push_back({cluster, object == 0 ? "background" : scene_.objects[object - 1].name});
    }
  }

  int threads() const { return thread_count(render_); }

  const Scene& scene_;
  const DeviceImage& image_;
  const DeviceProfile& profile_;
  const JudgeOptions& options_;
  StoredValue stored_;
  RenderOptions render_;
  Verdict verdict_;
};

} // namespace

Verdict judge(const Scene& scene, const DeviceImage& image, const DeviceProfile& profile, const JudgeOptions& options) {
  return Judge(scene, image, profile, options).judge();
}

} // namespace refraster
