#include "tests/gl/side_by_side.h"

#include "tests/gl/window_triangle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace refraster {
namespace {

enum class Corners { snapped, exact };

/// A triangle with corners on the lattice where they can be, along whose lines we decide coverage; or with exact ones.
WindowTriangle drawn_triangle(const Scene& scene, const ColourBound& bound, const TriangleRef& ref, int width,
                              int height, Corners corners) {
  std::array<Double3, 3> corner;
  const Geometry& geometry = bound.geometry();
  const Mesh& mesh = *scene.objects[ref.object].mesh;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex& v = geometry.window[ref.vertex[i]];
    const Double4 clip =
        clip_position(geometry.transforms[ref.object], mesh.positions[mesh.triangles[ref.triangle][i]]);
    corner[i] = corners == Corners::exact || (v.outcode & outcode::unsnapped)
                    ? Double3((clip.x + clip.w) / 2 * width, (clip.w - clip.y) / 2 * height, clip.w)
                    : Double3(v.x, v.y, subpixels) * (clip.w / subpixels);
  }
  return WindowTriangle(corner);
}

/// 255 x, clamped, rounded to nearest, half to even; NaN gives 0.
int rounded_level(float x) {
  return static_cast<int>(std::nearbyint(x > 0 ? std::min(x, 1.0f) * 255 : 0));
}

/// A triangle at a pixel, counted as the ids are; object 0 is the background.
struct Shown {
  std::uint32_t object = 0, triangle = 0;
  bool operator==(const Shown&) const = default;
};

class Judge {
public:
  Judge(const Scene& scene, int width, int height, const DriverTolerances& tolerances)
      : scene_(scene), width_(width), height_(height), rounded_apart_(rounded_apart(tolerances)),
        bound_(scene, width, height, tolerances) {}

  PixelVerdict verdict(const Shown& ours, const Shown& gl, int x, int y, double& distance) const {
    if (ours == gl) return PixelVerdict::same_surface;
    distance = 1e300;
    bool edge = false;
    for (const Shown& shown : {ours, gl}) {
      if (shown.object == 0) continue;
      // With a corner behind the eye, an edge is a ray: the snap of its other corner is levered by how far it reaches.
      // So what counts is the edge with exact corners too, and what lies between the two.
      std::array<Where, 2> found{};
      for (const Corners corners : {Corners::snapped, Corners::exact}) {
        const WindowTriangle triangle =
            drawn_triangle(scene_, bound_, bound_.ref(shown.object - 1, shown.triangle - 1), width_, height_, corners);
        found[static_cast<std::size_t>(corners)] = where(triangle, x + 0.5, y + 0.5, rounded_apart_);
        if (!triangle.flat) distance = std::min(distance, edge_distance(triangle, x + 0.5, y + 0.5));
      }
      edge |= found[0] == Where::on_edge || found[1] == Where::on_edge || found[0] != found[1];
    }
    if (edge) return PixelVerdict::edge;
    if (ours.object == 0 || gl.object == 0) return PixelVerdict::coverage;
    double apart = 0, allowed = 0;
    for (const Shown& shown : {ours, gl}) {
      apart = bound_.depth(shown.object - 1, shown.triangle - 1, x, y) - apart;
      allowed += bound_.depth_error(shown.object - 1, shown.triangle - 1, x, y);
    }
    return std::abs(apart) <= allowed ? PixelVerdict::depth : PixelVerdict::coverage;
  }

  AllowedColour allowed(const Shown& shown, int x, int y) const {
    if (shown.object == 0) return {scene_.background, scene_.background * 0x1p-24}; // rounded to float
    return bound_.at(shown.object - 1, shown.triangle - 1, x, y);
  }

private:
  const Scene& scene_;
  int width_, height_;
  double rounded_apart_;
  ColourBound bound_;
};

} // namespace

SideBySide side_by_side(const Scene& scene, int width, int height, const DriverProfile& profile) {
  if (profile.environment) setenv("GALLIVM_PERF", profile.environment, 1);
  GlOptions options;
  options.width = width;
  options.height = height;
  options.renderer = profile.renderer;
  options.want_radiance = options.want_ids = true;
  GlFrame frame = render_gl(scene, options);
  return side_by_side(scene,
                      {frame.driver.renderer + ", OpenGL " + frame.driver.version, std::move(frame.radiance),
                       std::move(frame.ids), std::move(frame.levels)},
                      profile.tolerances);
}

SideBySide side_by_side(const Scene& scene, const OtherImages& gl, const DriverTolerances& tolerances) {
  const int width = gl.radiance.width, height = gl.radiance.height;
  RenderOptions ours_options;
  ours_options.width = width;
  ours_options.height = height;
  ours_options.want_radiance = true;
  ours_options.aovs = {Aov::object, Aov::triangle};
  const Frame ours = render(scene, ours_options);
  const Judge judge(scene, width, height, tolerances);

  SideBySide found;
  found.driver = gl.driver;
  found.width = width;
  found.height = height;
  const auto keep_worst = [](WorstPixel& worst, const WorstPixel& pixel) {
    if (pixel.difference > worst.difference) worst = pixel;
  };
  const auto tell = [&](const WorstPixel& pixel) {
    if (found.unexplained.size() < 10) found.unexplained.push_back(pixel);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto count = [](float number) { return static_cast<std::uint32_t>(number); };
      const Shown here{count(*ours.aovs[0].at(x, y)), count(*ours.aovs[1].at(x, y))};
      const Shown there{count(gl.ids.at(x, y)[0]), count(gl.ids.at(x, y)[1])};
      const float *a = ours.radiance.at(x, y), *b = gl.radiance.at(x, y);
      double distance = 0, difference = 0;
      int levels_apart = 0;
      for (int c = 0; c < 3; ++c) {
        const int level = gl.levels.empty() ? rounded_level(b[c]) : gl.levels.at(x, y)[c];
        levels_apart = std::max(levels_apart, std::abs(ours.levels.at(x, y)[c] - level));
        // What is too bright for the image is compared as the image shows it.
        difference = std::max(difference, 255 * std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c])));
        found.levels_not_rounded += rounded_level(b[c]) != level;
      }
      if (std::isnan(difference)) difference = 1e300;
      ++(levels_apart == 0 ? found.equal : levels_apart == 1 ? found.off_by_one : found.off_by_more);

      WorstPixel pixel{x,
                       y,
                       difference,
                       {a[0], a[1], a[2]},
                       {b[0], b[1], b[2]},
                       Double3(0),
                       "shading",
                       here.object == 0 ? "background" : scene.objects[here.object - 1].name};
      const PixelVerdict verdict = judge.verdict(here, there, x, y, distance);
      if (verdict == PixelVerdict::edge) {
        ++found.edge_pixels;
        found.farthest_edge = std::max(found.farthest_edge, distance);
        pixel.cause = "edge";
      } else if (verdict == PixelVerdict::depth) {
        ++found.depth_pixels;
        pixel.cause = "depth";
      } else if (verdict == PixelVerdict::coverage) {
        ++found.coverage_pixels;
        pixel.cause = "coverage: object " + std::to_string(here.object) + " triangle " + std::to_string(here.triangle) +
                      " here, " + std::to_string(there.object) + " " + std::to_string(there.triangle) + " there";
        tell(pixel);
      }
      keep_worst(found.worst, pixel);
      if (verdict != PixelVerdict::same_surface) continue;

      keep_worst(found.worst_same, pixel);
      constexpr double never_over = 255 * 40 * 0x1p-24; // each bound has this share of the colour in it
      if (difference <= never_over * static_cast<double>(std::min({a[0], a[1], a[2]}))) continue;
      const AllowedColour allowed = judge.allowed(here, x, y);
      pixel.allowed = allowed.either_way;
      double share = 0;
      for (int c = 0; c < 3; ++c)
        for (const float value : {a[c], b[c]}) {
          const double apart = std::abs(static_cast<double>(value) - allowed.exact[c]);
          share = std::max(share, apart == 0 ? 0 : apart / allowed.either_way[c]);
        }
      found.worst_share_of_bound = std::max(found.worst_share_of_bound, share);
      if (share <= 1) continue;
      ++found.over_bound;
      tell(pixel);
    }
  }
  return found;
}

} // namespace refraster
