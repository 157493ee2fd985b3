#include "tests/unit/verify/pictures.h"
#include "verify/transformations/block_compression.h"

#include <doctest/doctest.h>

using namespace refraster;
using namespace refraster::test;

namespace {

Compressed found(const Picture& a, const Picture& b) {
  return find_block_compression(stored(a), stored(b));
}

/// It is found of either image, from strong compression to such that leaves few levels, and of nothing else.
void check_found(const std::string& name, const Picture& picture) {
  for (const double step : {3.0, 6.0, 12.0, 30.0}) {
    INFO(name << " " << step);
    CHECK(found(picture, compressed(picture, step)) == Compressed::b);
    CHECK(found(compressed(picture, step), picture) == Compressed::a);
  }
  std::vector<OtherChange> changes = other_changes();
  for (const Mistake& mistake : known_mistakes())
    changes.push_back({std::string(known(mistake.which).name), mistake.make});
  for (const OtherChange& change : changes)
    if (change.name != "compressed") {
      const BlockSpectrum spectrum = block_spectrum(stored(picture), stored(change.make(picture)));
      INFO(name << ": " << change.name << ": " << spectrum.on_grid << " on the grid, " << spectrum.beside << " beside");
      CHECK(found(picture, change.make(picture)) == Compressed::none);
      CHECK(found(change.make(picture), picture) == Compressed::none);
    }
}

} // namespace

TEST_CASE("differences that follow 8 x 8 blocks are found, whichever of the two was compressed") {
  check_found("drawn", drawn_picture());
}

TEST_CASE("a picture of squares of 8 pixels is not taken for a compressed one") {
  Picture squares(96, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 96; ++x)
      for (int c = 0; c < 3; ++c) squares.at(x, y)[c] = static_cast<float>((x / 8 * 37 + y / 8 * 91 + c * 20) % 256);
  CHECK(found(squares, mapped(squares, [](double v) { return v * 0.8 + 5; })) == Compressed::none);
  CHECK(found(squares, other_changes()[11].make(squares)) == Compressed::none); // blurred
  CHECK(found(other_changes()[11].make(squares), squares) == Compressed::none);
}

TEST_CASE("images without a whole block, and equal ones, are not compressed") {
  CHECK(found(Picture(7, 7, 3), Picture(7, 7, 3, 9)) == Compressed::none);
  CHECK(found(drawn_picture(), drawn_picture()) == Compressed::none);
}

TEST_SUITE("slow") {
  TEST_CASE("differences that follow 8 x 8 blocks are found in images of the gallery, and nothing else is") {
    const std::vector<NamedPicture> pictures = gallery_pictures();
    for (const NamedPicture& picture : pictures) check_found(picture.name, picture.picture);
    for (const NamedPicture& a : pictures)
      for (const NamedPicture& b : pictures) {
        INFO(a.name << " beside " << b.name);
        CHECK(found(a.picture, b.picture) == Compressed::none);
      }
  }
}
