// Known transformations are named, and nothing else is.

#include "tests/unit/verify/pictures.h"
#include "verify/transformations/scale_factor.h"
#include "verify/transformations/undoing.h"
#include "verify/transformations/whole_pixel_shift.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

using namespace refraster;
using namespace refraster::test;

namespace {

std::optional<FoundTransformation> found(const Picture& a, const Picture& b, double limit = 0,
                                         const Picture& alpha = {}) {
  return find_transformation(stored(a), stored(b), alpha, limit);
}

std::string text_of(const std::optional<FoundTransformation>& found) {
  return found ? transformation_text(*found, CompareUnit::levels) : "none";
}

/// Each mistake is named, with what belongs to it, whether limits are given or not.
void check_named(const std::string& name, const Picture& picture) {
  for (const Mistake& mistake : known_mistakes())
    for (const double limit : {0.0, 2.0}) {
      const auto result = found(picture, mistake.make(picture), limit);
      INFO(name << ": " << known(mistake.which).name << " " << mistake.factor << " " << mistake.x << " " << mistake.y
                << ": " << text_of(result));
      REQUIRE(result);
      CHECK(result->which == mistake.which);
      CHECK(result->x == mistake.x);
      CHECK(result->y == mistake.y);
      // A level at white: that much of it remains.
      CHECK(std::abs(result->factor - mistake.factor) <= std::max(mistake.factor, 1.0) / 255);
      CHECK(result->equal_within <= limit + 2);
    }
}

void check_not_named(const std::string& name, const Picture& picture) {
  for (const OtherChange& change : other_changes())
    for (const double limit : {0.0, 2.0}) {
      INFO(name << ": " << change.name);
      CHECK(text_of(found(picture, change.make(picture), limit)) == "none");
      CHECK(text_of(found(change.make(picture), picture, limit)) == "none");
    }
}

} // namespace

TEST_CASE("each known transformation of a picture is named") {
  check_named("drawn", drawn_picture());
}

TEST_CASE("what is no known transformation has no name") {
  check_not_named("drawn", drawn_picture());
}

TEST_CASE("an image beside itself, and beside one that differs in some pixels, has no name") {
  const Picture picture = drawn_picture();
  CHECK(text_of(found(picture, picture)) == "none");
  CHECK(text_of(found(picture, with_wrong_pixels(picture, 3))) == "none");
  CHECK(text_of(found(picture, with_wrong_pixels(picture, 600))) == "none");
  CHECK(text_of(found(with_wrong_pixels(picture, 600), picture, 2)) == "none");
}

TEST_CASE("99.9 % of the pixels must be equal once it is undone") {
  const Picture picture = drawn_picture(); // 6144 pixels
  const Mistake down = known_mistakes()[2];
  REQUIRE(down.which == Transformation::upside_down);
  const auto six = found(picture, with_wrong_pixels(down.make(picture), 6));
  REQUIRE(six);
  CHECK(six->which == Transformation::upside_down);
  CHECK(six->pixels == 6144);
  CHECK(six->within == 6138);
  CHECK(six->equal_within == 0);
  CHECK(six->max == 100);
  CHECK(six->rms == std::sqrt(6 * 100.0 * 100 / (3 * 6144)));
  CHECK(text_of(six) == "b is a turned upside down: then equal but for 6 pixels of 6144");
  CHECK_FALSE(found(picture, with_wrong_pixels(down.make(picture), 7)));
}

TEST_CASE("the sRGB curve may leave 2 levels of 8 bits beside 8 bits, and each transformation what is derived for it") {
  const StoredPrecision eight = StoredPrecision::integers(255), sixteen = StoredPrecision::integers(65535);
  const auto levels = [&](Transformation which, const StoredPrecision& undone, const StoredPrecision& other,
                          double limit = 0) {
    // A quarter of a step more, so that a whole number of steps passes.
    return undoing_tolerance(known(which), undone, other, limit, 255, 255) - other.step / 4;
  };
  CHECK(levels(Transformation::srgb_curve_added, eight, eight) == 2); // 1.14 + 0.5, and rounded again
  CHECK(levels(Transformation::srgb_curve_added, eight, eight, 2) == 4);
  CHECK(levels(Transformation::premultiplied, eight, eight) == 2); // of colour and alpha
  for (const Transformation which :
       {Transformation::upside_down, Transformation::mirrored, Transformation::red_blue_exchanged,
        Transformation::shifted, Transformation::video_range, Transformation::scaled, Transformation::half_size})
    CHECK(levels(which, eight, eight) == 1);
  CHECK(levels(Transformation::srgb_curve_added, sixteen, sixteen) == doctest::Approx(2.0 / 257).epsilon(1e-12));
  CHECK(levels(Transformation::upside_down, eight, sixteen) == doctest::Approx(129.0 / 257).epsilon(1e-12));
  // 2.4 times the rounding of one float at white, that of the other, and that of pow in single precision.
  CHECK(levels(Transformation::srgb_curve_added, StoredPrecision::floats(0x1p-24), StoredPrecision::floats(0x1p-24)) ==
        doctest::Approx(255 * 0x1p-24 * (2.4 + 1 + 16 + 8.1 / 2.4)));
}

TEST_CASE("two right images of two programs, a level apart, one of them transformed: then equal within 1 level") {
  const Picture picture = drawn_picture();
  std::mt19937 random(5);
  Picture other = picture;
  for (float& value : other.values) value = std::clamp(value + static_cast<float>(random() % 3) - 1, 0.0f, 255.0f);
  for (const Mistake& mistake : known_mistakes()) {
    const auto result = found(picture, mistake.make(other), 1);
    INFO(known(mistake.which).name << ": " << text_of(result));
    REQUIRE(result);
    CHECK(result->which == mistake.which);
  }
  CHECK(text_of(found(picture, known_mistakes()[2].make(other))) ==
        "b is a turned upside down: then equal within 1 level");
}

TEST_CASE("the words of each, with what belongs to it") {
  const Picture picture = drawn_picture();
  std::string all;
  for (const Mistake& mistake : known_mistakes()) all += text_of(found(picture, mistake.make(picture))) + "\n";
  for (const char* const words :
       {"b is a with the sRGB curve once too often: then equal within 1 level\n",
        "b is a with the sRGB curve missing: then equal\n", "b is a turned upside down: then equal\n",
        "b is a mirrored, left to right: then equal\n", "b is a with R and B exchanged: then equal\n",
        "b is a in video range, 16 to 235: then equal\n", "b is a shifted by 1 pixel to the right: then equal\n",
        "b is a shifted by 1 pixel up: then equal\n",
        "b is a shifted by 3 pixels to the left and 2 pixels down: then equal\n",
        "b is a scaled by 0.25 (-2 stops): then equal\n", "b is a scaled by 2 (+1 stops): then equal"})
    CHECK_MESSAGE(all.find(words) != std::string::npos, words << "in\n" << all);
}

TEST_CASE("colours that were multiplied by alpha, or were not, are named where there is an alpha") {
  const Picture picture = drawn_picture();
  Picture alpha(picture.width, picture.height, 1);
  for (int y = 0; y < alpha.height; ++y)
    for (int x = 0; x < alpha.width; ++x) *alpha.at(x, y) = static_cast<float>((x * 5 + y * 3) % 256) / 255.0f;
  Picture multiplied = picture;
  for (int y = 0; y < alpha.height; ++y)
    for (int x = 0; x < alpha.width; ++x)
      for (int c = 0; c < 3; ++c) multiplied.at(x, y)[c] = std::nearbyint(picture.at(x, y)[c] * *alpha.at(x, y));
  CHECK(text_of(found(picture, multiplied, 0, alpha)) == "b is a premultiplied by alpha: then equal");
  CHECK(text_of(found(multiplied, picture, 0, alpha)) == "b is a with the multiplication by alpha missing: then equal");
  CHECK(text_of(found(picture, multiplied)) == "none");
}

TEST_CASE("half and double size are named: by the mean of four pixels, by one of them, or by the size alone") {
  const Picture large = drawn_picture();
  const auto half = [&](const auto& value) {
    Picture small(large.width / 2, large.height / 2, 3);
    for (int y = 0; y < small.height; ++y)
      for (int x = 0; x < small.width; ++x)
        for (int c = 0; c < 3; ++c) small.at(x, y)[c] = value(2 * x, 2 * y, c);
    return small;
  };
  const auto sizes = [](const Picture& a, const Picture& b) {
    return text_of(find_size_transformation(stored(a), stored(b), 0));
  };
  const Picture mean = half([&](int x, int y, int c) {
    return std::nearbyint(
        (large.at(x, y)[c] + large.at(x + 1, y)[c] + large.at(x, y + 1)[c] + large.at(x + 1, y + 1)[c]) / 4);
  });
  const Picture one = half([&](int x, int y, int c) { return large.at(x + 1, y)[c]; });
  CHECK(sizes(large, mean) == "b is a at half size: then equal");
  CHECK(sizes(mean, large) == "b is a at double size: then equal");
  CHECK(sizes(large, one) == "b is a at half size: then equal");
  const Picture other = half([](int x, int y, int) { return static_cast<float>((x + y) % 3 * 100); });
  CHECK(sizes(large, other) == "b is a at half size (by its size; its pixels are others)");
  CHECK(sizes(large, Picture(96, 32, 3)) == "none");
  CHECK(sizes(large, Picture(95, 64, 3)) == "none");
  CHECK(sizes(large, large) == "none");
  CHECK(sizes(Picture(1, 1, 3), Picture(1, 1, 3)) == "none");
}

TEST_CASE("images of 16 bits and of floats have the same mistakes") {
  const Picture picture = drawn_picture();
  Picture fine = picture, values = picture;
  for (float& value : fine.values) value = std::nearbyint(value * 257 * 0.9f + 1000);
  for (std::size_t i = 0; i < fine.values.size(); ++i) values.values[i] = fine.values[i] / 65535;
  const auto curve = [](double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; };
  Picture fine_curve = fine, curve_values = values;
  for (float& value : fine_curve.values)
    value = static_cast<float>(std::nearbyint(65535 * curve(static_cast<double>(value) / 65535)));
  // In single precision, as a shader does it.
  for (float& value : curve_values.values) value = 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
  const StoredPrecision sixteen = StoredPrecision::integers(65535), single = StoredPrecision::floats(0x1p-24);
  const auto fine_found = find_transformation({fine, 65535, sixteen}, {fine_curve, 65535, sixteen}, {}, 0);
  CHECK(text_of(fine_found).starts_with("b is a with the sRGB curve once too often: then equal within 0.00"));
  // 255 * 2^-24 * 22.8 = 3.5e-4
  const std::string of_floats = text_of(find_transformation({values, 1, single}, {curve_values, 1, single}, {}, 0));
  CHECK_MESSAGE(of_floats.starts_with("b is a with the sRGB curve once too often: then equal within "), of_floats);
  // One of them is stored with 8 bits: at most 2.28 times half a level, which the picture does not reach.
  Picture coarse_curve = curve_values;
  for (float& value : coarse_curve.values) value = std::nearbyint(value * 255) / 255;
  const std::string coarse =
      text_of(find_transformation({values, 1, single}, {coarse_curve, 1, StoredPrecision::integers(255)}, {}, 0));
  CHECK_MESSAGE(coarse.starts_with("b is a with the sRGB curve once too often: then equal within 0.982 levels"),
                coarse);
}

TEST_CASE("a value that was cut off may have been any beyond it, but does not make a transformation") {
  const Picture picture = drawn_picture();
  Picture bright = picture; // floats up to 3
  for (float& value : bright.values) value *= 3.0f / 255;
  Picture cut = bright;
  for (float& value : cut.values) value = std::nearbyint(std::min(value / 2, 1.0f) * 255) / 255;
  const auto result = find_transformation({bright, 1, StoredPrecision::floats(0x1p-24)},
                                          {cut, 1, StoredPrecision::integers(255)}, {}, 0);
  CHECK(text_of(result).starts_with("b is a scaled by 0.5 (-1 stops): then equal within"));
  // Of a ramp, an eighth is left below white when it is 8 times as light, and less than a tenth when it is 25 times.
  Picture ramp(256, 20, 1);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 256; ++x) *ramp.at(x, y) = static_cast<float>(x);
  CHECK(text_of(found(ramp, mapped(ramp, [](double v) { return v * 8; }))) ==
        "b is a scaled by 8 (+3 stops): then equal within 1 level"); // 33 of a beside 255 / 8
  CHECK(text_of(found(ramp, mapped(ramp, [](double v) { return v * 25; }))) == "none");
}

TEST_CASE("NaN and infinities are equal to nothing that is undone") {
  Picture picture = drawn_picture();
  const Picture turned = known_mistakes()[2].make(picture);
  Picture broken = turned;
  for (std::size_t i = 0; i < 7; ++i) broken.values[300 * i] = std::numeric_limits<float>::quiet_NaN();
  CHECK(found(picture, turned));
  CHECK_FALSE(found(picture, broken));
}

TEST_CASE("tiny images, images of one channel and flat ones are no trouble") {
  CHECK(text_of(found(Picture(1, 1, 3), Picture(1, 1, 3, 9))) == "none");
  CHECK(text_of(found(Picture(2, 1, 1), Picture(2, 1, 1, 9))) == "none");
  CHECK(text_of(found(Picture(40, 30, 3, 100), Picture(40, 30, 3, 120))) == "none");
  Picture grey(3, 2, 1), turned(3, 2, 1);
  grey.values = {0, 50, 200, 90, 10, 30}, turned.values = {90, 10, 30, 0, 50, 200};
  CHECK(text_of(found(grey, turned)) == "b is a turned upside down: then equal");
}

TEST_CASE(
    "few pixels of an image that is else of one colour are enough to see what happened, and to see that nothing did") {
  Picture dot(100, 100, 3);
  for (int i = 0; i < 4; ++i) dot.at(20 + i, 10)[i % 3] = 200, dot.at(20, 10 + i)[1] = 90;
  const Picture elsewhere = known_mistakes()[2].make(dot);
  CHECK(text_of(found(dot, elsewhere)) == "b is a turned upside down: then equal");
  Picture other = dot; // the same pixels in another colour
  for (float& value : other.values) value = value == 200 ? 50 : value == 90 ? 255 : 0;
  CHECK(text_of(found(dot, other)) == "none");
}

TEST_CASE("a picture that equals its mirror image, but for some pixels, is not mirrored") {
  Picture even(100, 100, 3);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x)
      for (int c = 0; c < 3; ++c)
        even.at(x, y)[c] = static_cast<float>(std::min(x, 99 - x) * 3 + std::min(y, 99 - y) * 2 + 5 * c);
  CHECK(text_of(found(even, with_wrong_pixels(even, 5))) == "none");
}

TEST_CASE("what lies at the border and is missing in one image is not taken for shifted out of it") {
  Picture stripes(120, 60, 3);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 120; ++x)
      for (int c = 0; c < 3; ++c) stripes.at(x, y)[c] = static_cast<float>(x % 8 * 20 + y % 4 * 9 + c);
  Picture with_block = stripes;
  for (int y = 20; y < 40; ++y)
    for (int x = 0; x < 8; ++x) with_block.at(x, y)[1] = 250;
  CHECK(text_of(found(stripes, with_block)) == "none");
  CHECK(text_of(found(with_block, stripes)) == "none");
}

TEST_CASE("the scale is that of most values, whatever the others are") {
  Picture a(100, 1, 1), b(100, 1, 1);
  for (int x = 0; x < 100; ++x)
    *a.at(x, 0) = static_cast<float>(x), *b.at(x, 0) = x % 4 ? 0.5f * static_cast<float>(x) : 200.0f;
  CHECK(scale_factor(stored(a), stored(b)) == 0.5);
  CHECK(scale_factor(stored(Picture(3, 3, 3)), stored(Picture(3, 3, 3, 9))) == 0); // of black there is none
}

TEST_CASE("lists of known transformations: each has its place, and a line in docs/compare.md") {
  std::ifstream file(std::string(REFRASTER_SOURCE_DIR) + "/docs/compare.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const KnownTransformation& transformation : known_transformations) {
    CHECK(&known(transformation.which) == &transformation);
    CHECK_MESSAGE(page.str().find("| `" + std::string(transformation.name) + "` | " +
                                  std::string(transformation.words) + " | " + std::string(transformation.undone) +
                                  " |") != std::string::npos,
                  transformation.name);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("each known transformation of images of the gallery is named, and nothing else is") {
    const std::vector<NamedPicture> pictures = gallery_pictures();
    for (const NamedPicture& picture : pictures) {
      check_named(picture.name, picture.picture);
      check_not_named(picture.name, picture.picture);
    }
    for (const NamedPicture& a : pictures)
      for (const NamedPicture& b : pictures) {
        INFO(a.name << " beside " << b.name);
        CHECK(text_of(found(a.picture, b.picture, 2)) == "none");
      }
  }
}
