#include "raster/shade/shade_tile.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace refraster {

namespace {

using T = DoublePrecision::Number;
using Triangle = AttributeSetup<double>;

/// Of the tile's pixels, what follows from visibility alone.
class SampleAovs {
public:
  SampleAovs(const VisibleTile& visible, int samples) : visible_(visible), samples_(samples) {}

  int covered(int x, int y) const {
    int count = 0;
    for (int s = 0; s < samples_; ++s) count += sees(s, x, y);
    return count;
  }
  double alpha(int x, int y) const { return static_cast<double>(covered(x, y)) / samples_; }

  /// Of the first sample that sees a surface, which is that of the pixel's first fragment; 1 if none does.
  double first_depth(int x, int y) const {
    for (int s = 0; s < samples_; ++s)
      if (sees(s, x, y)) return depth(s, x, y);
    return 1;
  }
  /// The mean over those that do.
  double mean_depth(int x, int y) const {
    const double first = first_depth(x, y);
    const int count = covered(x, y);
    double difference = 0;
    for (int s = 0; s < samples_; ++s)
      if (sees(s, x, y)) difference += (depth(s, x, y) - first) / count;
    return first + difference;
  }

private:
  bool sees(int s, int x, int y) const { return visible_.visibility.nearest(s, x, y) != nothing; }
  double depth(int s, int x, int y) const { return visible_.visibility.depth(s, x, y) * 0.5 + 0.5; }

  const VisibleTile& visible_;
  int samples_;
};

/// Which of its object's materials it is: those of the file by their number from 1, then the object's own.
std::size_t material_number(const Object& object, const Material& material) {
  if (&material == &object.material) return object.materials.size() + 1;
  return static_cast<std::size_t>(&material - object.materials.data()) + 1;
}

/// Whether it is a number of the triangle that is seen: all pixels of a run have it.
bool is_of_triangle(Aov aov) {
  return aov == Aov::object || aov == Aov::triangle || aov == Aov::material;
}

/// Which pixel a fragment belongs to, counted from the tile's corner, and whether it is the pixel's first.
struct FragmentPlace {
  int x = 0, y = 0;
  bool is_first = true;
};

bool same_pixel(const FragmentRun& a, const FragmentRun& b) {
  return a.x == b.x && a.y == b.y;
}

/// Means over the samples of a pixel, weighted as its fragments are seen: the first value, and the mean difference to it,
/// so that equal values give that value, bit for bit. values: of each fragment `channels`.
template <class Put>
void resolve_means(std::span<const FragmentRun> runs, std::span<const double> values, int channels, const Put& put) {
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t end = i;
    int covered = 0;
    for (; end < runs.size() && same_pixel(runs[i], runs[end]); ++end) covered += runs[end].samples;
    for (int pixel = 0; pixel < runs[i].length; ++pixel) // of several, each has one run
      for (int c = 0; c < channels; ++c) {
        const auto value = [&](std::size_t k) {
          const std::size_t fragment = runs[k].first_fragment + static_cast<std::size_t>(pixel);
          return values[fragment * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)];
        };
        double difference = 0;
        for (std::size_t k = i; k < end; ++k) difference += (value(k) - value(i)) * (double(runs[k].samples) / covered);
        put(runs[i].x + pixel, runs[i].y, c, value(i) + difference);
      }
    i = end;
  }
}

} // namespace

void write_aovs(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs,
                const TileAttributes<double>* shaded, std::span<Image<float>> images) {
  const std::vector<Aov>& aovs = context.options.aovs;
  if (aovs.empty()) return;
  const PixelRect& tile = visible.tile;
  const auto pixel = [&](Image<float>& image, int x, int y) {
    return image.at(tile.x - context.region.x + x, tile.y - context.region.y + y);
  };
  const auto wants = [&](std::initializer_list<Aov> any) {
    return std::find_first_of(aovs.begin(), aovs.end(), any.begin(), any.end()) != aovs.end();
  };
  const bool wants_surface = wants({Aov::normal, Aov::position, Aov::albedo, Aov::distance});
  const bool resolves = context.options.aov_filter == AovFilter::resolve && context.options.samples > 1;
  // Depth is known of each sample.
  const auto is_mean = [&](std::size_t i) {
    return resolves && kind_of(aovs[i]).mean == AovMean::covered && aovs[i] != Aov::depth;
  };

  const SampleAovs of_samples(visible, context.options.samples);
  for (std::size_t i = 0; i < aovs.size(); ++i) {
    if (aovs[i] != Aov::depth && aovs[i] != Aov::alpha) continue;
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x)
        pixel(images[i], x, y)[0] = static_cast<float>(aovs[i] == Aov::alpha ? of_samples.alpha(x, y)
                                                       : resolves            ? of_samples.mean_depth(x, y)
                                                                             : of_samples.first_depth(x, y));
  }

  // A pixel shows the triangle of its first fragment, evaluated at the pixel's centre; or, resolved, the mean of all. With
  // one sample a pixel there are no others.
  std::vector<FragmentRun> own_runs;
  TileAttributes<double> own;
  if (!shaded) {
    for (const FragmentRun& run : runs)
      if (resolves || own_runs.empty() || !same_pixel(own_runs.back(), run)) own_runs.push_back(run);
    own.collect(context, visible.triangles, own_runs);
    runs = own_runs;
  }
  const TileAttributes<double>& setups = shaded ? *shaded : own;
  std::size_t fragments = 0;
  for (const auto& group : setups.groups()) fragments += group.fragments;
  std::vector<FragmentPlace> places(fragments);
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (int i = 0; i < runs[r].length; ++i)
      places[runs[r].first_fragment + static_cast<std::size_t>(i)] = {runs[r].x + i, runs[r].y,
                                                                      r == 0 || !same_pixel(runs[r - 1], runs[r])};
  std::vector<std::vector<double>> means(aovs.size());
  for (std::size_t i = 0; i < aovs.size(); ++i)
    if (is_mean(i)) means[i].resize(fragments * static_cast<std::size_t>(kind_of(aovs[i]).channels));

  const Double3 eye = context.scene.camera.position, ahead = normalize(context.scene.camera.target - eye);
  UserShading<T> user_shading;
  UndefinedCounts uncounted; // shading has counted these
  const auto number_of = [&](Aov aov, const TileAttributes<double>::Group& group, const Triangle& triangle) {
    if (aov == Aov::object) return std::size_t(group.object) + 1;
    if (aov == Aov::material) return material_number(context.scene.objects[group.object], *group.material);
    return std::size_t(triangle.number - context.geometry.first_triangle[triangle.object]) + 1;
  };
  for (const auto& group : setups.groups()) {
    const Material& material = *group.material;
    for (const FragmentRun& run : setups.sorted().subspan(group.begin_run, group.end_run - group.begin_run)) {
      const FragmentPlace& place = places[run.first_fragment];
      if (!place.is_first) continue;
      for (std::size_t i = 0; i < aovs.size(); ++i)
        if (is_of_triangle(aovs[i]))
          std::fill_n(pixel(images[i], place.x, place.y), run.length,
                      static_cast<float>(number_of(aovs[i], group, setups.setups()[run.slot])));
    }
    if (std::all_of(aovs.begin(), aovs.end(), is_of_triangle)) continue;
    for_each_packet<T>(setups, group, tile, [&](const Packet<T>& packet, std::uint32_t first) {
      const UndefinedTally<T> tally(uncounted, first_lanes<double, NumberTraits<T>::lanes>(packet.count));
      const PacketData<T, Triangles::many> data(packet);
      PacketSurface<T> surface;
      if (wants_surface) packet_surface(context, material, data, tally, surface);
      for (std::size_t i = 0; i < aovs.size(); ++i) {
        const auto channels = static_cast<std::size_t>(kind_of(aovs[i]).channels);
        // Pixel centres beside a triangle may make any number of it; and a finite double may lie beyond a float.
        constexpr double largest = NumberTraits<float>::largest;
        const auto put = [&](int channel, auto&& value) {
          for (int lane = 0; lane < packet.count; ++lane) {
            const std::size_t fragment = first + static_cast<std::size_t>(lane);
            const FragmentPlace& place = places[fragment];
            const auto v = static_cast<double>(value(lane));
            const double finite = std::isnan(v) ? 0 : std::clamp(v, -largest, largest);
            if (!means[i].empty()) means[i][fragment * channels + static_cast<std::size_t>(channel)] = finite;
            else if (place.is_first) pixel(images[i], place.x, place.y)[channel] = static_cast<float>(finite);
          }
        };
        const auto triangle = [&](int lane) -> const Triangle& { return packet.triangle(lane); };
        const auto put3 = [&](const Vec3<T>& v) {
          for (int c = 0; c < 3; ++c) put(c, [&](int lane) { return v[c][lane]; });
        };
        switch (aovs[i]) {
        case Aov::uv: {
          const PacketBarycentrics<T> at = barycentrics<Derivatives::no>(data);
          Vec2<T> uv(interpolated_uv(data, 0, at), interpolated_uv(data, 1, at));
          std::array<double, 2> repeats{};
          for (int lane = 0; lane < packet.count; ++lane) {
            if (lane == 0 || triangle(lane).number != triangle(lane - 1).number)
              repeats = whole_repeats(context, triangle(lane).number);
            uv.x.set(lane, uv.x[lane] + repeats[0]), uv.y.set(lane, uv.y[lane] + repeats[1]);
          }
          for (int c = 0; c < 2; ++c) put(c, [&](int lane) { return uv[c][lane]; });
          break;
        }
        case Aov::normal:
          put3(surface.normal);
          break;
        case Aov::position:
          put3(surface.position);
          break;
        case Aov::distance:
          put(0, [&](int lane) {
            const Vec3<T>& at = surface.position;
            return dot(Double3(at.x[lane], at.y[lane], at.z[lane]) - eye, ahead);
          });
          break;
        case Aov::albedo:
          if (material.user_function) put3(user_shading.albedo(*material.user_function, surface));
          else
            put3(std::visit([&](const auto& function) { return albedo<T>(function, surface.texture); },
                            material.fragment_function));
          break;
        case Aov::object: // of runs
        case Aov::triangle:
        case Aov::material:
        case Aov::depth: // of samples
        case Aov::alpha:
        case Aov::count_:
          break;
        }
      }
    });
  }
  for (std::size_t i = 0; i < aovs.size(); ++i)
    if (!means[i].empty())
      resolve_means(runs, means[i], kind_of(aovs[i]).channels, [&](int x, int y, int c, double value) {
        pixel(images[i], x, y)[c] = static_cast<float>(value);
      });
}

} // namespace refraster
