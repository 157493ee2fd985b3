#include <refraster/notes.h>

#include "io/image/image_formats.h"
#include "tests/support/files/image_clauses.h"
#include "tests/support/files/jpeg_bytes.h"
#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

namespace refraster::test {
namespace {

std::string without(std::string text, const std::string& part) {
  if (const std::size_t at = text.find(part); at != std::string::npos) text.erase(at, part.size());
  return text;
}

} // namespace

TEST_CASE("each clause of the specification of each format: the values are right, or a line says what is not") {
  const std::vector<ImageClause> list = all_image_clauses();
  CHECK(list.size() >= 120);
  const TemporaryFolder folder;
  for (const ImageClause& input : list) {
    CAPTURE(input.clause);
    CAPTURE(input.what);
    write_files(folder.path, {{input.name, input.bytes}});
    try {
      const ImageFile image = read_image(folder / input.name);
      const NoteList& notes = image.notes;
      CHECK(image.values.channels == input.channels);
      CHECK(image.values.values == input.values);
      CHECK(image.bits == input.bits);
      CHECK(image.full_scale == (input.bits == 8 ? 255 : input.bits == 16 ? 65535 : 1));
      const std::string note = notes.empty() ? "" : notes.notes().front().text();
      CHECK(without(without(note, folder / input.name + ": "), folder / input.name) == input.said);
      CHECK(notes.notes().size() <= 1);
    } catch (const InputError& error) {
      CHECK(input.channels == 0);
      CHECK(without(error.what(), folder / input.name + ": ") == input.said);
    }
  }
}

namespace {

/// Each of those files, cut short: read as the same, or refused. Headers at each byte, what follows at each `step`-th.
void check_cut_short(std::size_t step) {
  constexpr std::size_t header = 128;
  const TemporaryFolder folder;
  for (const ImageClause& input : all_image_clauses()) {
    if (input.channels == 0) continue;
    CAPTURE(input.clause);
    CAPTURE(input.what);
    for (std::size_t size = 1; size < input.bytes.size(); size += size < header ? 1 : step) {
      CAPTURE(size);
      write_files(folder.path, {{input.name, input.bytes.substr(0, size)}});
      std::vector<float> values = input.values;
      try {
        values = read_image(folder / input.name).values.values;
      } catch (const InputError&) {
      }
      CHECK(values == input.values);
    }
  }
}

} // namespace

TEST_CASE("each of those files, cut short, is read as the same, or refused") {
  check_cut_short(29);
}

TEST_SUITE("long") {
  TEST_CASE("each of those files, cut short anywhere, is read as the same, or refused") {
    check_cut_short(1);
  }
}

TEST_CASE("a file of another program's format is named, and the formats that are read are listed") {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  const std::pair<std::string, std::string> files[] = {
      {"GIF89a"s, "a GIF image"},
      {"RIFF\x24\0\0\0WEBPVP8 "s, "a WebP image"},
      {"II*\0\x08\0\0\0"s, "a TIFF image"},
      {"MM\0*\0\0\0\x08"s, "a TIFF image"},
      {"P6\n1 1\n255\n"s, "a PNM image"},
      {"DDS |\0\0\0"s, "a DDS image"},
      {"\0\0\0\x20"
       "ftypavif"s,
       "an AVIF image"},
      {"\0\0\0\x18"
       "ftypheic"s,
       "a HEIF image"},
      {"plain text, and much of it"s, "an unknown image type"},
      {std::string(100, '\0'), "an unknown image type"},
  };
  for (const auto& [bytes, name] : files) {
    write_files(folder.path, {{"i.png", bytes}});
    CHECK_THROWS_WITH_AS(read_image(folder / "i.png"),
                         (folder / "i.png" + ": found " + name + ", expected " + readable_formats()).c_str(),
                         InputError);
  }
}

TEST_CASE("EXIF data say how an image is held in either order of bytes, and damaged ones say nothing") {
  using namespace std::string_literals;
  const std::string little = "II*\0\x08\0\0\0\1\0\x12\1\3\0\1\0\0\0\x08\0\0\0"s;
  const std::string big = exif_bytes(8);
  for (const std::string& exif : {little, big, little.substr(0, 12), big.substr(0, 8), "II*\0\xff\xff\xff\xff"s,
                                  exif_bytes(0), exif_bytes(9), ""s}) {
    const std::size_t count = exif == little || exif == big ? 1 : 0;
    JpegBytes jpeg;
    jpeg.segments = jpeg_segment(0xe1, "Exif\0\0"s + exif);
    const TemporaryFolder folder;
    write_files(folder.path, {{"i.jpg", flat_jpeg(jpeg, {1})}});
    NoteList notes;
    read_texture(folder / "i.jpg", {}, &notes);
    CHECK(notes.notes().size() == count);
  }
}

} // namespace refraster::test
