// What render writes: bits, formats, what the file says of its colours.

#include <refraster/files.h>
#include <refraster/frame.h>

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

TEST_CASE("a transparent image: straight in PNG, premultiplied in EXR; a JPEG has none, which is noted") {
  const Outputs outputs;
  const std::vector<std::string> asked = {"--transparent", "--samples", "4"};
  const ImageFile png = outputs.image("a.png", asked), wide = outputs.image("w.png", {"--transparent", "--samples", "4", "--bits", "16"}),
                  exr = outputs.image("a.exr", asked);
  REQUIRE(png.values.channels == 4);
  REQUIRE(wide.values.channels == 4);
  CHECK(exr.channels == std::vector<std::string>{"R", "G", "B", "A"});
  bool some_part = false;
  for (std::size_t i = 0; i < 40 * 30; ++i) {
    const double alpha = static_cast<double>(exr.values.values[4 * i + 3]);
    CHECK(static_cast<double>(png.values.values[4 * i + 3]) == std::nearbyint(255 * alpha));
    CHECK(static_cast<double>(wide.values.values[4 * i + 3]) == std::nearbyint(65535 * alpha));
    some_part = some_part || (alpha > 0 && alpha < 1);
    for (std::size_t c = 0; c < 3; ++c) {
      const double premultiplied = static_cast<double>(exr.values.values[4 * i + c]);
      if (alpha == 0) CHECK(premultiplied == 0);
      const double straight = alpha == 0 ? 0 : std::min(premultiplied / alpha, 1.0);
      CHECK(std::abs(static_cast<double>(png.values.values[4 * i + c]) - 255 * straight) <= 0.5001);
    }
  }
  CHECK(some_part);
  const Finished jpeg = outputs.run({"-o", "a.jpg", "--transparent"});
  CHECK(jpeg.exit_code == 0);
  CHECK(jpeg.err == "note: a.jpg: a JPEG has no alpha: the image is drawn over the background\n");
  CHECK(outputs.run({"-o", "a.pfm", "--transparent"}).exit_code == 2);
}

TEST_CASE("layers of one EXR: their names, numbers as such, each as the file beside the image; compare takes one") {
  const Outputs outputs;
  const ImageFile layers = outputs.image("a.exr", {"--layers"});
  CHECK(files_in(outputs) == std::vector<std::string>{"a.exr", "s.json"});
  for (const AovKind& kind : aov_kinds)
    for (int c = 0; c < kind.channels; ++c)
      CHECK(std::count(layers.channels.begin(), layers.channels.end(), kind.exr_names[static_cast<std::size_t>(c)]) == 1);
  CHECK(text_of(outputs / "a.exr").find("object.ID") < 1024);
  REQUIRE(outputs.run({"-o", "b.exr", "--aov", "normal,distance,object"}).exit_code == 0);
  const ImageFile normal = read_image(outputs / "b.normal.exr"), object = read_image(outputs / "b.object.exr");
  const auto plane = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(layers.channels.begin(), layers.channels.end(), name) - layers.channels.begin());
  };
  const std::size_t count = layers.channels.size();
  for (std::size_t i = 0; i < 40 * 30; ++i) {
    CHECK(layers.values.values[i * count + plane("N.Y")] == normal.values.values[3 * i + 1]);
    CHECK(layers.values.values[i * count + plane("object.ID")] == object.values.values[i]);
  }
  const Finished same = run_program(outputs.path, {"compare", "a.exr", "a.exr", "--layer", "N"});
  CHECK(same.exit_code == 0);
  CHECK(same.out.find("N.X") + same.err.find("N.X") != 2 * std::string::npos);
  REQUIRE(run_program(outputs.path, {"render", "s.json", "--size", "40x30", "-o", "c.exr", "--layers", "--samples", "4",
                                     "--aov-filter", "resolve"})
              .exit_code == 0);
  CHECK(run_program(outputs.path, {"compare", "a.exr", "c.exr", "--layer", "Z"}).exit_code == 1);
  CHECK(run_program(outputs.path, {"compare", "a.exr", "a.exr", "--layer", "Z"}).exit_code == 0);
  CHECK(outputs.run({"-o", "a.png", "--layers"}).exit_code == 2);
  if (std::system("exrheader / >/dev/null 2>&1") >> 8 == 127) {
    MESSAGE("exrheader is not installed (scripts/setup openexr)");
    return;
  }
  const std::string listed = "exrheader " + outputs / "a.exr" + " >" + outputs / "header";
  REQUIRE(std::system(listed.c_str()) == 0);
  const std::string header = text_of(outputs / "header");
  CHECK(header.find("object.ID, 32-bit unsigned integer") != std::string::npos);
  CHECK(header.find("N.X, 32-bit floating-point") != std::string::npos);
}

} // namespace refraster
