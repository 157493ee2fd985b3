// Several samples a pixel; and all images of one run, which are of the same surfaces.

#include <refraster/render.h>

#include "gl/context/context.h"
#include "gl/draw/drawing.h"
#include "gl/draw/read_back.h"
#include "raster/samples.h"
#include "tests/support/gl/device_images.h"
#include "tests/support/gl/where.h"
#include "tests/support/random.h"
#include "tests/system/gl/window_scenes.h"
#include "verify/device/read_profile.h"
#include "verify/verdict/verdict.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace refraster;

namespace {

// Twice as wide as high and both powers of two: corners on the lattice of 1/256 pixel are floats, and stay what they
// are on their way to the window, here and there.
constexpr WindowSize size = {64, 32};

/// In pixels from the upper left corner, on the lattice.
struct Corner {
  double x, y;
};
using Corners = std::array<Corner, 3>;

Corners random_corners(Random& random) {
  Corners corners;
  for (Corner& corner : corners)
    corner = {random.below(size.width * 256) / 256.0, random.below(size.height * 256) / 256.0};
  return corners;
}

/// At distance 1 before the camera of scene_before_the_eye().
Object triangle_at(const Corners& corners, const Double3& colour) {
  std::vector<Float3> places;
  for (const Corner& corner : corners)
    places.push_back({static_cast<float>((corner.x / size.width * 2 - 1) * 2),
                      static_cast<float>(1 - corner.y / size.height * 2), -1});
  return shining(places, colour);
}

GlOptions four_samples() {
  GlOptions options;
  options.width = size.width, options.height = size.height;
  options.samples = 4;
  options.renderer = GlRenderer::llvmpipe;
  options.want_radiance = options.want_depth = options.want_ids = true;
  return options;
}

/// How much of a pixel a triangle covers, by samples at these positions; none where one lies on an edge.
std::optional<double> covered_part(const WindowTriangle& triangle, int x, int y,
                                   const std::vector<GlSamplePosition>& samples) {
  double inside = 0;
  for (const GlSamplePosition& at : samples) {
    const Where place = where(triangle, x + at.x, y + at.y, 0);
    if (place == Where::on_edge) return std::nullopt;
    inside += place == Where::inside;
  }
  return inside / static_cast<double>(samples.size());
}

/// The image of render() with as many samples, of the scene upside down, turned over.
Image<float> rendered_upside_down(Scene scene, int samples) {
  for (Object& object : scene.objects) object.scale.y = -1; // the camera looks along an axis
  RenderOptions options;
  options.width = size.width, options.height = size.height, options.samples = samples;
  options.want_radiance = true;
  const Image<float> image = render(scene, options).radiance;
  Image<float> turned(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.at(0, y), 3 * image.width, turned.at(0, image.height - 1 - y));
  return turned;
}

} // namespace

TEST_CASE("llvmpipe has four samples at the standard positions, counted from the lower left corner of the pixel") {
  const std::vector<GlSamplePosition> positions = render_gl(scene_before_the_eye(), four_samples()).sample_positions;
  REQUIRE(positions.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const SamplePosition standard = sample_pattern(4)[i]; // y downward
    INFO("sample " << i << " lies at " << positions[i].x << ", " << positions[i].y << " from the upper left corner");
    CHECK(positions[i] == GlSamplePosition{standard.x / 256.0, 1 - standard.y / 256.0});
  }
  GlOptions one = four_samples();
  one.samples = 1;
  CHECK(render_gl(scene_before_the_eye(), one).sample_positions == std::vector{GlSamplePosition{0.5, 0.5}});
}

TEST_CASE(
    "with four samples a pixel shows so much of a triangle as has samples in it, where the driver says they lie") {
  Random random(7);
  int partly = 0;
  for (int i = 0; i < 10; ++i) {
    const Corners corners = random_corners(random);
    Scene scene = scene_before_the_eye();
    scene.objects = {triangle_at(corners, Double3(1))};
    const GlFrame frame = render_gl(scene, four_samples());
    const Image<float> ours = rendered_upside_down(scene, 4);
    std::array<Double3, 3> homogeneous;
    for (std::size_t k = 0; k < 3; ++k) homogeneous[k] = {corners[k].x, corners[k].y, 1};
    const WindowTriangle triangle(homogeneous);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const std::optional<double> part = covered_part(triangle, x, y, frame.sample_positions);
        if (!part) continue; // whose that sample is, is decided by the driver
        CAPTURE(i);
        CAPTURE(x);
        CAPTURE(y);
        REQUIRE(static_cast<double>(frame.radiance.at(x, y)[0]) == *part); // quarters are exact
        REQUIRE(frame.radiance.at(x, y)[0] == ours.at(x, y)[0]);
        const std::optional<double> first = covered_part(triangle, x, y, {frame.sample_positions[0]});
        REQUIRE(static_cast<double>(frame.ids.at(x, y)[0]) == *first);
        partly += *part > 0 && *part < 1;
      }
  }
  CHECK(partly > 250);
}

TEST_CASE("a resolved colour is the mean of the samples' colours") {
  Random random(8);
  Scene scene = scene_before_the_eye();
  for (int i = 0; i < 30; ++i)
    scene.objects.push_back(
        triangle_at(random_corners(random), {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)}));
  const GlContext context(GlRenderer::llvmpipe);
  const GlApi& gl = context.gl();
  const GlOptions options = four_samples();
  const auto check = [&](GLenum format, auto&& resolved_value, double allowed) {
    const GlTarget target = make_target(gl, format, options);
    GlDrawing drawing(gl, scene, options);
    drawing.draw(GlPass::colour);
    const auto resolved = resolved_value(target);
    std::vector<Image<float>> samples;
    for (int i = 0; i < 4; ++i) samples.push_back(read_sample(gl, target, i, 3));
    int mixed = 0;
    double farthest = 0;
    for (std::size_t i = 0; i < samples[0].values.size(); ++i) {
      double sum = 0;
      for (const Image<float>& sample : samples) sum += static_cast<double>(sample.values[i]);
      mixed += sum / 4 != static_cast<double>(samples[0].values[i]);
      farthest = std::max(farthest, std::abs(static_cast<double>(resolved.values[i]) - sum / 4));
    }
    CHECK(farthest <= allowed);
    CHECK(mixed > 500);
  };
  check(
      GL_RGBA32F, [&](const GlTarget& target) { return read_radiance(gl, target); }, 3 * float_rounding); // three sums
  check(
      GL_RGBA8,
      [&](const GlTarget& target) {
        const Image<std::uint8_t> levels = read_rgb8(gl, target);
        Image<float> values(levels.width, levels.height, 3);
        for (std::size_t i = 0; i < values.values.size(); ++i)
          values.values[i] = static_cast<float>(levels.values[i]) / 255;
        return values;
      },
      0.5 / 255 + 6 * float_rounding); // rounded to nearest; four levels and their sum are floats
}

TEST_CASE("with four samples depth is that of sample 0") {
  Scene scene = scene_before_the_eye();
  std::vector<Float3> corners = rectangle(-1, -1, 1, 1, 0);
  for (Float3& corner : corners) corner.z = corner.y; // depth rises from 0 at the bottom to 1 at the top
  scene.objects = {shining(corners)};
  const GlFrame frame = [&] {
    const TemporaryFolder folder;
    save_text(folder / "vs.glsl", clip_space_vertex_shader);
    scene.objects[0].vertex_shader_path = folder / "vs.glsl";
    save_text(folder / "fs.glsl", writing("vec3(1.0)"));
    scene.objects[0].fragment_shader_path = folder / "fs.glsl";
    return render_gl(scene, four_samples());
  }();
  REQUIRE(frame.sample_positions[0].y != 0.5);
  for (int y = 0; y < size.height; ++y)
    CHECK(std::abs(static_cast<double>(*frame.depth.at(5, y)) -
                   (1 - (y + frame.sample_positions[0].y) / size.height)) <= 8 * float_rounding);
  CHECK(frame.samples_passed == 4 * size.width * size.height);
}

TEST_CASE("edges of what is brighter than white are explained, whether each sample is cut off at 1 or their mean is") {
  Random random(9);
  Scene scene = scene_before_the_eye();
  for (int i = 0; i < 6; ++i) scene.objects.push_back(triangle_at(random_corners(random), Double3(0.3 + i)));
  const GlFrame frame = render_gl(scene, four_samples());
  JudgeOptions options;
  options.samples = 4;
  DeviceImage image;
  for (const GlSamplePosition& at : frame.sample_positions)
    image.samples.push_back({static_cast<std::int32_t>(256 * at.x), static_cast<std::int32_t>(256 * at.y)});
  image.colour = Image<float>(size.width, size.height, 3);
  image.precision = StoredPrecision::integers(255);
  const DeviceProfile profile = device_profile("llvmpipe");
  std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), image.colour.values.begin());
  CHECK(judge(scene, image, profile, options).is_explained());
  int differ = 0;
  for (std::size_t i = 0; i < image.colour.values.size(); ++i) { // as after a resolve of floats
    const float late = std::nearbyint(std::min(frame.radiance.values[i], 1.0f) * 255);
    differ += late != image.colour.values[i];
    image.colour.values[i] = late;
  }
  CHECK(differ > 50);
  CHECK(judge(scene, image, profile, options).is_explained());
  image.samples.clear(); // at the standard positions, where this driver has none
  CHECK_FALSE(judge(scene, image, profile, options).is_explained());
}

TEST_CASE("a number of samples that the driver does not have is no OpenGL, and the line says which it has") {
  GlOptions options = four_samples();
  options.samples = 8;
  CHECK_THROWS_WITH_AS(render_gl(scene_before_the_eye(), options),
                       doctest::Contains(") does not draw 8 samples a pixel, but 1 or 4"), NoOpenGl);
  options.samples = 2; // which Mesa would round up
  CHECK_THROWS_WITH_AS(render_gl(scene_before_the_eye(), options),
                       doctest::Contains(") does not draw 2 samples a pixel, but 1 or 4"), NoOpenGl);
  options.samples = 4;
  options.renderer = GlRenderer::softpipe;
  CHECK_THROWS_WITH_AS(render_gl(scene_before_the_eye(), options),
                       doctest::Contains("softpipe) does not draw 4 samples a pixel, but 1"), NoOpenGl);
}

TEST_CASE("where a shader discards or sets the depth, a warning says that ids are of other surfaces") {
  Scene scene = scene_before_the_eye();
  scene.objects = {shining(rectangle(-1, -1, 1, 1, -0.5f))};
  const auto warnings = [&](const std::string& line) {
    const std::string fragment =
        "#version 330 core\nout vec4 FragColor;\nvoid main() {\n    FragColor = vec4(1.0);\n    " + line + "\n}\n";
    return drawn_with(scene, clip_space_vertex_shader, fragment, {16, 8}, GlRenderer::llvmpipe).warnings;
  };
  CHECK(warnings("").empty());
  const std::string meaning = " of another depth in the draw of the ids than in that of the float image, the first at "
                              "0,0 from the top left: its fragment shader discards there or sets the depth, which the "
                              "ids do not know";
  CHECK(warnings("if (gl_FragCoord.x < 3.0) discard;") == std::vector{"24 pixels are" + meaning});
  CHECK(warnings("gl_FragDepth = 0.125;") == std::vector{"128 pixels are" + meaning});
}
