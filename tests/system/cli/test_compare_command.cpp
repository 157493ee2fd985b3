// refraster compare

#include <refraster/files.h>

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include "tests/support/files/png_bytes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

/// Images that differ in one pixel.
struct PairFolder : TemporaryFolder {
  PairFolder() {
    Image<std::uint8_t> image(4, 3, 3, 100);
    write_image(*this / "a.png", image);
    image.at(2, 1)[1] = 107;
    write_image(*this / "b.png", image);
  }
  Finished compare(Words words) const {
    words.insert(words.begin(), "compare");
    return run_program(path, words);
  }
};

} // namespace

TEST_CASE("an image equals itself: exit code 0") {
  const PairFolder folder;
  const Finished run = folder.compare({"a.png", "a.png"});
  CHECK(run.exit_code == 0);
  CHECK(run.out.starts_with("equal\n"));
}

TEST_CASE("one level in one pixel: exit code 1, and where it is") {
  const PairFolder folder;
  const Finished run = folder.compare({"a.png", "b.png"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.starts_with("differ\n"));
  CHECK(run.out.find("(2, 1)") != std::string::npos);
  CHECK(run.out.find("100 107 100") != std::string::npos);
  CHECK(run.err.empty());
}

TEST_CASE("limits decide the exit code") {
  const PairFolder folder;
  CHECK(folder.compare({"a.png", "b.png", "--max-abs", "7"}).exit_code == 0);
  CHECK(folder.compare({"a.png", "b.png", "--max-abs", "6.5"}).exit_code == 1);
  CHECK(folder.compare({"a.png", "b.png", "--max-count", "1"}).exit_code == 0);
  CHECK(folder.compare({"a.png", "b.png", "--max-count", "0"}).exit_code == 1);
  CHECK(folder.compare({"a.png", "b.png", "--max-rms", "1.17"}).exit_code == 0); // 7 / 6 = 1.1667
  CHECK(folder.compare({"a.png", "b.png", "--max-rms", "1.16"}).exit_code == 1);
}

TEST_CASE("the heat image shows the images' pixels, and below them a legend") {
  const PairFolder folder;
  CHECK(folder.compare({"a.png", "b.png", "--diff", "d.png"}).exit_code == 1);
  const auto heat = read_image(folder / "d.png").values;
  CHECK(heat.width > 4); // the legend is wider than this image
  CHECK(heat.height > 3);
  CHECK(heat.at(0, 0)[0] == 0);
  CHECK(heat.at(2, 1)[0] > 0);
}

TEST_CASE("JSON goes to a file beside the text, or alone to standard output") {
  const PairFolder folder;
  CHECK(folder.compare({"a.png", "b.png", "--json", "r.json"}).out.starts_with("differ\n"));
  const std::string json = folder.compare({"a.png", "b.png", "--json", "-"}).out;
  CHECK(json == text_of(folder / "r.json"));
  CHECK(json.find("\"max\": 7.0") != std::string::npos);
}

TEST_CASE("--html writes a page of its own; the report and the exit code are as without it") {
  const PairFolder folder;
  const Finished plain = folder.compare({"a.png", "b.png"}),
                 run = folder.compare({"a.png", "b.png", "--html", "p.html"});
  CHECK(run.exit_code == 1);
  CHECK(run.out == plain.out);
  CHECK(text_of(folder / "p.html").starts_with("<!doctype html>"));
  CHECK(folder.compare({"a.png", "a.png", "--html", "p.html"}).exit_code == 0);
  CHECK(folder.compare({"a.png", "b.png", "--html", "a.png"}).exit_code == 2);
  CHECK(folder.compare({"a.png", "b.png", "--html", "no/p.html"}).exit_code == 4);
  CHECK(text_of(folder / "a.png").starts_with("\x89PNG"));
}

TEST_CASE("--scene names clusters by the objects that its camera sees there") {
  const TemporaryFolder folder;
  save_text(folder / "s.json", R"({"scene": {
    "camera": {"position": "0 0 3", "target": "0 0 0", "fov_y": 90}, "point_lights": [], "direction_lights": [],
    "objects": [{"name": "left", "mesh": {"cube": {}}, "fragment_function": "phong",
                 "position": "-2 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
                 "material": {"ka": "1 1 1", "kd": "0 0 0", "ks": "0 0 0", "glossiness": 1}}]}})");
  Image<std::uint8_t> image(60, 40, 3);
  for (const int x : {14, 15, 50, 51}) std::fill_n(image.at(x, 20), 3, std::uint8_t{255}); // on the cube, and beside it
  Image<std::uint8_t> black(60, 40, 3);
  write_image(folder / "b.png", image);
  write_image(folder / "c.png", black);
  const Finished run = run_program(folder.path, {"compare", "c.png", "b.png", "--scene", "s.json", "--json", "r.json"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("x 14 to 15, y 20 to 20; worst at (14, 20): 255\n                 of left\n") !=
        std::string::npos);
  CHECK(run.out.find("x 50 to 51, y 20 to 20; worst at (50, 20): 255\n                 of background\n") !=
        std::string::npos);
  const std::string json = text_of(folder / "r.json");
  CHECK(json.find("\"scene\": \"s.json\"") != std::string::npos);
  CHECK(json.find("\"name\": \"left\"") != std::string::npos);
  CHECK(run_program(folder.path, {"compare", "c.png", "b.png", "--scene", "none.json"}).exit_code == 3);
  const std::string without = run_program(folder.path, {"compare", "c.png", "b.png", "--json", "-"}).out;
  CHECK(without.find("\"objects\": null") != std::string::npos);
  CHECK(without.find("\"scene\": null") != std::string::npos);
}

TEST_CASE("an 8-bit image equals its own float image") {
  const PairFolder folder;
  Image<float> image(4, 3, 3, 100.0F / 255.0F);
  write_image(folder / "a.pfm", image);
  CHECK(folder.compare({"a.png", "a.pfm"}).exit_code == 0);
  CHECK(folder.compare({"a.pfm", "b.png"}).exit_code == 1);
}

TEST_CASE("an image of NaN does not equal itself") {
  const PairFolder folder;
  write_image(folder / "nan.pfm", Image<float>(2, 2, 3, std::numeric_limits<float>::quiet_NaN()));
  const Finished run = folder.compare({"nan.pfm", "nan.pfm", "--max-abs", "1e30", "--max-count", "1000"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("NaN") != std::string::npos);
}

/// An 8-bit picture of two pixels, black and white, and its negative, as files of every format.
struct NegativeFolder : PairFolder {
  NegativeFolder() {
    const auto write = [&](const std::string& name, float left, float right) {
      Image<float> image(2, 1, 3, left);
      std::fill_n(image.at(1, 0), 3, right);
      for (const char* const format : {".pfm", ".exr", ".hdr"}) write_image(*this / (name + format), image);
      const auto integers = [&](double full_scale) {
        std::vector<std::uint16_t> values;
        for (const float value : image.values)
          values.push_back(static_cast<std::uint16_t>(static_cast<double>(value) * full_scale));
        return values;
      };
      test::write_files(path, {{name + "8.png", test::png_bytes(2, 1, 3, 8, integers(255))},
                               {name + "16.png", test::png_bytes(2, 1, 3, 16, integers(65535))}});
    };
    write("picture", 0, 1);
    write("negative", 1, 0);
  }
};
constexpr const char* formats[] = {"8.png", "16.png", ".pfm", ".exr", ".hdr"};

TEST_CASE("a limit is in levels whatever the files hold: no picture equals its negative within 2") {
  const NegativeFolder folder;
  save_text(folder.path / "limits.json", "{\"max_abs\": 2}");
  for (const std::string first : formats)
    for (const std::string second : formats) {
      INFO(first << " beside " << second);
      const Finished run = folder.compare({"picture" + first, "negative" + second, "--max-abs", "2"});
      CHECK(run.exit_code == 1);
      CHECK(run.out.starts_with("differ by more than max-abs 2 levels\n"));
      CHECK(run.out.find("\nmax            255\n") != std::string::npos);
      CHECK(folder.compare({"picture" + first, "negative" + second, "--limits", "limits.json"}).exit_code == 1);
      CHECK(folder.compare({"picture" + first, "picture" + second}).exit_code == 0);
    }
}

TEST_CASE("--unit values asks for values in limits and report, and a file of limits has a unit of its own") {
  const PairFolder folder; // 7 levels apart
  Finished run = folder.compare({"a.png", "b.png", "--unit", "values", "--max-abs", "0.0275", "--json", "r.json"});
  CHECK(run.exit_code == 0);
  CHECK(run.out.starts_with("equal within max-abs 0.0275\n"));
  CHECK(run.out.find("compared in values") != std::string::npos);
  CHECK(text_of(folder / "r.json").find("\"unit\": \"values\"") != std::string::npos);
  CHECK(folder.compare({"a.png", "b.png", "--unit", "values", "--max-abs", "0.0274"}).exit_code == 1);
  save_text(folder.path / "limits.json", "{\"max_abs\": 0.0275, \"unit\": \"values\"}");
  CHECK(folder.compare({"a.png", "b.png", "--limits", "limits.json"}).exit_code == 0);
  CHECK(folder.compare({"a.png", "b.png", "--limits", "limits.json", "--unit", "values"}).exit_code == 0);
  save_text(folder.path / "limits.json", "{\"max_abs\": 0.0275}");
  CHECK(folder.compare({"a.png", "b.png", "--limits", "limits.json"}).exit_code == 1);
  // The same numbers in both units: 7 levels.
  run = folder.compare({"a.png", "b.png", "--json", "-"});
  CHECK(run.out.find("\"unit\": \"levels\"") != std::string::npos);
  CHECK(run.out.find("\"max\": 7.0") != std::string::npos);
}

TEST_CASE("a limit that no two images of 8 or 16 bits can exceed gets a note") {
  const NegativeFolder folder;
  CHECK(folder.compare({"picture8.png", "negative16.png", "--max-abs", "255"}).err.starts_with("note: no two images"));
  CHECK(folder.compare({"picture8.png", "negative16.png", "--max-abs", "254"}).err.empty());
  CHECK(
      folder.compare({"picture8.png", "negative8.png", "--max-abs", "2", "--unit", "values"}).err.starts_with("note:"));
  CHECK(folder.compare({"picture.pfm", "negative.pfm", "--max-abs", "255"}).err.empty()); // these could
}

TEST_CASE("alpha: of 1 it is left out with a note, else the choices are named, and each does what it says") {
  const PairFolder folder;
  write_image(folder / "rgb.exr", Image<float>(2, 1, 3, 0.5f));
  write_image(folder / "opaque.exr", [] {
    Image<float> image(2, 1, 4, 0.5f);
    image.at(0, 0)[3] = image.at(1, 0)[3] = 1;
    return image;
  }());
  write_image(folder / "glass.exr", Image<float>(2, 1, 4, 0.5f));
  const Finished opaque = folder.compare({"rgb.exr", "opaque.exr"});
  CHECK(opaque.exit_code == 0);
  CHECK(opaque.err == "note: opaque.exr: alpha is 1 everywhere and is left out\n");
  const Finished refused = folder.compare({"rgb.exr", "glass.exr"});
  CHECK(refused.exit_code == 3);
  CHECK(refused.err.find("--alpha over:R,G,B") != std::string::npos);
  CHECK(folder.compare({"rgb.exr", "glass.exr", "--alpha", "ignore"}).exit_code == 0);
  CHECK(folder.compare({"rgb.exr", "glass.exr", "--alpha", "over:0,0,0"}).exit_code == 0); // EXR: premultiplied
  CHECK(folder.compare({"rgb.exr", "glass.exr", "--alpha", "over:0.5,0.5,0.5", "--premultiplied", "no"}).exit_code ==
        0);
  CHECK(folder.compare({"rgb.exr", "glass.exr", "--alpha", "over:0,0,0", "--premultiplied", "no"}).exit_code == 1);
  CHECK(folder.compare({"rgb.exr", "glass.exr", "--alpha", "compare"}).exit_code == 1);
  CHECK(folder.compare({"glass.exr", "glass.exr", "--alpha", "compare"}).exit_code == 0);
}

TEST_CASE("the kind of difference is said in the report and its JSON; the exit code stays 1") {
  const PairFolder folder;
  Image<std::uint8_t> image(40, 30, 3), turned(40, 30, 3);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = turned.at(x, 29 - y)[c] = static_cast<std::uint8_t>((x * x + 7 * y + 50 * c) % 256);
  write_image(folder / "image.png", image);
  write_image(folder / "turned.png", turned);
  const Finished run = folder.compare({"image.png", "turned.png", "--max-abs", "2", "--json", "r.json"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.starts_with(
      "differ by more than max-abs 2 levels\n"
      "cause          b is a turned upside down: then equal\n"
      "               then max 0, rms 0, 1200 of 1200 pixels equal within the limit and rounding\n"));
  const std::string json = text_of(folder / "r.json");
  for (const char* const member : {"\"name\": \"upside_down\"", "\"text\": \"b is a turned upside down: then equal\"",
                                   "\"within\": 1200", "\"compressed\": null"})
    CHECK_MESSAGE(json.find(member) != std::string::npos, member);
  CHECK(folder.compare({"a.png", "b.png", "--json", "-"}).out.find("\"transformation\": null") != std::string::npos);
  write_image(folder / "half.png", Image<std::uint8_t>(20, 15, 3));
  const Finished half = folder.compare({"image.png", "half.png"});
  CHECK(half.exit_code == 3);
  CHECK(half.err.find("; b is a at half size") != std::string::npos);
}

TEST_CASE("--flip is done for 8 and 16 bits, also grey and with an alpha, and refused with the reason for others") {
  const NegativeFolder folder;
  const auto flip = [&](const std::string& a, const std::string& b, Words more = {}) {
    more.insert(more.begin(), {a, b, "--flip"});
    return folder.compare(more);
  };
  const auto number_of = [](const Finished& run) {
    const std::size_t place = run.out.find("\nflip           ");
    return place == std::string::npos ? std::string() : run.out.substr(place + 16, 8);
  };
  const Finished eight = flip("picture8.png", "negative8.png");
  CHECK(eight.exit_code == 1);
  CHECK(number_of(eight).size() == 8);
  CHECK(number_of(flip("picture16.png", "negative16.png")) == number_of(eight));
  CHECK(number_of(flip("picture8.png", "negative16.png")) == number_of(eight));
  test::write_files(folder.path, {{"rgba.png", test::png_bytes(2, 1, 4, 8, {255, 255, 255, 255, 0, 0, 0, 255})},
                                  {"glass.png", test::png_bytes(2, 1, 4, 8, {255, 255, 255, 9, 0, 0, 0, 9})},
                                  {"grey.png", test::png_bytes(2, 1, 1, 8, {0, 255})},
                                  {"grey_negative.png", test::png_bytes(2, 1, 1, 8, {255, 0})}});
  CHECK(number_of(flip("picture8.png", "rgba.png")) == number_of(eight));
  CHECK(number_of(flip("grey.png", "grey_negative.png")) == number_of(eight));
  CHECK(number_of(flip("picture8.png", "glass.png", {"--alpha", "ignore"})) == number_of(eight));
  for (const char* const format : {".pfm", ".exr", ".hdr"}) {
    const Finished refused = flip("picture8.png", std::string("negative") + format);
    CHECK(refused.exit_code == 3);
    CHECK(refused.err.find("found values of floating point, expected ") != std::string::npos);
    CHECK(refused.err.find("--flip compares what a screen shows") != std::string::npos);
  }
  CHECK(flip("picture8.png", "glass.png", {"--alpha", "compare"}).exit_code == 3);
}

TEST_CASE("--heat-max sets the end of the ramp: the same difference has one colour in two heat images") {
  const PairFolder folder;
  Image<std::uint8_t> far = [] { return Image<std::uint8_t>(4, 3, 3, 100); }();
  far.at(2, 1)[1] = 107, far.at(0, 0)[0] = 250;
  write_image(folder / "far.png", far);
  const auto colour = [&](const char* other, Words more) {
    more.insert(more.begin(), {"a.png", other, "--diff", "d.png"});
    CHECK(folder.compare(more).exit_code == 1);
    const ImageFile heat = read_image(folder / "d.png");
    return std::vector<float>(heat.values.at(2, 1), heat.values.at(2, 1) + 3);
  };
  CHECK(colour("b.png", {}) != colour("far.png", {}));
  CHECK(colour("b.png", {"--heat-max", "50"}) == colour("far.png", {"--heat-max", "50"}));
  CHECK(colour("b.png", {"--heat-max", "50"}) == colour("b.png", {"--heat-max", "50", "--unit", "values"}));
  CHECK(folder.compare({"a.png", "b.png", "--heat-max", "50"}).exit_code == 2);
}

TEST_CASE("-q prints nothing but errors: the exit code tells") {
  const NegativeFolder folder;
  test::write_files(folder.path, {{"rgba.png", test::png_bytes(2, 1, 4, 8, {0, 0, 0, 255, 255, 255, 255, 255})}});
  const Finished equal = folder.compare({"picture8.png", "rgba.png", "-q"});
  CHECK(equal.exit_code == 0);
  CHECK(equal.out.empty());
  CHECK(equal.err.empty());
  const Finished differ = folder.compare({"rgba.png", "negative8.png", "--quiet", "--max-abs", "255", "--json", "-"});
  CHECK(differ.exit_code == 0);
  CHECK(differ.out.starts_with("{"));
  CHECK(differ.out.find("rgba.png: alpha is 1 everywhere and is left out") != std::string::npos); // in the JSON
  CHECK(differ.err.empty());
  CHECK(folder.compare({"rgba.png", "negative8.png", "-q"}).exit_code == 1);
  CHECK_FALSE(folder.compare({"rgba.png", "none.png", "-q"}).err.empty());
}

TEST_CASE("the exposure of an HDR file is divided out, with a note") {
  const PairFolder folder;
  save_text(folder.path / "plain.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x40\x20\x81");
  save_text(folder.path / "exposed.hdr",
            "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y 1 +X 1\n\x80\x40\x20\x82");
  const Finished run = folder.compare({"plain.hdr", "exposed.hdr"});
  CHECK(run.exit_code == 0);
  CHECK(run.err == "note: exposed.hdr:3: found 1 line of EXPOSURE or COLORCORR, values are divided by 2\n");
}

TEST_CASE("images that cannot be compared are bad input") {
  const PairFolder folder;
  write_image(folder / "wide.png", Image<std::uint8_t>(5, 3, 3));
  write_image(folder / "grey.pfm", Image<float>(4, 3, 1));
  save_text(folder / "empty.png", "");
  save_text(folder / "text.png", "not an image");
  for (const char* other : {"wide.png", "grey.pfm", "empty.png", "text.png", "none.png", "."}) {
    const Finished run = folder.compare({"a.png", other});
    INFO(other << "\n" << run.err);
    CHECK(run.exit_code == 3);
    CHECK_FALSE(run.err.empty());
    CHECK(run.out.empty());
  }
  CHECK(folder.compare({"a.png", "wide.png"}).err.find("5 x 3") != std::string::npos);
}

TEST_CASE("EXR files say what their channels are: others are not compared, one alone is what it is") {
  const PairFolder folder;
  const auto write = [&](const char* name, int channels, std::vector<std::string> names) {
    write_image(folder / name, Image<float>(4, 3, channels), std::move(names));
  };
  write("rgb.exr", 3, {});
  write("xyz.exr", 3, {"X", "Y", "Z"});
  write("y.exr", 1, {});
  write("z.exr", 1, {"Z"});
  const Finished other = folder.compare({"rgb.exr", "xyz.exr"});
  CHECK(other.exit_code == 3);
  CHECK(other.err.find("channels X, Y, Z, expected channels R, G, B as rgb.exr has") != std::string::npos);
  CHECK(folder.compare({"rgb.exr", "rgb.exr"}).exit_code == 0);
  CHECK(folder.compare({"xyz.exr", "xyz.exr"}).exit_code == 0);
  CHECK(folder.compare({"y.exr", "z.exr"}).exit_code == 0);
}

TEST_CASE("a heat image that cannot be written is exit code 4") {
  const PairFolder folder;
  CHECK(folder.compare({"a.png", "b.png", "--diff", "none/d.png"}).exit_code == 4);
  CHECK(folder.compare({"a.png", "b.png", "--json", "none/d.json"}).exit_code == 4);
}

TEST_CASE("limits may come from a file, and options go before it") {
  const PairFolder folder;
  save_text(folder.path / "limits.json", "{\"max_abs\": 255, \"max_count\": 0}");
  CHECK(folder.compare({"a.png", "b.png", "--limits", "limits.json"}).exit_code == 0);
  CHECK(folder.compare({"a.png", "b.png", "--limits", "limits.json", "--max-abs", "0"}).exit_code == 1);
  save_text(folder.path / "limits.json", "{\"max\": 1}");
  const Finished wrong = folder.compare({"a.png", "b.png", "--limits", "limits.json"});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.err.find("limits.json:1:2: /max: found an unknown key") != std::string::npos);
}
