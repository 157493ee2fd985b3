#include "tests/support/gl/side_by_side.h"

#include "tests/support/gl/ideal_shader.h"
#include "tests/support/gl/window_triangle.h"

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

  AllowedColour allowed(const Shown& shown, int x, int y, BoundPart part) const {
    if (shown.object == 0) return {scene_.background, scene_.background * float_rounding, "background"};
    return bound_.at(shown.object - 1, shown.triangle - 1, x, y, part);
  }

private:
  const Scene& scene_;
  int width_, height_;
  double rounded_apart_;
  ColourBound bound_;
};

Frame rendered_here(const Scene& scene, int width, int height) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.want_radiance = true;
  options.aovs = {Aov::object, Aov::triangle};
  return render(scene, options);
}

/// Goes over the pixels and counts.
class Pixels {
public:
  Pixels(const Scene& scene, const OtherImages& other, const DriverTolerances& tolerances)
      : scene_(scene), other_(other), width_(other.radiance.width), height_(other.radiance.height),
        ours_(rendered_here(scene, width_, height_)), judge_(scene, width_, height_, tolerances) {}

  SideBySide all() {
    found_.driver = other_.driver;
    found_.width = width_;
    found_.height = height_;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) look_at(x, y);
    name_cause(found_.worst);
    name_cause(found_.worst_same);
    return found_;
  }

private:
  static std::uint32_t count(float number) { return static_cast<std::uint32_t>(number); }
  Shown here(int x, int y) const { return {count(*ours_.aovs[0].at(x, y)), count(*ours_.aovs[1].at(x, y))}; }
  Shown there(int x, int y) const { return {count(other_.ids.at(x, y)[0]), count(other_.ids.at(x, y)[1])}; }

  void look_at(int x, int y) {
    const Shown here = this->here(x, y), there = this->there(x, y);
    WorstPixel pixel = compared(x, y);
    pixel.object = here.object == 0 ? "background" : scene_.objects[here.object - 1].name;
    double distance = 0;
    const PixelVerdict verdict = judge_.verdict(here, there, x, y, distance);
    if (verdict == PixelVerdict::edge) {
      ++found_.edge_pixels;
      found_.farthest_edge = std::max(found_.farthest_edge, distance);
      pixel.cause = "edge";
    } else if (verdict == PixelVerdict::depth) {
      ++found_.depth_pixels;
      pixel.cause = "depth";
    } else if (verdict == PixelVerdict::coverage) {
      ++found_.coverage_pixels;
      pixel.cause = "coverage: object " + std::to_string(here.object) + " triangle " + std::to_string(here.triangle) +
                    " here, " + std::to_string(there.object) + " " + std::to_string(there.triangle) + " there";
      report(pixel);
    } else {
      update_worst(found_.worst_same, pixel);
      judge_colour(here, pixel);
    }
    update_worst(found_.worst, pixel);
  }

  /// Both colours; counts what the 8-bit images show.
  WorstPixel compared(int x, int y) {
    const float *a = ours_.radiance.at(x, y), *b = other_.radiance.at(x, y);
    WorstPixel pixel;
    pixel.x = x, pixel.y = y;
    int levels_apart = 0;
    for (int c = 0; c < 3; ++c) {
      pixel.ours[c] = a[c], pixel.gl[c] = b[c];
      const int level = other_.rgb8.empty() ? rounded_level(b[c]) : other_.rgb8.at(x, y)[c];
      levels_apart = std::max(levels_apart, std::abs(ours_.rgb8.at(x, y)[c] - level));
      pixel.difference =
          std::max(pixel.difference, 255 * std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c])));
      found_.levels_not_rounded += rounded_level(b[c]) != level;
      if (std::isnan(a[c]) || std::isnan(b[c])) pixel.difference = 1e300;
    }
    ++(levels_apart == 0 ? found_.equal : levels_apart == 1 ? found_.off_by_one : found_.off_by_more);
    return pixel;
  }

  void judge_colour(const Shown& here, WorstPixel& pixel) {
    constexpr double never_over = 255 * 40 * float_rounding; // each bound has this share of the colour in it
    const Float3& ours = pixel.ours;
    if (pixel.difference <= never_over * static_cast<double>(std::min({ours.x, ours.y, ours.z}))) return;
    // Within the least of the bound, and no new record even so: the whole would tell nothing.
    if (fraction_of_bound(here, pixel, BoundPart::least) <= std::min(found_.worst_fraction_of_bound, 1.0)) return;
    const double fraction = fraction_of_bound(here, pixel, BoundPart::whole);
    found_.worst_fraction_of_bound = std::max(found_.worst_fraction_of_bound, fraction);
    if (fraction <= 1) return;
    ++found_.over_bound;
    pixel.cause = "over the bound";
    report(pixel);
  }

  /// Of the image that is farther from the exact colour.
  double fraction_of_bound(const Shown& here, WorstPixel& pixel, BoundPart part) const {
    const AllowedColour allowed = judge_.allowed(here, pixel.x, pixel.y, part);
    pixel.allowed = allowed.either_way;
    double fraction = 0;
    for (int c = 0; c < 3; ++c)
      for (const float value : {pixel.ours[c], pixel.gl[c]}) {
        const double apart = std::abs(static_cast<double>(value) - allowed.exact[c]);
        if (std::isnan(apart)) return 1e300;
        fraction = std::max(fraction, apart == 0 ? 0 : apart / allowed.either_way[c]);
      }
    return fraction;
  }

  static void update_worst(WorstPixel& worst, const WorstPixel& pixel) {
    if (pixel.difference > worst.difference) worst = pixel;
  }
  void report(const WorstPixel& pixel) {
    if (found_.unexplained.size() < 10) found_.unexplained.push_back(pixel);
  }
  void name_cause(WorstPixel& pixel) const {
    if (pixel.cause.empty())
      pixel.cause = judge_.allowed(here(pixel.x, pixel.y), pixel.x, pixel.y, BoundPart::whole).main_cause;
  }

  const Scene& scene_;
  const OtherImages& other_;
  int width_, height_;
  Frame ours_;
  Judge judge_;
  SideBySide found_;
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
                       std::move(frame.ids), std::move(frame.rgb8)},
                      profile.tolerances);
}

SideBySide side_by_side(const Scene& scene, const OtherImages& other, const DriverTolerances& tolerances) {
  return Pixels(scene, other, tolerances).all();
}

} // namespace refraster
