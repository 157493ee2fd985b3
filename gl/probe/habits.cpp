#include "gl/probe/habits.h"

#include <cmath>

namespace refraster {

HabitFacts probe_habits(ProbeCanvas& canvas) {
  constexpr int width = 256;
  const std::string arguments = pixel_number(width) +
                                // Numbers that no compiler knows: their bits are made of the pixel's number.
                                "    float zero = uintBitsToFloat(i & 0x80000000u);\n";
  HabitFacts facts;
  const auto first = [&](const std::string& body, std::size_t channel) {
    return static_cast<double>(canvas.evaluated(width, 1, arguments + body)[channel]);
  };
  // (1 + 2^-12)^2 - 1 - 2^-11 is 2^-24, which a rounded product has lost.
  facts.fuses = first("    float a = 1.0 + 1.0 / 4096.0 + zero, c = -1.0 - 1.0 / 2048.0 + zero;\n"
                      "    result.x = a * a + c;\n",
                      0) != 0;
  const std::string denormals = "    float small = uintBitsToFloat(0x00800000u | (i & 0x80000000u)); // 2^-126\n"
                                "    float denormal = uintBitsToFloat(0x00000100u | (i & 0x80000000u)); // 2^-141\n"
                                "    float large = uintBitsToFloat(0x7f000000u | (i & 0x80000000u)); // 2^127\n"
                                "    result = vec4(small * (0.25 + zero) * large, denormal * large, 0.0, 0.0);\n";
  facts.keeps_denormals = first(denormals, 0) != 0;
  facts.reads_denormals = first(denormals, 1) != 0;

  // A compiler may make one power of a product of two, so that no power may follow.
  const std::vector<float> powers = canvas.evaluated(
      width, 1, arguments + "    result.x = exp2(-float(i)) * uintBitsToFloat(0x71800000u | (i & 0x80000000u));\n");
  for (int i = 0; i <= 160 && powers[4 * static_cast<std::size_t>(i)] != 0; ++i) facts.min_exp2 = -i;

  const std::string nan = "    float nan = uintBitsToFloat(0x7fc00000u | (i & 0x80000000u)), one = 1.0 + zero;\n"
                          "    result = vec4(min(nan, one), min(one, nan), max(nan, one), max(one, nan));\n";
  const auto is_one = [&](std::size_t channel) { return first(nan, channel) == 1; };
  facts.min_of_nan_is_number = is_one(0) && is_one(1);
  facts.max_of_nan_is_number = is_one(2) && is_one(3);
  check_probe(canvas, "habits");
  return facts;
}

} // namespace refraster
