#include "io/parts/image_part.h"

#include "io/file/atomic_file.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/json/report_parts.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <filesystem>
#include <limits>

// "refraster-part N\n", a header of N bytes, which is JSON, and the values of its images, one image after the other,
// each row by row from the top, channels interleaved, little-endian.

namespace refraster {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view magic = "refraster-part ";
constexpr std::string_view expected_file = "a part of an image, which `refraster render --shard` has written";
constexpr std::size_t longest_first_line = 64; // bytes: far more than a number has

std::size_t value_bytes(ImageValues values) {
  return values == ImageValues::uint8 ? 1 : values == ImageValues::uint16 ? 2 : 4;
}

[[noreturn]] void refuse_part(const std::string& path, std::string place, std::string found, std::string expected) {
  throw InputError(InputFault{path, 0, 0, std::move(place), std::move(found), std::move(expected)});
}

std::string header_text(const PartHeader& header) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("scene", header.scene);
    json.member("shard", shard_text(header.shard));
    write_size(json, header.width, header.height);
    json.member("rows", std::vector<int>{header.rows().first, header.rows().count});
    write_settings(json, "settings", header.settings);
    json.array("images", [&] {
      for (const PartImage& image : header.images)
        json.object([&] {
          json.member("name", image.name);
          json.member("values", depth_of(image.values).name);
          json.member("channels", image.channels);
          json.member("sha256", image.sha256);
        });
    });
  });
  return json.text();
}

/// A whole number of a range; nothing where it is none.
std::optional<int> whole_number(const JsonNode& node, int least, int most) {
  if (node.kind != JsonKind::number || !(node.number >= least && node.number <= most)) return std::nullopt;
  const int number = static_cast<int>(node.number);
  if (number != node.number) return std::nullopt;
  return number;
}

/// Takes the members out of a header. Whatever is wrong with one is the file's fault as a whole: no one writes it by
/// hand.
class HeaderReader {
public:
  HeaderReader(const std::string& path, const std::string& text) : path_(path), document_(path, text) {}

  PartHeader header() {
    PartHeader header;
    header.scene = need(0, "scene", JsonKind::string).string;
    const std::optional<Shard> shard = shard_from(need(0, "shard", JsonKind::string).string);
    if (!shard) fail("shard");
    header.shard = *shard;
    const JsonNode& size = need(0, "size", JsonKind::array);
    if (size.children != 2) fail("size");
    header.width = number(document_[size.first_child], limit::frame_side.value, "size");
    header.height = number(document_[document_[size.first_child].next], limit::frame_side.value, "size");
    const std::optional<Settings> settings = settings_from(document_, member_of(document_, 0, "settings"));
    if (!settings || settings->empty()) fail("settings");
    header.settings = *settings;
    const JsonNode& images = need(0, "images", JsonKind::array);
    if (images.children == 0 || images.children > 1 + std::size(aov_kinds)) fail("images");
    for (JsonIndex i = images.first_child; i; i = document_[i].next) header.images.push_back(image(i));
    return header;
  }

private:
  [[noreturn]] void fail(const std::string& member) {
    refuse_part(path_, member, "what no part has there", std::string(expected_file));
  }
  const JsonNode& need(JsonIndex object, std::string_view name, JsonKind kind) {
    const JsonIndex found = member_of(document_, object, name);
    if (!found || document_[found].kind != kind) fail(std::string(name));
    return document_[found];
  }
  int number(const JsonNode& node, std::uint64_t most, const char* member) {
    const std::optional<int> number = whole_number(node, 1, static_cast<int>(most));
    if (!number) fail(member);
    return *number;
  }
  PartImage image(JsonIndex i) {
    if (document_[i].kind != JsonKind::object) fail("images");
    PartImage image;
    image.name = need(i, "name", JsonKind::string).string;
    const std::string_view values = need(i, "values", JsonKind::string).string;
    const auto depth = std::find_if(std::begin(image_depths), std::end(image_depths),
                                    [&](const ImageDepth& one) { return one.name == values; });
    if (depth == std::end(image_depths) || depth->values == ImageValues::uint32) fail("values");
    image.values = depth->values;
    image.channels = number(need(i, "channels", JsonKind::number), limit::image_channels.value, "channels");
    image.sha256 = need(i, "sha256", JsonKind::string).string;
    return image;
  }

  const std::string& path_;
  JsonDocument document_;
};

} // namespace

ImageValues values_of(const AnyRows& rows) {
  constexpr ImageValues of_index[] = {ImageValues::uint8, ImageValues::uint16, ImageValues::floats};
  return of_index[rows.index()];
}

void write_image_part(const std::string& path, PartHeader header, const std::vector<AnyRows>& images) {
  const int rows = header.rows().count;
  const auto for_rows = [&](const AnyRows& any, const auto& take) {
    std::visit(
        [&]<class Value>(const ImageRows<Value>& image) {
          std::vector<Value> scratch;
          for (int y = 0; y < rows; ++y) take(image.row(y, scratch), image.row_values() * sizeof(Value));
        },
        any);
  };
  for (std::size_t i = 0; i < header.images.size(); ++i) {
    Sha256 sha256;
    if (rows > 0) for_rows(images[i], [&](const void* bytes, std::size_t size) { sha256.add(bytes, size); });
    header.images[i].sha256 = in_hexadecimal(sha256.result());
  }
  const std::string text = header_text(header);
  AtomicFile file(path);
  file.write(std::string(magic) + std::to_string(text.size()) + "\n" + text);
  if (rows > 0)
    for (const AnyRows& image : images)
      for_rows(image, [&](const void* bytes, std::size_t size) { file.write(bytes, size); });
  file.commit();
}

bool is_image_part(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && read_prefix(path, magic.size()) == magic;
}

ImagePart::ImagePart(const std::string& path) : path_(path) {
  const InputFile file(path, expected_file, std::numeric_limits<std::uint64_t>::max());
  std::string line(std::min<std::uint64_t>(longest_first_line, file.size_bytes()), '\0');
  file.read(0, line.data(), line.size());
  std::uint64_t size = 0;
  const char* const number = line.data() + std::min(magic.size(), line.size());
  const auto [end, error] = std::from_chars(number, line.data() + line.size(), size);
  if (!line.starts_with(magic) || error != std::errc() || end == line.data() + line.size() || *end != '\n')
    refuse_part(path, "", "another file", std::string(expected_file));
  header_bytes_ = static_cast<std::uint64_t>(end + 1 - line.data());
  if (size > JsonDocument::max_bytes || size > file.size_bytes() - header_bytes_)
    refuse_part(path, "", "a header of " + std::to_string(size) + " bytes", "one that the file holds");
  std::string text(size, '\0');
  file.read(header_bytes_, text.data(), size);
  header_bytes_ += size;
  header_ = HeaderReader(path, text).header();
  const std::uint64_t expected = begin(header_.images.size());
  if (file.size_bytes() != expected)
    refuse_part(path, "", std::to_string(file.size_bytes()) + " bytes", std::to_string(expected) + " bytes");
}

void ImagePart::check_values() const {
  const std::shared_ptr<const InputFile> file = open();
  for (std::size_t i = 0; i < header_.images.size(); ++i) {
    Sha256 sha256;
    std::vector<char> row(row_bytes(i));
    const RowRange rows = header_.rows();
    for (int y = rows.first; y < rows.first + rows.count; ++y) {
      read_row(*file, i, y, row.data());
      sha256.add(row.data(), row.size());
    }
    if (in_hexadecimal(sha256.result()) != header_.images[i].sha256)
      refuse_part(path_, header_.images[i].name, "other values than were written", "those of its sha256");
  }
}

std::shared_ptr<const InputFile> ImagePart::open() const {
  auto file = std::make_shared<const InputFile>(path_, expected_file, std::numeric_limits<std::uint64_t>::max());
  if (file->size_bytes() != begin(header_.images.size()))
    refuse_part(path_, "", "another file than before", "one that stays as it is while it is read");
  return file;
}

void ImagePart::read_row(const InputFile& file, std::size_t image, int y, void* to) const {
  const auto row = static_cast<std::uint64_t>(y - header_.rows().first);
  file.read(begin(image) + row * row_bytes(image), to, row_bytes(image));
}

std::uint64_t ImagePart::row_bytes(std::size_t image) const {
  const PartImage& stored = header_.images[image];
  return static_cast<std::uint64_t>(header_.width) * static_cast<std::uint64_t>(stored.channels) *
         value_bytes(stored.values);
}

std::uint64_t ImagePart::image_bytes(std::size_t image) const {
  return row_bytes(image) * static_cast<std::uint64_t>(header_.rows().count);
}

std::uint64_t ImagePart::begin(std::size_t image) const {
  std::uint64_t begin = header_bytes_;
  for (std::size_t i = 0; i < image; ++i) begin += image_bytes(i);
  return begin;
}

} // namespace refraster
