// What profiles and the colour bound take for granted of Mesa's arithmetic, measured: docs/devices.md and
// docs/verification.md have these numbers.

#include "gl/render_gl.h"
#include "tests/support/gl/colour_bound.h"
#include "tests/support/gl/ideal_shader.h"
#include "tests/support/program/program.h"
#include "tests/system/gl/small_scenes.h"
#include "verify/device/read_profile.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace refraster;

namespace {

constexpr DriverTolerances assumed;
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
  object.material.texture = std::move(texture);
  object.material.texture_filter = TextureFilter::bilinear;
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

/// A function of GLSL, and how much of what a profile allows its result uses; of (result.x, .y, .z).
struct MeasuredFunction {
  std::string name, formulas;
  std::function<double(const OperationErrors&, double, double, double)> used;
  double least; // what the worst pixel is to use at least, else the profile is wider than it need be
};

/// |computed - exact| / (relative |exact| + absolute)
double used_of(double computed, double exact, double relative, double absolute = 0) {
  return std::abs(computed - exact) / (relative * std::abs(exact) + absolute);
}

const char* const some_x_and_y =
    "    float x = 1.0 + 0.97 * fract(37.0 * a + b), y = 1.0 + 0.77 * fract(7.0 * a - 3.0 * b);\n";

const MeasuredFunction measured_functions[] = {
    {"product", "    result = vec3(x, y, x * y);\n",
     [](const OperationErrors& e, double x, double y, double z) { return used_of(z, x * y, e.relative, e.absolute); },
     0.5},
    {"quotient", "    result = vec3(x, y, x / y);\n",
     [](const OperationErrors& e, double x, double y, double z) { return used_of(z, x / y, e.quotient_relative); },
     0.5},
    {"inversesqrt", "    result = vec3(x * y, 0.0, inversesqrt(x * y));\n",
     [](const OperationErrors& e, double x, double, double z) { return used_of(z, 1 / std::sqrt(x), e.root_relative); },
     0.5},
    {"sqrt", "    result = vec3(x * y, 0.0, sqrt(x * y));\n",
     [](const OperationErrors& e, double x, double, double z) { return used_of(z, std::sqrt(x), e.root_relative); },
     0.4},
    {"exp2", "    x = 40.0 * a - 20.0 + b / 16.0; result = vec3(x, 0.0, exp2(x));\n",
     [](const OperationErrors& e, double x, double, double z) {
       return used_of(z, std::exp2(x), 2 * e.relative * (e.exp2_units + e.exp2_units_by_exponent * std::abs(x)));
     },
     0.4},
    {"log2", "    x *= exp2(120.0 * a - 60.0); result = vec3(x, 0.0, log2(x));\n",
     [](const OperationErrors& e, double x, double, double z) {
       return used_of(z, std::log2(x), 2 * e.relative * e.log2_units, e.log2_absolute);
     },
     0.4},
    {"log2 near 1", "    x = 0.4 + 1.8 * fract(a + 256.0 * b / 512.0); result = vec3(x, 0.0, log2(x));\n",
     [](const OperationErrors& e, double x, double, double z) {
       return used_of(z, std::log2(x), 2 * e.relative * e.log2_units, e.log2_absolute);
     },
     0.4},
    {"atan", "    y = exp2(20.0 * (a - 0.9)), x = b - 0.25; result = vec3(y, x, atan(y, x));\n",
     [](const OperationErrors& e, double y, double x, double z) {
       return used_of(z, std::atan2(y, x), 2 * e.relative * e.atan2_units);
     },
     0.5},
    // As bounds have it: exp2(s log2(x)), and the product's rounding.
    {"pow", "    x = 1.0 - 0.5 * a * a * a, y = exp2(12.0 * b); result = vec3(x, y, pow(x, y));\n",
     [](const OperationErrors& e, double x, double s, double z) {
       const double log = std::abs(std::log2(x)), exponent = s * log;
       if (exponent > 100) return 0.0; // flushed to 0 somewhere below
       const double of_exponent = s * (2 * e.relative * e.log2_units * log + e.log2_absolute) + e.relative * exponent;
       return used_of(z, std::pow(x, s),
                      2 * e.relative * (e.exp2_units + e.exp2_units_by_exponent * exponent) +
                          std::numbers::ln2 * of_exponent);
     },
     0.2}, // softpipe's is the C library's, in one step
};

} // namespace

TEST_CASE("Mesa's functions are as good as its drivers' profiles say, and the profiles not much wider") {
  for (const char* const name : {"llvmpipe", "softpipe"}) {
    const DeviceProfile profile = device_profile(name);
    CAPTURE(profile.name);
    for (const MeasuredFunction& function : measured_functions) {
      CAPTURE(function.name);
      const double used =
          largest(evaluated(some_x_and_y + function.formulas, nullptr, profile.renderer),
                  [&](double x, double y, double z) { return function.used(profile.operations, x, y, z); });
      MESSAGE(profile.name << ", " << function.name << ": " << used << " of what the profile allows");
      CHECK(used <= 1);
      CHECK(used > function.least);
    }
  }
}

TEST_CASE("llvmpipe's atan is as good as the bound assumes, and its acos is not") {
  const double atan_error =
      largest(evaluated("    float y = exp2(20.0 * (a - 0.9)), x = b - 0.25;\n"
                        "    result = vec3(y, x, atan(y, x));\n"),
              [](double y, double x, double angle) { return std::abs(angle / std::atan2(y, x) - 1); });
  MESSAGE("atan: " << atan_error / float_rounding << " / 2^24, relative");
  CHECK(atan_error / float_rounding <= assumed.atan_ulp);
  CHECK(atan_error / float_rounding > 0.5 * assumed.atan_ulp);

  const double acos_error = largest(evaluated("    result = vec3(a, 0.0, acos(a));\n"),
                                    [](double x, double, double angle) { return std::abs(angle - std::acos(x)); });
  MESSAGE("acos: " << acos_error << " radians");
  CHECK(acos_error > 1e-4);
}

TEST_CASE("llvmpipe's pow is as good as the bound assumes") {
  const double fraction = largest(evaluated("    float x = 1.0 - 0.5 * a * a * a, s = exp2(12.0 * b);\n"
                                            "    result = vec3(x, s, pow(x, s));\n"),
                                  [](double x, double s, double power) {
                                    const double exact = std::pow(x, s);
                                    if (exact < 0x1p-100) return 0.0; // flushed to 0 somewhere below
                                    return std::abs(power / exact - 1) / float_rounding / (16 + assumed.power_ulp * s);
                                  });
  MESSAGE("pow: " << fraction << " of what is allowed");
  CHECK(fraction <= 1);
  CHECK(fraction > 0.5);
}

TEST_CASE("llvmpipe's filter of 8-bit textures is as good as the bound assumes") {
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
  MESSAGE("filter: " << levels << " levels");
  CHECK(levels <= 1.07);
  CHECK(levels > 0.5);
}
