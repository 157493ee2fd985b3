// Alpha, channels and layers of two files.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/support/text.h"
#include "verify/images/image_pair.h"

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/png_bytes.h"
#include "verify/images/colour_channels.h"

#include <doctest/doctest.h>

#include <vector>

using namespace refraster;

namespace {

using Names = std::vector<std::string>;
using Values = std::vector<float>;

/// One row of pixels.
struct Folder : test::TemporaryFolder {
  void exr(const char* name, const Names& names, Values values) const {
    const int channels = static_cast<int>(names.size());
    Image<float> image(static_cast<int>(values.size() / names.size()), 1, channels);
    image.values = std::move(values);
    write_image(*this / name, image, names);
  }
  void png(const char* name, int channels, int bits, const std::vector<std::uint16_t>& values) const {
    const auto width = static_cast<std::uint32_t>(values.size()) / static_cast<std::uint32_t>(channels);
    test::write_files(path, {{name, test::png_bytes(width, 1, channels, bits, values)}});
  }
  ImagePair read(const char* a, const char* b, const PairRequest& request = {}) const {
    return read_image_pair(*this / a, *this / b, request);
  }
  std::string refusal(const char* a, const char* b, const PairRequest& request = {}) const {
    try {
      read(a, b, request);
      return "read";
    } catch (const InputError& error) {
      return error.what();
    }
  }
};

std::string notes_of(const ImagePair& pair, const Folder& folder) {
  std::string text;
  for (const Note& note : pair.notes.notes()) text += note.text().substr((folder / "").size()) + "\n";
  return text;
}

ColourChannels chosen(const Names& names, const std::string& layer = "") {
  ImageFile file;
  file.channels = names;
  return colour_channels("i.exr", file, layer);
}

} // namespace

TEST_CASE("an alpha of 1 everywhere is left out, with a note for each file that has one") {
  const Folder folder;
  folder.png("rgb.png", 3, 8, {1, 2, 3, 4, 5, 6});
  folder.png("rgba.png", 4, 8, {1, 2, 3, 255, 4, 5, 6, 255});
  folder.png("grey.png", 1, 8, {7, 8});
  folder.png("grey_alpha.png", 2, 8, {7, 255, 8, 255});
  folder.exr("rgba.exr", {"R", "G", "B", "A"},
             {1.0f / 255, 2.0f / 255, 3.0f / 255, 1, 4.0f / 255, 5.0f / 255, 6.0f / 255, 1});
  const ImagePair pair = folder.read("rgb.png", "rgba.png");
  CHECK(pair.a.values == pair.b.values);
  CHECK(pair.full_scale == 255);
  CHECK(pair.alpha.empty());
  CHECK(notes_of(pair, folder) == "rgba.png: alpha is 1 everywhere and is left out\n");
  CHECK(folder.read("grey.png", "grey_alpha.png").b.values == Values{7, 8});
  const ImagePair floats = folder.read("rgba.png", "rgba.exr");
  CHECK(floats.full_scale == 1);
  CHECK(floats.a.values == floats.b.values);
  CHECK(notes_of(floats, folder) ==
        "rgba.png: alpha is 1 everywhere and is left out\nrgba.exr: alpha is 1 everywhere and is left out\n");
  CHECK(notes_of(folder.read("rgba.png", "rgba.png"), folder) == "rgba.png: alpha is 1 everywhere and is left out\n");
}

TEST_CASE("another alpha is refused with the choices, in whichever file, and the first such pixel is named") {
  const Folder folder;
  folder.png("rgb.png", 3, 8, {1, 2, 3, 4, 5, 6});
  folder.png("seen_through.png", 4, 8, {1, 2, 3, 255, 4, 5, 6, 51});
  folder.exr("seen_through.exr", {"R", "G", "B", "A"}, {0, 0, 0, 0.5f, 0, 0, 0, 1});
  const std::string line = folder.refusal("rgb.png", "seen_through.png");
  CHECK(holds(line, "seen_through.png: found an alpha channel that is not 1 everywhere: 0.2 at (1, 0), expected "));
  for (const char* const choice : {"--alpha ignore", "--alpha compare", "--alpha over:R,G,B"})
    CHECK(holds(line, choice));
  CHECK(holds(folder.refusal("seen_through.png", "rgb.png"), "0.2 at (1, 0)"));
  CHECK(holds(folder.refusal("rgb.png", "seen_through.exr"), "0.5 at (0, 0)"));
  CHECK(holds(folder.refusal("seen_through.png", "seen_through.png"), "0.2 at (1, 0)"));
}

TEST_CASE(
    "--alpha ignore takes colours as stored, compare adds a channel, over blends straight and premultiplied colours") {
  const Folder folder;
  folder.png("rgb.png", 3, 8, {100, 100, 100});
  folder.png("straight.png", 4, 8, {100, 50, 0, 51}); // alpha 0.2
  folder.exr("premultiplied.exr", {"R", "G", "B", "A"}, {0.5f, 0.25f, 0, 0.5f});
  PairRequest request;
  request.alpha = AlphaUse::ignored;
  CHECK(folder.read("rgb.png", "straight.png", request).b.values == Values{100, 50, 0});
  request.alpha = AlphaUse::compared;
  const ImagePair compared = folder.read("rgb.png", "straight.png", request);
  CHECK(compared.a.values == Values{100, 100, 100, 255});
  CHECK(compared.b.values == Values{100, 50, 0, 51});
  // Beside an EXR file straight colours are multiplied by alpha, so that like is compared with like.
  const ImagePair mixed = folder.read("straight.png", "premultiplied.exr", request);
  CHECK(mixed.a.values == Values{20.0f / 255, 10.0f / 255, 0, 0.2f});
  CHECK(mixed.b.values == Values{0.5f, 0.25f, 0, 0.5f});
  CHECK(holds(notes_of(mixed, folder), "straight.png: colours are multiplied by alpha"));
  request.alpha = AlphaUse::composited;
  request.background = {1, 0, 0.5};
  const ImagePair over = folder.read("rgb.png", "straight.png", request);
  CHECK(over.a.values == Values{100, 100, 100});
  CHECK(over.b.values == Values{20 + 204, 10, 102}); // 0.2 c + 0.8 b
  CHECK(folder.read("premultiplied.exr", "rgb.png", request).a.values ==
        Values{0.5f + 0.5f, 0.25f, 0.25f}); // c + 0.5 b
  request.encoding = AlphaEncoding::premultiplied;
  CHECK(folder.read("rgb.png", "straight.png", request).b.values == Values{100 + 204, 50, 102});
  request.encoding = AlphaEncoding::straight;
  CHECK(folder.read("premultiplied.exr", "rgb.png", request).a.values == Values{0.25f + 0.5f, 0.125f, 0.25f});
}

TEST_CASE("alpha is kept for those who ask whether it explains a difference") {
  const Folder folder;
  folder.png("rgb.png", 3, 8, {100, 100, 100});
  folder.png("rgba.png", 4, 8, {100, 50, 0, 51});
  PairRequest request;
  request.alpha = AlphaUse::ignored;
  CHECK(folder.read("rgb.png", "rgba.png", request).alpha.values == Values{0.2f});
  CHECK(folder.read("rgba.png", "rgb.png", request).alpha.values == Values{0.2f});
}

TEST_CASE("of an EXR file colours are compared, and other channels noted") {
  const Folder folder;
  folder.exr("rgb.exr", {"R", "G", "B"}, {1, 2, 3});
  folder.exr("with_z.exr", {"R", "G", "B", "Z", "N.X"}, {1, 2, 3, 100, 4});
  folder.exr("layers.exr",
             {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Combined.A",
              "ViewLayer.Depth.Z"},
             {1, 2, 3, 1, 100});
  const ImagePair with_z = folder.read("rgb.exr", "with_z.exr");
  CHECK(with_z.b.values == Values{1, 2, 3});
  CHECK(notes_of(with_z, folder) == "with_z.exr: the channels N.X, Z are not compared\n");
  const ImagePair layers = folder.read("layers.exr", "rgb.exr");
  CHECK(layers.a.values == Values{1, 2, 3});
  CHECK(notes_of(layers, folder) ==
        "layers.exr: ViewLayer.Combined.R, ViewLayer.Combined.G, ViewLayer.Combined.B are compared, the channel "
        "ViewLayer.Depth.Z is not\nlayers.exr: alpha is 1 everywhere and is left out\n");
}

TEST_CASE(
    "the colour of a file: without a layer, of the only layer, of Blender's Combined, of the one that is asked for") {
  const Names passes = {"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Diffuse.R", "V.Diffuse.G", "V.Diffuse.B"};
  using Places = std::vector<std::size_t>;
  CHECK(chosen({"R", "G", "B", "A", "Z"}).compared == Places{0, 1, 2});
  CHECK(chosen({"R", "G", "B", "A", "Z"}).alpha == 3);
  CHECK(chosen({"R", "G", "B", "A", "Z"}).others == Places{4});
  CHECK(chosen({"B", "G", "R"}).compared == Places{2, 1, 0});
  CHECK(chosen({"blue", "green", "red", "alpha"}).compared == Places{2, 1, 0});
  CHECK(chosen({"a.B", "a.G", "a.R", "B", "G", "R"}).compared == Places{5, 4, 3});
  CHECK(chosen({"beauty.r", "beauty.g", "beauty.b", "depth.Z"}).compared == Places{0, 1, 2});
  CHECK(chosen(passes).layer == "V.Combined");
  CHECK(chosen(passes, "V.Diffuse").compared == Places{3, 4, 5});
  CHECK(chosen(passes, "none").layer == "V.Combined");
  CHECK(chosen({"R", "G", "B"}, "V.Diffuse").compared == Places{0, 1, 2});
  CHECK_THROWS_AS(chosen({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}), InputError);
  CHECK(chosen({"Y"}).kind == ColourChannels::Kind::grey);
  CHECK(chosen({"Y", "A", "Z"}).compared == Places{0});
  CHECK(chosen({"Y", "A", "Z"}).alpha == 1);
  CHECK(chosen({"X", "Y", "Z"}).kind == ColourChannels::Kind::data); // a vector
  CHECK(chosen({"X", "Y", "Z"}).compared == Places{0, 1, 2});
  CHECK(chosen({"N.X", "N.Y", "N.Z"}).compared == Places{0, 1, 2});
  CHECK(chosen({"Z"}).kind == ColourChannels::Kind::data);
  CHECK(chosen({"R", "G"}).kind == ColourChannels::Kind::data);
}

TEST_CASE("layers that leave open which is meant are refused with their names, and a layer that neither file has") {
  const Folder folder;
  folder.exr("two.exr", {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}, {1, 2, 3, 4, 5, 6});
  folder.exr("rgb.exr", {"R", "G", "B"}, {4, 5, 6});
  CHECK(holds(folder.refusal("rgb.exr", "two.exr"),
              "two.exr: found colours in the layers a, b, expected one of them by --layer NAME"));
  PairRequest request;
  request.layer = "b";
  CHECK(folder.read("rgb.exr", "two.exr", request).b.values == Values{4, 5, 6});
  request.layer = "c";
  CHECK(holds(folder.refusal("rgb.exr", "rgb.exr", request), "found no layer \"c\" with R, G and B"));
}

TEST_CASE("8 bits beside 16 bits count exactly, beside floats to the nearest float") {
  const Folder folder;
  folder.png("8.png", 3, 8, {0, 100, 255});
  folder.png("16.png", 3, 16, {0, 25700, 65535});
  const ImagePair pair = folder.read("8.png", "16.png");
  CHECK(pair.full_scale == 65535);
  CHECK(pair.a.values == pair.b.values);
  CHECK(pair.precision_a.step == 1);
  CHECK(pair.precision_b.step == 255.0 / 65535);
}

TEST_CASE("images of half and double size are reported by the line that refuses them") {
  const Folder folder;
  Image<std::uint8_t> large(8, 4, 3), small(4, 2, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) {
      const auto level = static_cast<std::uint8_t>(x / 2 * 50 + y / 2 * 30);
      large.at(x, y)[1] = level, small.at(x / 2, y / 2)[1] = level;
    }
  write_image(folder / "large.png", large);
  write_image(folder / "small.png", small);
  CHECK(holds(folder.refusal("large.png", "small.png"), "found 4 x 2 pixels of 3 channels, expected 8 x 4 pixels of 3 "
                                                        "channels as "));
  CHECK(holds(folder.refusal("large.png", "small.png"), "; b is a at half size: then equal"));
  CHECK(holds(folder.refusal("small.png", "large.png"), "; b is a at double size: then equal"));
}
