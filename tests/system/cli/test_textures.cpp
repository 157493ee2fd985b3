// What a user of textures reads: notes and faults of image files.

#include "tests/support/files/image_clauses.h"
#include "tests/support/files/jpeg_bytes.h"
#include "tests/support/files/png_bytes.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

using namespace std::string_literals;

/// A scene of the folder with a texture on a plane.
struct TexturedScene : TemporaryFolder {
  TexturedScene(const std::string& texture, const std::string& bytes) {
    const std::string scene =
        test::scene_with("\"glossiness\": 8", "\"glossiness\": 8, \"texture_file_path\": \"" + texture + "\"");
    test::write_files(path, {{"s.json", scene}, {texture, bytes}});
  }
  Finished render(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"render", "s.json", "-o", "o.png", "--size", "8x8"});
    return run_program(path, more);
  }
};

std::string sideways_jpeg() {
  test::JpegBytes jpeg;
  jpeg.segments = test::jpeg_segment(0xe1, "Exif\0\0"s + test::exif_bytes(6));
  return test::flat_jpeg(jpeg, {77});
}

} // namespace

TEST_CASE("a texture with an EXIF orientation is drawn as stored, and a note says so, unless notes are errors") {
  const TexturedScene scene("t.jpg", sideways_jpeg());
  const std::string found = "t.jpg: found EXIF orientation 6, to be shown turned by 90 degrees clockwise";
  const Finished run = scene.render();
  CHECK(run.exit_code == 0);
  CHECK(run.err.find("note: " + found + ", read as its rows are stored\n") != std::string::npos);
  CHECK(scene.render({"-q"}).err.empty());
  const Finished strict = scene.render({"--strict"});
  CHECK(strict.exit_code == 3);
  CHECK(strict.err.find("refraster: " + found + ", expected a file without notes (--strict)\n") != std::string::npos);
}

TEST_CASE("compare says so too, once a file") {
  const TexturedScene folder("t.jpg", sideways_jpeg());
  test::write_files(folder.path, {{"u.jpg", sideways_jpeg()}});
  const Finished run = run_program(folder.path, {"compare", "t.jpg", "u.jpg"});
  CHECK(run.exit_code == 0);
  for (const std::string file : {"t.jpg", "u.jpg"})
    CHECK(run.err.find("note: " + file + ": found EXIF orientation 6") != std::string::npos);
  CHECK(run_program(folder.path, {"compare", "t.jpg", "u.jpg", "-q"}).err.empty());
}

TEST_CASE("a PNG of which a byte has changed is no texture: exit code 3, and the line names the chunk") {
  std::string png = test::png_bytes(4, 4, 3, 8, std::vector<std::uint16_t>(48, 100));
  png[60] ^= 1; // a sample
  const Finished pixels = TexturedScene("t.png", png).render();
  CHECK(pixels.exit_code == 3);
  CHECK(pixels.err == "refraster: t.png: chunk IDAT: found a checksum that does not fit the pixels, expected their "
                      "Adler-32: the file is damaged\n");
  png = test::png_bytes(4, 4, 3, 8, std::vector<std::uint16_t>(48, 100));
  png[19] = 2; // the width
  const Finished header = TexturedScene("t.png", png).render();
  CHECK(header.exit_code == 3);
  CHECK(header.err ==
        "refraster: t.png: chunk IHDR: found a CRC that does not fit the chunk, expected that of its type "
        "and data: the file is damaged\n");
}

TEST_CASE("a BMP with a palette or a gap before pixels of 24 bits is the picture that a PNG of its colours is") {
  const TemporaryFolder folder;
  std::size_t compared = 0;
  for (const test::ImageClause& input : test::bmp_clauses()) {
    if (input.what != "pixels behind a gap" && input.what != "a palette before pixels of 24 bits") continue;
    test::write_files(folder.path,
                      {{"i.bmp", input.bytes}, {"i.png", test::png_bytes(2, 1, 3, 8, {1, 2, 3, 4, 5, 6})}});
    const Finished run = run_program(folder.path, {"compare", "i.bmp", "i.png"});
    CHECK_MESSAGE(run.exit_code == 0, run.err);
    ++compared;
  }
  CHECK(compared == 2);
}
