#include "gl/probe/functions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace refraster {
namespace {

constexpr int side = 1024; // 2^20 pixels, one argument each
constexpr double u = 0x1p-24;

/// Arguments of pixel i, in GLSL and here. All of them are exact in float.
struct Arguments {
  const char* glsl; // sets x and y, from i and h, which is a hash of it
  double (*x)(std::uint32_t i);
  double (*y)(std::uint32_t h);
};

constexpr std::uint32_t hashed(std::uint32_t i) {
  return i * 2654435761u;
}

double number(std::uint32_t mantissa, int exponent) {
  return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(127 + exponent) << 23 | mantissa));
}

const char* const declarations = "float number(uint mantissa, int exponent) {\n"
                                 "    return uintBitsToFloat(uint(127 + exponent) << 23u | mantissa);\n"
                                 "}\n";

double any_mantissa(std::uint32_t h) {
  return number(h >> 9, 0);
}

/// 16 binades around 1, of each 2^16 mantissas.
constexpr Arguments binades = {
    "    float x = number((i & 65535u) * 128u + 77u, int(i >> 16u) - 8), y = number(h >> 9u, 0);\n",
    [](std::uint32_t i) { return number((i & 65535u) * 128u + 77u, static_cast<int>(i >> 16) - 8); }, any_mantissa};
/// 128 binades around 1, of each 2^13.
constexpr Arguments many_binades = {
    "    float x = number((i & 8191u) * 1024u + 333u, int(i >> 13u) - 64), y = 0.0;\n",
    [](std::uint32_t i) { return number((i & 8191u) * 1024u + 333u, static_cast<int>(i >> 13) - 64); }, any_mantissa};
/// The neighbours of 1, each of them.
constexpr Arguments around_one = {
    "    float x = uintBitsToFloat(0x3f800000u - 524288u + i), y = 0.0;\n",
    [](std::uint32_t i) { return static_cast<double>(std::bit_cast<float>(0x3f800000u - 524288u + i)); }, any_mantissa};
/// From -20 to 20.
constexpr Arguments exponents = {"    float x = (float(i) - 524288.0) * 1.25 / 32768.0, y = 0.0;\n",
                                 [](std::uint32_t i) { return (static_cast<double>(i) - 524288) * 1.25 / 32768; },
                                 any_mantissa};
/// A length across, and from -1 to 3 along.
constexpr Arguments directions = {
    "    float x = number((i & 65535u) * 128u + 77u, int(i >> 16u) - 14), y = float(h >> 12u) / 262144.0 - 1.0;\n",
    [](std::uint32_t i) { return number((i & 65535u) * 128u + 77u, static_cast<int>(i >> 16) - 14); },
    [](std::uint32_t h) { return (h >> 12) / 262144.0 - 1; }};

/// Calls visit(x, y, result) for each pixel.
void for_each_result(ProbeCanvas& canvas, const Arguments& arguments, const std::string& expression,
                     const std::function<void(double, double, double)>& visit) {
  const std::vector<float> values = canvas.evaluated(side, side,
                                                     pixel_number(side) + "    uint h = i * 2654435761u;\n" +
                                                         arguments.glsl + "    result.x = " + expression + ";\n",
                                                     declarations);
  for (std::uint32_t i = 0; i < side * side; ++i)
    visit(arguments.x(i), arguments.y(hashed(i)), static_cast<double>(values[4 * i]));
}

/// The largest relative error, in 2^-24.
double relative(ProbeCanvas& canvas, const Arguments& arguments, const std::string& expression,
                double (*exact)(double x, double y)) {
  double most = 0;
  for_each_result(canvas, arguments, expression, [&](double x, double y, double result) {
    const double right = exact(x, y), error = std::abs(result - right);
    if (error > 0)
      most =
          std::max(most, std::isfinite(error) ? error / std::abs(right) / u : std::numeric_limits<double>::infinity());
  });
  return most;
}

void probe_exp2(ProbeCanvas& canvas, FunctionErrors& errors) {
  double near = 0, slope = 0;
  for (const bool is_near : {true, false})
    for_each_result(canvas, exponents, "exp2(x)", [&](double x, double, double result) {
      const double error = std::abs(result / std::exp2(x) - 1) / u;
      if (!is_near) slope = std::max(slope, (error - near) / std::max(std::abs(x), 1.0));
      else if (std::abs(x) <= 1) near = std::max(near, error);
    });
  errors.exp2_relative = near, errors.exp2_by_exponent = slope;
}

/// Of all pairs that hold every error, the one that allows least for a logarithm of 1.
void probe_log2(ProbeCanvas& canvas, FunctionErrors& errors) {
  constexpr std::size_t candidates = 64; // of the relative part, in 2^-24
  std::array<double, candidates> rest{};
  for (const Arguments& arguments : {around_one, binades, many_binades})
    for_each_result(canvas, arguments, "log2(x)", [&](double x, double, double result) {
      const double exact = std::log2(x), error = std::abs(result - exact) / u;
      for (std::size_t k = 0; k < candidates; ++k)
        rest[k] = std::max(rest[k], error - static_cast<double>(k) * std::abs(exact));
    });
  std::size_t best = 0;
  for (std::size_t k = 1; k < candidates; ++k)
    if (static_cast<double>(k) + rest[k] < static_cast<double>(best) + rest[best]) best = k;
  errors.log2_relative = static_cast<double>(best), errors.log2_absolute = rest[best];
}

} // namespace

FunctionErrors probe_functions(ProbeCanvas& canvas) {
  FunctionErrors errors;
  const auto divided = [](double x, double y) { return x / y; };
  errors.sum = std::max(relative(canvas, binades, "x + y", [](double x, double y) { return x + y; }),
                        relative(canvas, binades, "x - y", [](double x, double y) { return x - y; }));
  errors.product = relative(canvas, binades, "x * y", [](double x, double y) { return x * y; });
  errors.quotient = std::max(relative(canvas, binades, "x / y", divided),
                             relative(canvas, binades, "1.0 / x", [](double x, double) { return 1 / x; }));
  errors.root = relative(canvas, binades, "sqrt(x)", [](double x, double) { return std::sqrt(x); });
  errors.inverse_root = relative(canvas, binades, "inversesqrt(x)", [](double x, double) { return 1 / std::sqrt(x); });
  errors.atan2_relative =
      relative(canvas, directions, "atan(x, y)", [](double x, double y) { return std::atan2(x, y); });
  probe_exp2(canvas, errors);
  probe_log2(canvas, errors);
  check_probe(canvas, "functions");
  return errors;
}

} // namespace refraster
