#include <refraster/files.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>

#include "tests/long/fuzz/dirty_memory.h"
#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/render_small.h"
#include "tests/long/fuzz/targets.h"

#include "tests/support/invariants.h"

#include <cmath>
#include <cstring>
#include <optional>

namespace refraster::fuzz {
namespace {

std::optional<ImageFile> accepted(const std::string& path) {
  try {
    return read_image(path);
  } catch (const InputError& error) {
    require(error.faults().size() == 1, "a refusal has one fault");
    return {};
  }
}

bool same_bits(const ImageFile& a, const ImageFile& b) {
  return a.values.values.size() == b.values.values.size() &&
         std::memcmp(a.values.values.data(), b.values.values.data(), a.values.values.size() * sizeof(float)) == 0;
}

void require_sound(const ImageFile& image) {
  const auto count = [](int n) { return static_cast<std::size_t>(n); };
  const Image<float>& values = image.values;
  require(values.width >= 1 && values.height >= 1 && values.channels >= 1, "an accepted image has pixels");
  require(values.values.size() == count(values.width) * count(values.height) * count(values.channels) &&
              image.channels.size() == count(values.channels),
          "an accepted image has a value for every channel of every pixel");
  require(image.bits == 8 || image.bits == 16 || image.bits == 32, "bits");
  require(image.full_scale == (image.bits == 32 ? 1 : std::exp2(image.bits) - 1), "the full scale follows the bits");
}

/// Reads the bytes twice, from memory that is dirty in two ways, and requires the same. The first time within bounds.
std::optional<ImageFile> read_twice(const std::string& path, std::size_t size, std::int64_t fixed,
                                    std::int64_t per_byte) {
  dirty_memory(0x55);
  const PeakMemory peak;
  std::optional<ImageFile> image = accepted(path);
  require_memory(peak, size, fixed, per_byte);
  dirty_memory(0xaa);
  const std::optional<ImageFile> again = accepted(path);
  require(image.has_value() == again.has_value(), "a file is accepted always or never");
  if (!image) return {};
  require(same_bits(*image, *again), "a file has one meaning: nothing uninitialised is taken for pixels");
  require_sound(*image);
  return image;
}

} // namespace

void read_image_bytes(Bytes bytes) {
  const std::string path = file_of("i.png", bytes);
  const std::optional<ImageFile> image = read_twice(path, bytes.size(), 1 << 17, 1 << 18);
  if (!image || image->bits > 16) return;
  for (const float value : image->values.values)
    require(value >= 0 && static_cast<double>(value) <= image->full_scale && value == std::floor(value),
            "values are whole numbers");
  if (image->values.values.size() > 1 << 16) return; // a mip chain takes long
  auto texture = std::make_shared<Texture>(read_texture(path));
  build_mip_levels(*texture);
  require_none(test::fault_of(*texture), "an accepted texture");
  constexpr TextureFilter filters[] = {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear};
  render_small(showing(std::make_shared<const Mesh>(plane_mesh(1)), texture, filters[bytes.size() % 3]), bytes.size());
}

void read_float_image_bytes(Bytes bytes) {
  const std::string path = file_of("i.hdr", bytes);
  // OpenEXR may take 64 MiB for rows or tiles that are packed together.
  const std::optional<ImageFile> image = read_twice(path, bytes.size(), 1 << 26, 1 << 18);
  if (!image || image->bits != 32 || image->values.values.size() > 1 << 16) return;
  if (image->values.channels != 1 && image->values.channels != 3) return;
  const std::string copy = file_of("copy.pfm", {});
  write_image(copy, image->values);
  require(same_bits(*image, read_image(copy)), "what write_image wrote is read back");
}

} // namespace refraster::fuzz
