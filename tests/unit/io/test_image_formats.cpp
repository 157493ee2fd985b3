// The list of image formats, and what each format on it must have elsewhere.

#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"
#include "tests/support/files/image_clauses.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/page_part.h"

#include <doctest/doctest.h>

#include <set>

namespace refraster::test {
namespace {

std::string extension_of(const ImageFormat& format) {
  return "." + std::string(format.extensions[0]);
}

/// Null where no reader takes the bytes.
const ImageFormat* format_of(const std::string& bytes) {
  try {
    return &format_of_content("i", bytes);
  } catch (const InputError&) {
    return nullptr;
  }
}

/// `\x89PNG`: control characters and those beyond ASCII by their number.
std::string printable(std::string_view bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) text += c;
    else if (c == '\n') text += "\\n";
    else (text += "\\x") += {digits[byte / 16], digits[byte % 16]};
  }
  return text;
}

/// The table of docs/image-formats.md.
std::string markdown() {
  const auto in_code = [](const std::string& text) { return "`" + text + "`"; };
  std::string text = "| format | names end in | files begin with | values | written with |\n|---|---|---|---|---|\n";
  for (const ImageFormat& format : image_formats) {
    std::vector<std::string> extensions, signatures, counts;
    for (const std::string_view extension : format.extensions)
      if (!extension.empty()) extensions.push_back(in_code("." + std::string(extension)));
    for (const std::string_view signature : format.signatures)
      if (!signature.empty()) signatures.push_back(in_code(printable(signature)));
    for (const int count : format.writes.counts)
      if (count != 0) counts.push_back(count == ChannelCounts::any ? "any number of" : std::to_string(count));
    text += "| " + std::string(format.name) + " | " + alternatives(extensions) + " | " +
            (signatures.empty() ? "no signature" : alternatives(signatures)) + " | " +
            (format.values == ImageValues::integers ? "whole numbers" : "floats") + " | " +
            (counts.empty() ? "not written" : alternatives(counts) + " channels") + " |\n";
  }
  return text;
}

} // namespace

TEST_CASE("each format says how its files are named and recognised, and writes what it stores") {
  std::set<std::string_view> names, extensions;
  for (const ImageFormat& format : image_formats) {
    CAPTURE(format.name);
    CHECK(names.insert(format.name).second);
    REQUIRE_FALSE(format.extensions[0].empty());
    for (const std::string_view extension : format.extensions) {
      if (extension.empty()) continue;
      CHECK(extensions.insert(extension).second);
      CHECK(format_of_name("a/b." + std::string(extension)) == &format);
    }
    for (const std::string_view signature : format.signatures)
      if (!signature.empty()) CHECK(format_with_signature(std::string(signature) + "...") == &format);
    CHECK(format.signatures[0].empty() == (format.may_be != nullptr));
    const bool is_written = format.writes != ChannelCounts{};
    CHECK((format.write_integers != nullptr) == (is_written && format.values == ImageValues::integers));
    CHECK((format.write_floats != nullptr) == (is_written && format.values == ImageValues::floats));
  }
}

TEST_CASE("each format has clauses of its specification, files that are read and files that are refused") {
  std::set<const ImageFormat*> read, refused;
  for (const ImageClause& clause : all_image_clauses()) {
    const ImageFormat* const format = format_of(clause.bytes);
    if (!format) continue;
    (clause.channels > 0 ? read : refused).insert(format);
    if (clause.channels > 0) CHECK((clause.bits == 32) == (format->values == ImageValues::floats));
  }
  for (const ImageFormat& format : image_formats) {
    CAPTURE(format.name);
    CHECK_MESSAGE(read.count(&format) == 1,
                  "tests/support/files/image_clauses.h, which fuzzers start from, has no file that is read");
    CHECK_MESSAGE(refused.count(&format) == 1, "tests/support/files/image_clauses.h has no file that is refused");
  }
}

TEST_CASE("each format has malformed inputs, of which one says a size that its file cannot hold") {
  std::set<const ImageFormat*> malformed, too_large;
  for (const MalformedInput& input : malformed_inputs())
    for (const TestFile& file : input.files) {
      if (input.reader != Reader::image || file.name != input.input) continue;
      const ImageFormat* const format = format_of(file.content);
      if (!format) continue;
      malformed.insert(format);
      if (input.expected.find(" pixels, expected ") != std::string::npos) too_large.insert(format);
    }
  for (const ImageFormat& format : image_formats) {
    CAPTURE(format.name);
    CHECK_MESSAGE(malformed.count(&format) == 1,
                  "tests/support/files/malformed_images.cpp has no input of this format");
    CHECK_MESSAGE(too_large.count(&format) == 1,
                  "tests/support/files/malformed_images.cpp has no size beyond its file");
  }
}

TEST_CASE("what a format writes it reads back, of each number of channels that it says it writes, and of no other") {
  const TemporaryFolder folder;
  for (const ImageFormat& format : image_formats)
    for (int channels = 1; channels <= 5; ++channels) {
      CAPTURE(format.name);
      CAPTURE(channels);
      const std::string path = folder / "i" + extension_of(format);
      Image<std::uint8_t> integers(3, 2, channels);
      Image<float> floats(3, 2, channels);
      for (std::size_t i = 0; i < floats.values.size(); ++i) {
        integers.values[i] = static_cast<std::uint8_t>(128 + 3 * i);
        floats.values[i] = static_cast<float>(integers.values[i]); // which 8 bits of mantissa hold
      }
      const bool has_names = format.writes.contains(5);
      std::vector<std::string> names = default_channels(channels);
      if (has_names && channels == 2) names = {"U", "V"};
      if (channels == 5) names.push_back("Z");
      const auto write = [&] {
        if (format.values == ImageValues::integers) write_image(path, integers);
        else write_image(path, floats, names);
      };
      const ImageContent content{format.values, channels};
      CHECK(can_write(format, content) == (format_to_write(path, {content}) == &format));
      if (!can_write(format, content)) {
        CHECK_THROWS_AS(write(), InputError);
        continue;
      }
      write();
      CHECK(format_of(read_file(path, "an image", 1 << 20)) == &format);
      const ImageFile read = read_image(path);
      CHECK(read.values.values == floats.values);
      CHECK(read.channels == names);
      CHECK((read.bits == 32) == (format.values == ImageValues::floats));
    }
}

TEST_CASE("messages list what can be written and read, and a name's extension says the format in any case") {
  CHECK(writable_extensions({rgb8_image}) == ".png");
  CHECK(writable_extensions({float_rgb_image}) == ".hdr, .pfm or .exr");
  CHECK(writable_extensions({rgb8_image, float_rgb_image}) == ".png, .hdr, .pfm or .exr");
  CHECK(writable_extensions({float_grey_image}) == ".pfm or .exr");
  CHECK(readable_formats() == "PNG, JPEG, BMP, TGA, Radiance HDR, PFM or OpenEXR");
  CHECK(format_to_write("A.PNG", {rgb8_image}) == &image_formats[0]);
  for (const char* const name : {"a.png", "a", "png", ".png", "a.", "a.jpg", "a.tiff", ""}) {
    CAPTURE(name);
    CHECK(format_to_write(name, {float_rgb_image}) == nullptr);
  }
}

TEST_CASE("floats stand beside an image in its own format if that holds grey and colours, else as PFM") {
  CHECK(float_extension_beside("a.png") == ".pfm");
  CHECK(float_extension_beside("a.hdr") == ".pfm");
  CHECK(float_extension_beside("a.pfm") == ".pfm");
  CHECK(float_extension_beside("a.EXR") == ".exr");
  CHECK(float_extension_beside("a") == ".pfm");
}

TEST_CASE("docs/image-formats.md has the table of the formats") {
  CHECK(page_part("docs/image-formats.md", "io/image/image_formats.h") == markdown());
}

} // namespace refraster::test
