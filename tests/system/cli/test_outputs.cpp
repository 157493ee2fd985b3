// What render writes: bits, formats, what the file says of its colours.

#include <refraster/files.h>

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster {
namespace {

struct Outputs : TemporaryFolder {
  Outputs() { save_text(*this / "s.json", ball_scene); }

  Finished run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "s.json", "--size", "40x30"});
    return run_program(path, arguments);
  }
  ImageFile image(const std::string& name, std::vector<std::string> arguments = {}) const {
    arguments.insert(arguments.end(), {"-o", name});
    const Finished done = run(arguments);
    CHECK(done.exit_code == 0);
    CHECK(done.err.empty());
    return read_image(*this / name);
  }
};

} // namespace

TEST_CASE("16 bits are the radiance times 65535, rounded; with --srgb what its curve makes of it") {
  const Outputs outputs;
  const ImageFile exact = outputs.image("a.npy"), wide = outputs.image("a.png", {"--bits", "16"}),
                  curved = outputs.image("s.png", {"--bits", "16", "--srgb"}), narrow = outputs.image("n.png");
  CHECK(exact.bits == 32);
  CHECK(wide.bits == 16);
  for (std::size_t i = 0; i < exact.values.values.size(); ++i) {
    const double value = std::clamp(static_cast<double>(exact.values.values[i]), 0.0, 1.0);
    // Half a step, and the rounding of the float.
    CHECK(std::abs(static_cast<double>(wide.values.values[i]) - 65535 * value) <= 0.5 + 65535 * 0x1p-24);
    CHECK(std::abs(static_cast<double>(narrow.values.values[i]) - 255 * value) <= 0.5 + 255 * 0x1p-24);
    const double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    CHECK(std::abs(static_cast<double>(curved.values.values[i]) - 65535 * encoded) <= 0.5 + 65535 * 12.92 * 0x1p-24);
  }
}

TEST_CASE("a PNG says that it is sRGB with --srgb only") {
  const Outputs outputs;
  outputs.image("a.png");
  outputs.image("s.png", {"--srgb"});
  CHECK(text_of(outputs / "a.png").find("sRGB") == std::string::npos);
  CHECK(text_of(outputs / "s.png").find("sRGB") < 64);
}

TEST_CASE("a JPEG looks like the PNG, and more so with more quality") {
  const Outputs outputs;
  const ImageFile png = outputs.image("a.png"), good = outputs.image("a.jpg"), bad = outputs.image("b.jpg", {"--quality", "5"});
  double good_sum = 0, bad_sum = 0;
  for (std::size_t i = 0; i < png.values.values.size(); ++i) {
    good_sum += std::abs(static_cast<double>(png.values.values[i] - good.values.values[i]));
    bad_sum += std::abs(static_cast<double>(png.values.values[i] - bad.values.values[i]));
  }
  CHECK(good_sum / static_cast<double>(png.values.values.size()) < 3);
  CHECK(good_sum < bad_sum / 2);
}

TEST_CASE("arrays of AOVs: numbers are whole, beside an image of any format") {
  const Outputs outputs;
  const Finished done = outputs.run({"-o", "a.png", "--aov", "depth,object,uv", "--aov-format", "npy"});
  CHECK(done.out == "a.png\na.depth.npy\na.object.npy\na.uv.npy\n");
  CHECK(text_of(outputs / "a.object.npy").find("'<u4'") != std::string::npos);
  CHECK(text_of(outputs / "a.depth.npy").find("'<f4'") != std::string::npos);
  CHECK(read_image(outputs / "a.uv.npy").values.channels == 2);
  const ImageFile object = read_image(outputs / "a.object.npy");
  CHECK(object.values.at(20, 15)[0] == 1);
  const Finished same = run_program(outputs.path, {"compare", "a.depth.npy", "a.depth.npy"});
  CHECK(same.exit_code == 0);
}

TEST_CASE("bits that a format has not, and a curve for floats, are wrong usage") {
  const Outputs outputs;
  const Finished wrong = outputs.run({"-o", "a.jpg", "--bits", "16"});
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.starts_with("refraster: --bits: found 16 of \"a.jpg\", expected a name ending in .png or .npy\n"));
  CHECK(outputs.run({"-o", "a.png", "--bits", "32"}).exit_code == 2);
  CHECK(outputs.run({"-o", "a.npy", "--srgb"}).exit_code == 2);
  CHECK(outputs.run({"-o", "a.npy", "--bits", "8", "--srgb"}).exit_code == 0);
}

} // namespace refraster
