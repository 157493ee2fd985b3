// The list of image formats, and what each format on it must have elsewhere.

#include <refraster/frame.h>
#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"
#include "tests/support/files/image_clauses.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/page_part.h"

#include <doctest/doctest.h>

#include <cmath>
#include <concepts>
#include <set>
#include <utility>

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

std::string_view stored_values(StoredValues values) {
  switch (values) {
  case StoredValues::integers:
    return "whole numbers";
  case StoredValues::floats:
    return "floats";
  case StoredValues::either:
    return "whole numbers or floats";
  }
  return "";
}

std::vector<std::string> written_values(const ImageFormat& format) {
  std::vector<std::string> texts;
  for (const ImageDepth& depth : image_depths)
    if (depth.is_written(format)) texts.emplace_back(depth.name);
  return texts;
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
            std::string(stored_values(format.values)) + " | " +
            (counts.empty() ? "not written"
                            : alternatives(counts) + " channels of " + alternatives(written_values(format))) +
            " |\n";
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
    CHECK(written_values(format).empty() != is_written);
    for (const ImageDepth& depth : image_depths) {
      const bool is_float = depth.values == ImageValues::floats;
      if (format.values != StoredValues::either && is_float != (format.values == StoredValues::floats))
        CHECK_FALSE_MESSAGE(depth.is_written(format), depth.name);
    }
  }
}

TEST_CASE("each format has clauses of its specification, files that are read and files that are refused") {
  std::set<const ImageFormat*> read, refused;
  for (const ImageClause& clause : all_image_clauses()) {
    const ImageFormat* const format = format_of(clause.bytes);
    if (!format) continue;
    (clause.channels > 0 ? read : refused).insert(format);
    if (clause.channels > 0 && format->values != StoredValues::either)
      CHECK((clause.bits == 32) == (format->values == StoredValues::floats));
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

namespace {

/// Writes an image of 3 x 2 pixels whose values are 128, 131, ..., which 8 bits of mantissa hold, and reads it back.
template <class Value>
void check_round_trip(const ImageFormat& format, ImageValues values, int channels, const TemporaryFolder& folder) {
  const std::string path = folder / "i" + extension_of(format);
  Image<Value> image(3, 2, channels);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<Value>(128 + 3 * i);
  const bool is_exr = format.name == "OpenEXR", is_npy = format.name == "NumPy", is_lossy = format.name == "JPEG";
  std::vector<std::string> names = default_channels(channels);
  if ((is_exr || is_npy) && channels == 2) names = {"U", "V"};
  if (is_exr && channels == 5) names[4] = "Z";
  const auto write = [&] {
    if constexpr (std::same_as<Value, float>) write_image(path, image, names);
    else write_image(path, image);
  };
  const ImageContent content{values, channels};
  CHECK(can_write(format, content) == (format_to_write(path, {content}) == &format));
  if (!can_write(format, content)) {
    CHECK_THROWS_AS(write(), InputError);
    return;
  }
  write();
  CHECK(format_of(read_file(path, "an image", 1 << 20)) == &format);
  const ImageFile read = read_image(path);
  CHECK(read.channels == names);
  CHECK(read.bits == 8 * static_cast<int>(sizeof(Value)));
  CHECK(read.full_scale == (sizeof(Value) == 1 ? 255 : sizeof(Value) == 2 ? 65535 : 1));
  REQUIRE(read.values.values.size() == image.values.size());
  for (std::size_t i = 0; i < image.values.size(); ++i)
    CHECK(std::abs(read.values.values[i] - static_cast<float>(image.values[i])) <= (is_lossy ? 8.0f : 0.0f));
}

} // namespace

TEST_CASE("what a format writes it reads back, of each type and number of channels that it says it writes; no other") {
  const TemporaryFolder folder;
  for (const ImageFormat& format : image_formats)
    for (int channels = 1; channels <= 5; ++channels) {
      CAPTURE(format.name);
      CAPTURE(channels);
      check_round_trip<std::uint8_t>(format, ImageValues::uint8, channels, folder);
      check_round_trip<std::uint16_t>(format, ImageValues::uint16, channels, folder);
      check_round_trip<std::uint32_t>(format, ImageValues::uint32, channels, folder);
      check_round_trip<float>(format, ImageValues::floats, channels, folder);
    }
}

TEST_CASE("messages list what can be written and read, and a name's extension says the format in any case") {
  CHECK(writable_extensions({rgb8_image}) == ".png, .jpg or .npy");
  CHECK(writable_extensions({float_rgb_image}) == ".hdr, .pfm, .exr or .npy");
  CHECK(writable_extensions({rgb8_image, float_rgb_image}) == ".png, .jpg, .hdr, .pfm, .exr or .npy");
  CHECK(writable_extensions({{ImageValues::uint16, 4}}) == ".png or .npy");
  CHECK(writable_extensions({float_grey_image}) == ".pfm, .exr or .npy");
  CHECK(readable_formats() == "PNG, JPEG, BMP, TGA, Radiance HDR, PFM, OpenEXR or NumPy");
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
  CHECK(float_extension_beside("a.npy") == ".npy");
  CHECK(float_extension_beside("a") == ".pfm");
}

TEST_CASE("docs/image-formats.md has the table of the formats") {
  CHECK(page_part("docs/image-formats.md", "io/image/image_formats.h") == markdown());
}

TEST_CASE("docs/conventions.md has the table of AOVs") {
  std::string text = "| AOV | channels | resolved | layer | what it is |\n|---|---|---|---|---|\n";
  for (const AovKind& kind : aov_kinds) {
    std::string layers;
    for (const std::string_view name : kind.exr_names)
      if (!name.empty()) layers += (layers.empty() ? "`" : ", `") + std::string(name) + "`";
    text += "| `" + std::string(kind.name) + "` | " + std::to_string(kind.channels) +
            (kind.values == AovValues::numbers ? ", numbers" : "") + " | " +
            (kind.mean == AovMean::covered ? "mean" : "no") + " | " + layers + " | " + std::string(kind.meaning) +
            " |\n";
  }
  CHECK(page_part("docs/conventions.md", "include/refraster/frame.h") == text);
}

} // namespace refraster::test
