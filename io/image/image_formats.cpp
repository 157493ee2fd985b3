#include "io/image/image_formats.h"

#include "io/file/input_file.h"
#include "io/file/text.h"

#include <algorithm>

namespace refraster {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view unknown_type = "an unknown image type";

/// Formats that users do have, and that are not read: a message names them.
struct Foreign {
  std::size_t at;
  std::string_view magic, name;
};
constexpr Foreign foreign[] = {
    {0, "GIF8"sv, "a GIF image"},          {8, "WEBP"sv, "a WebP image"},    {0, "II*\0"sv, "a TIFF image"},
    {0, "MM\0*"sv, "a TIFF image"},        {0, "DDS "sv, "a DDS image"},     {0, "\xabKTX "sv, "a KTX image"},
    {0, "8BPS"sv, "a Photoshop document"}, {0, "qoif"sv, "a QOI image"},     {4, "ftypavif"sv, "an AVIF image"},
    {4, "ftyphei"sv, "a HEIF image"},      {4, "JXL "sv, "a JPEG XL image"}, {4, "jP  "sv, "a JPEG 2000 image"},
    {0, "<svg"sv, "an SVG drawing"},
};

std::string_view foreign_name(std::string_view prefix) {
  const auto found = std::find_if(std::begin(foreign), std::end(foreign), [&](const Foreign& type) {
    return prefix.size() > type.at && prefix.substr(type.at).starts_with(type.magic);
  });
  if (found != std::end(foreign)) return found->name;
  const bool is_pnm = prefix.size() > 2 && prefix[0] == 'P' && prefix[1] >= '1' && prefix[1] <= '7' &&
                      (prefix[2] == '\n' || prefix[2] == ' ');
  return is_pnm ? "a PNM image"sv : unknown_type;
}

/// "a, b or c": what `text_of` gives for the formats that are wanted.
template <class Wanted, class TextOf>
std::string listed(Wanted&& wanted, TextOf&& text_of) {
  std::vector<std::string> texts;
  for (const ImageFormat& format : image_formats)
    if (wanted(format)) texts.push_back(text_of(format));
  return alternatives(texts);
}

bool can_write_one(const ImageFormat& format, std::initializer_list<ImageContent> contents) {
  return std::any_of(contents.begin(), contents.end(), [&](auto& content) { return can_write(format, content); });
}

std::string dotted_extension(const ImageFormat& format) {
  return "." + std::string(format.extensions[0]);
}

} // namespace

const ImageFormat* format_with_signature(std::string_view prefix) {
  for (const ImageFormat& format : image_formats)
    for (const std::string_view signature : format.signatures)
      if (!signature.empty() && prefix.starts_with(signature)) return &format;
  return nullptr;
}

const ImageFormat& format_of_content(const std::string& path, std::string_view prefix) {
  if (const ImageFormat* const format = format_with_signature(prefix)) return *format;
  const std::string_view name = foreign_name(prefix);
  if (name == unknown_type)
    for (const ImageFormat& format : image_formats)
      if (format.may_be && format.may_be(prefix)) return format;
  refuse_image(path, "", std::string(name), readable_formats());
}

const ImageFormat* format_of_name(const std::string& path) {
  const std::string ending = extension(path);
  for (const ImageFormat& format : image_formats)
    if (!ending.empty() &&
        std::find(format.extensions.begin(), format.extensions.end(), ending) != format.extensions.end())
      return &format;
  return nullptr;
}

const ImageFormat* format_to_write(const std::string& path, std::initializer_list<ImageContent> contents) {
  const ImageFormat* const format = format_of_name(path);
  return format && can_write_one(*format, contents) ? format : nullptr;
}

std::string writable_extensions(std::initializer_list<ImageContent> contents) {
  return listed([&](const ImageFormat& format) { return can_write_one(format, contents); }, dotted_extension);
}

std::string readable_formats() {
  return listed([](const ImageFormat&) { return true; },
                [](const ImageFormat& format) { return std::string(format.name); });
}

std::string float_extension_beside(const std::string& path) {
  const auto holds_floats = [](const ImageFormat& format) {
    return can_write(format, {ImageValues::floats, 1}) && can_write(format, {ImageValues::floats, 3});
  };
  if (const ImageFormat* const own = format_of_name(path); own && holds_floats(*own)) return dotted_extension(*own);
  return dotted_extension(*std::find_if(std::begin(image_formats), std::end(image_formats), holds_floats));
}

} // namespace refraster
