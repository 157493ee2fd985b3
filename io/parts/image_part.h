#pragma once
// A file with some rows of an image and of its AOVs: what `refraster render --shard` writes. docs/scale.md has the
// format.

#include <refraster/files.h>
#include <refraster/frame.h>

#include "io/file/input_file.h"
#include "io/image/image_formats.h"
#include "io/parts/settings.h"
#include "io/parts/shard.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace refraster {

/// An image of a part: as a file of the whole is to be made of it.
struct PartImage {
  std::string name; // "image", or that of an AOV
  ImageValues values = ImageValues::uint8;
  int channels = 0;
  std::string sha256 = {}; // of its values in the file

  bool is_alike(const PartImage& other) const {
    return name == other.name && values == other.values && channels == other.channels;
  }
};

/// What stands before the values.
struct PartHeader {
  std::string scene; // as named by the user
  Shard shard;
  int width = 0, height = 0; // of the whole: of the image, or of the crop that was asked for
  Settings settings;
  std::vector<PartImage> images;

  RowRange rows() const { return rows_of(shard, height); }
};

using AnyRows = std::variant<ImageRows<std::uint8_t>, ImageRows<std::uint16_t>, ImageRows<float>>;

/// What the values of these rows are.
ImageValues values_of(const AnyRows& rows);

/// Writes a part whole or not at all: as many images as the header names, which are of its rows alone; none where it
/// has none. Fills in their digests. Throws OutputError.
void write_image_part(const std::string& path, PartHeader header, const std::vector<AnyRows>& images);

/// Whether a file begins as a part does. False where there is none.
bool is_image_part(const std::string& path);

/// A part that is there.
class ImagePart {
public:
  /// Reads its header. Throws InputError unless the file is a part that is whole by its size.
  explicit ImagePart(const std::string& path);

  const std::string& path() const { return path_; }
  const PartHeader& header() const { return header_; }

  /// Throws InputError unless all values are what their digests say.
  void check_values() const;

  /// Row y of the whole, which is one of the part, of an image by its number; `to` has room for it. Of an open file,
  /// which open() gives: a thousand parts need not all be open at a time.
  std::shared_ptr<const InputFile> open() const;
  void read_row(const InputFile& file, std::size_t image, int y, void* to) const;

private:
  std::uint64_t row_bytes(std::size_t image) const;
  std::uint64_t image_bytes(std::size_t image) const;
  std::uint64_t begin(std::size_t image) const;

  std::string path_;
  PartHeader header_;
  std::uint64_t header_bytes_ = 0;
};

} // namespace refraster
