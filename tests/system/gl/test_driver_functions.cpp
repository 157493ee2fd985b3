// What profiles take for granted of Mesa's arithmetic, measured: docs/devices.md has these numbers.

#include "gl/render_gl.h"
#include "shading/texture.h"
#include "tests/support/gl/device_images.h"
#include "tests/support/program/program.h"
#include "tests/system/gl/small_scenes.h"
#include "verify/device/read_profile.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace refraster;

namespace {

constexpr int width = 512, height = 256;

/// The pixels of a quad that fills the window. `formulas` sets `result` from `a` and `b`, each in (0, 1); what it needs
/// to know exactly goes into the result too, since floats come back as they are.
Image<float> evaluated(const std::string& formulas, std::shared_ptr<const Texture> texture = nullptr,
                       GlRenderer renderer = GlRenderer::llvmpipe) {
  const TemporaryFolder folder;
  save_text(folder / "vs.glsl", "#version 330 core\n"
                                "layout(location = 0) in vec3 vPos;\n"
                                "void main() { gl_Position = vec4(vPos.xz, 0.0, 1.0); }\n");
  save_text(folder / "fs.glsl", "#version 330 core\n"
                                "uniform sampler2D tex;\n"
                                "out vec4 FragColor;\n"
                                "void main() {\n"
                                "    float a = gl_FragCoord.x / 512.0, b = gl_FragCoord.y / 256.0;\n"
                                "    vec3 result = textureLod(tex, vec2(0.5), 0.0).rgb;\n" +
                                    formulas + "    FragColor = vec4(result, 1.0);\n}\n");
  Scene scene;
  Object object;
  object.mesh = std::make_shared<const Mesh>(plane_mesh(1));
  object.material.fragment_function = Phong{};
  object.material.diffuse_map.texture = std::move(texture);
  object.material.diffuse_map.filter = TextureFilter::bilinear;
  object.vertex_shader_path = folder / "vs.glsl";
  object.fragment_shader_path = folder / "fs.glsl";
  scene.objects = {object};
  GlOptions options;
  options.width = width, options.height = height;
  options.renderer = renderer;
  options.want_radiance = true;
  return render_gl(scene, options).radiance;
}

/// The largest error over the pixels, of error(result).
template <class Error>
double largest(const Image<float>& image, Error&& error) {
  double most = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* const at = image.at(x, y);
      most = std::max(most, error(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])));
    }
  return most;
}

} // namespace

TEST_CASE("Mesa's pow is as good as its drivers' profiles make exp2(s log2(x))") {
  for (const auto& [name, least] : {std::pair("llvmpipe", 0.4), {"softpipe", 0.1}}) { // whose pow is the C library's
    const DeviceProfile profile = device_profile(name);
    const OperationErrors& e = profile.operations;
    const double used =
        largest(evaluated("    float x = 1.0 - 0.5 * a * a * a, s = exp2(12.0 * b);\n"
                          "    result = vec3(x, s, pow(x, s));\n",
                          nullptr, profile.renderer),
                [&](double x, double s, double power) {
                  const double log = std::abs(std::log2(x)), exponent = s * log;
                  if (exponent > 100) return 0.0; // flushed to 0 somewhere below
                  const double of_exponent =
                      s * (2 * e.relative * e.log2_units * log + e.log2_absolute) + e.relative * exponent;
                  const double allowed = 2 * e.relative * (e.exp2_units + e.exp2_units_by_exponent * exponent) +
                                         std::numbers::ln2 * of_exponent;
                  return std::abs(power / std::pow(x, s) - 1) / allowed;
                });
    MESSAGE(profile.name << ": " << used << " of what the profile allows");
    CHECK(used <= 1);
    CHECK(used > least);
  }
}

TEST_CASE("llvmpipe's atan is as good as its profile says, and its acos is not") {
  const OperationErrors errors = device_profile("llvmpipe").operations;
  const double allowed = 2 * errors.relative * errors.atan2_units;
  const double atan_error =
      largest(evaluated("    float y = exp2(20.0 * (a - 0.9)), x = b - 0.25;\n"
                        "    result = vec3(y, x, atan(y, x));\n"),
              [](double y, double x, double angle) { return std::abs(angle / std::atan2(y, x) - 1); });
  MESSAGE("atan: " << atan_error / float_rounding << " / 2^24, relative");
  CHECK(atan_error <= allowed);
  CHECK(atan_error > 0.5 * allowed);

  const double acos_error = largest(evaluated("    result = vec3(a, 0.0, acos(a));\n"),
                                    [](double x, double, double angle) { return std::abs(angle - std::acos(x)); });
  MESSAGE("acos: " << acos_error << " radians");
  CHECK(acos_error > 1e-4);
}

TEST_CASE("llvmpipe's filter of 8-bit textures is as good as its profile says") {
  std::mt19937 random(1);
  Texture texture;
  texture.levels.push_back({64, 64, {}});
  for (int i = 0; i < 3 * 64 * 64; ++i) texture.levels[0].rgb.push_back(static_cast<float>(random() & 255));
  const auto shared = std::make_shared<const Texture>(texture);
  const double levels = largest(
      evaluated("    result = vec3(a, b, texture(tex, vec2(a, b)).r);\n", shared), [&](double u, double v, double red) {
        const Double2 none(0);
        return 255 * std::abs(red - sample(*shared, TextureFilter::bilinear, Double2(u, v), none, none).x);
      });
  // Weights are off by the place, of the difference of two texels, along each axis.
  const TextureProfile errors = device_profile("llvmpipe").texture;
  const double allowed = 255 * (errors.filter_error + 2 * errors.place_error);
  MESSAGE("filter: " << levels << " levels of " << allowed);
  CHECK(levels <= allowed);
  CHECK(levels > 0.3 * allowed);
}
