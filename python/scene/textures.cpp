// refraster.Texture, refraster.TextureMap

#include "io/file/limits.h"
#include "python/arrays.h"
#include "python/scene/materials.h"
#include "python/work.h"

#include <algorithm>

namespace refraster::python {
namespace {

/// Level 0 of an array: rows turned, since row 0 of a texture is at v = 0, and grey as three channels.
std::shared_ptr<Texture> texture_of(const py::object& array) {
  const ArrayImage image = image_argument("image", array, {1, 3});
  const Image<float>& pixels = image.values;
  const auto texture = std::make_shared<Texture>();
  texture->full_scale = image.full_scale;
  TextureLevel& level = texture->levels.emplace_back();
  level.width = pixels.width, level.height = pixels.height;
  if (std::max(level.width, level.height) > static_cast<int>(limit::texture_side.value))
    refuse_argument("image", array, at_most(limit::texture_side));
  level.rgb.reserve(3 * pixels.values.size() / static_cast<std::size_t>(pixels.channels));
  for (int y = pixels.height; y-- > 0;)
    for (int x = 0; x < pixels.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const float value = pixels.at(x, y)[pixels.channels == 1 ? 0 : c];
        if (!(value >= 0 && value <= static_cast<float>(image.full_scale)))
          throw ArgumentError("image", "the value " + std::to_string(value) + " in row " + std::to_string(y),
                              "values from 0 to 1");
        level.rgb.push_back(value);
      }
  return texture;
}

std::shared_ptr<LiveTexture> make_texture(const py::object& image, const py::object& color_space,
                                          const py::object& channel) {
  TextureReading reading;
  read_argument("color_space", color_space, Range{}, reading.colour_space);
  if (!channel.is_none()) read_argument("channel", channel, Range{}, reading.channel.emplace());
  std::shared_ptr<const Texture> texture;
  if (py::isinstance<py::array>(image)) {
    if (!channel.is_none()) refuse_argument("channel", channel, "None beside an array");
    const auto made = texture_of(image);
    if (reading.colour_space == ColourSpace::srgb) decode_srgb(*made);
    texture = made;
  } else {
    const std::string path = path_argument("image", image);
    run_watched(py::none(), [&](Watch&) { texture = material_texture(path, reading, MipLevels::none, {}, nullptr); });
  }
  return std::make_shared<LiveTexture>(LiveTexture{texture});
}

/// Top row first, as images are: strides go backward.
py::array values_of(const py::object& self) {
  const Texture& texture = *py::cast<const LiveTexture&>(self).texture;
  const TextureLevel& level = texture.levels.front();
  constexpr auto pixel = static_cast<py::ssize_t>(3 * sizeof(float));
  const py::ssize_t row = level.width * pixel;
  const float* const top =
      level.rgb.data() + 3 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height - 1);
  py::array view(py::dtype::of<float>(), {py::ssize_t{level.height}, py::ssize_t{level.width}, py::ssize_t{3}},
                 {-row, pixel, static_cast<py::ssize_t>(sizeof(float))}, top, self);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

} // namespace

std::shared_ptr<const Texture> LiveTexture::for_filter(TextureFilter filter) {
  if (filter != TextureFilter::trilinear || texture->levels.size() > 1) return texture;
  if (!with_levels) {
    const auto copy = std::make_shared<Texture>(*texture);
    build_mip_levels(*copy);
    with_levels = copy;
  }
  return with_levels;
}

std::shared_ptr<LiveTextureMap> map_argument(const std::string& place, py::handle given) {
  if (given.is_none()) return nullptr;
  if (py::isinstance<LiveTextureMap>(given)) return py::cast<std::shared_ptr<LiveTextureMap>>(given);
  if (!py::isinstance<LiveTexture>(given)) refuse_argument(place, given, "a TextureMap, a Texture or None");
  const auto map = std::make_shared<LiveTextureMap>();
  map->texture = py::cast<std::shared_ptr<LiveTexture>>(given);
  return map;
}

void bind_textures(py::module_& module) {
  py::class_<LiveTexture, std::shared_ptr<LiveTexture>> texture(
      module, "Texture",
      "An image that materials show. Made of a file's path, or of an array, top row first: (height, width, 3) or "
      "(height, "
      "width), uint8, uint16, or floats from 0 to 1. An array is always copied: rows are turned and values become "
      "float32.\n\ncolor_space: \"linear\" or \"srgb\", which is decoded. channel: of a file, the one that a texture "
      "of "
      "single numbers has, as \"red\" or \"auto\".");
  texture.def(py::init(&make_texture), py::arg("image"), py::arg("color_space") = "linear",
              py::arg("channel") = py::none());
  texture.def_property_readonly("values", &values_of,
                                "float32, shape (height, width, 3), top row first, from 0 to full_scale: the texture's "
                                "own memory, not to be written to.");
  texture.def_property_readonly(
      "full_scale", [](const LiveTexture& self) { return self.texture->full_scale; },
      "The value that means 1: 255, 65535, or 1.");

  py::class_<LiveTextureMap, std::shared_ptr<LiveTextureMap>> map(module, "TextureMap",
                                                                  "A texture as a material has it.");
  map.def(py::init([](const py::object& of, const py::kwargs& given) {
            auto self = std::make_shared<LiveTextureMap>();
            if (!py::isinstance<LiveTexture>(of)) refuse_argument("TextureMap.texture", of, "a Texture");
            self->texture = py::cast<std::shared_ptr<LiveTexture>>(of);
            set_attributes(py::cast(self), "TextureMap", given);
            return self;
          }),
          py::arg("texture"));
  map.def_readonly("texture", &LiveTextureMap::texture, "The Texture.");
  def_fields(map, "TextureMap");
  def_repr(map, "TextureMap");
}

} // namespace refraster::python
