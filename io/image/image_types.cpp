#include "io/image/image_formats.h"

#include <algorithm>

// What an image file is, seen from how it begins.

namespace refraster {
namespace {

using namespace std::string_view_literals;

struct Known {
  std::string_view magic;
  ImageReader read;
};
constexpr Known known[] = {
    {"\x89PNG\r\n\x1a\n"sv, read_png}, {"\xff\xd8"sv, read_jpeg}, {"BM"sv, read_bmp}, {"\x76\x2f\x31\x01"sv, read_exr},
    {"#?RADIANCE\n"sv, read_hdr},      {"#?RGBE\n"sv, read_hdr},  {"PF"sv, read_pfm}, {"Pf"sv, read_pfm},
};

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
  return is_pnm ? "a PNM image"sv : "an unknown image type"sv;
}

} // namespace

ImageReader image_reader(const std::string& path, std::string_view prefix) {
  for (const Known& type : known)
    if (prefix.starts_with(type.magic)) return type.read;
  const std::string_view name = foreign_name(prefix);
  if (name == "an unknown image type" && may_be_tga(prefix)) return read_tga;
  refuse_image(path, "", std::string(name), "PNG, JPEG, BMP, TGA, Radiance HDR, PFM or OpenEXR");
}

} // namespace refraster
