// refraster compare

#include "program.h"
#include "scenes.h"

#include "io/image_file.h"

#include <doctest/doctest.h>

#include <limits>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

/// Images that differ in one pixel.
struct PairFolder : TemporaryFolder {
  PairFolder() {
    Image<std::uint8_t> image(4, 3, 3, 100);
    write_png(*this / "a.png", image);
    image.at(2, 1)[1] = 107;
    write_png(*this / "b.png", image);
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

TEST_CASE("an 8-bit image equals its own float image") {
  const PairFolder folder;
  Image<float> image(4, 3, 3, 100.0F / 255.0F);
  write_float_image(folder / "a.pfm", image);
  CHECK(folder.compare({"a.png", "a.pfm"}).exit_code == 0);
  CHECK(folder.compare({"a.pfm", "b.png"}).exit_code == 1);
}

TEST_CASE("an image of NaN does not equal itself") {
  const PairFolder folder;
  write_float_image(folder / "nan.pfm", Image<float>(2, 2, 3, std::numeric_limits<float>::quiet_NaN()));
  const Finished run = folder.compare({"nan.pfm", "nan.pfm", "--max-abs", "1e30", "--max-count", "1000"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("NaN") != std::string::npos);
}

TEST_CASE("images that cannot be compared are bad input") {
  const PairFolder folder;
  write_png(folder / "wide.png", Image<std::uint8_t>(5, 3, 3));
  write_float_image(folder / "grey.pfm", Image<float>(4, 3, 1));
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
    write_float_image(folder / name, Image<float>(4, 3, channels), std::move(names));
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
