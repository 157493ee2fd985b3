// What is drawn over the picture, and values as colours.

#include "app/view/draw/aov_colours.h"
#include "app/view/draw/font.h"
#include "app/view/draw/overlay.h"
#include "app/view/screen.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

using namespace refraster;

namespace {

/// A white picture, with room around it that nothing may be written to.
struct Paper {
  static constexpr int margin = 3;
  int width, height, stride;
  std::vector<std::uint32_t> all;

  Paper(int w, int h)
      : width(w), height(h), stride(w + margin),
        all(static_cast<std::size_t>(stride) * static_cast<std::size_t>(h), 0xFFFFFF) {}
  Canvas canvas() { return {all.data(), width, height, stride}; }
  std::uint32_t at(int x, int y) const { return all[static_cast<std::size_t>(y * stride + x)]; }
  bool margin_is_white() const {
    for (int y = 0; y < height; ++y)
      for (int x = width; x < stride; ++x)
        if (at(x, y) != 0xFFFFFF) return false;
    return true;
  }
  int count(std::uint32_t colour) const { return static_cast<int>(std::count(all.begin(), all.end(), colour)); }
};

constexpr std::uint32_t text_colour = 0xF2F2F2;

} // namespace

TEST_CASE("letters are told apart, and what the font has not is a question mark") {
  std::set<std::vector<std::uint8_t>> shapes;
  const auto shape = [](char32_t letter) {
    std::vector<std::uint8_t> rows;
    for (int y = 0; y < glyph_height; ++y) rows.push_back(glyph_row(letter, y));
    return rows;
  };
  for (char32_t letter = 0x20; letter < 0x7F; ++letter) CHECK(shapes.insert(shape(letter)).second);
  CHECK(shape(U'I') == std::vector<std::uint8_t>{0, 0, 0x7C, 0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x7C, 0, 0});
  CHECK(shapes.insert(shape(U'°')).second);
  CHECK(shapes.insert(shape(U'…')).second);
  CHECK(shape(U'語') == shape(U'?'));
}

TEST_CASE("a panel is as large as its text, darkens what is below it, and stays within the window") {
  Paper paper(400, 300);
  Panel panel{.lines = {"I", "äI"}};
  const Area area = draw_panel(paper.canvas(), panel);
  CHECK(area.width == 2 * glyph_width + 16);
  CHECK(area.height == 2 * (glyph_height + 2) + 16);
  CHECK(paper.at(0, 0) == 0x3F3F3F);
  CHECK(paper.at(area.width, 0) == 0xFFFFFF);
  int dots = 0;
  for (const char32_t letter : {U'I', U'ä', U'I'})
    for (int y = 0; y < glyph_height; ++y) dots += __builtin_popcount(glyph_row(letter, y));
  CHECK(paper.count(text_colour) == dots);

  for (const Corner corner : {Corner::top_left, Corner::top_right, Corner::bottom_left})
    for (const int width : {1, 20, 33, 200})
      for (const int height : {1, 20, 37, 90}) {
        Paper small(width, height);
        Panel large{.lines = std::vector<std::string>(30, "a long line of text that no small window holds"),
                    .corner = corner,
                    .kind = PanelKind::fault,
                    .first_line = 100};
        const Area covered = draw_panel(small.canvas(), large);
        CHECK(covered.x + covered.width <= width);
        CHECK(covered.y + covered.height <= height);
        CHECK(small.margin_is_white());
        CHECK((large.first_line < 30 || covered.width == 0)); // brought back
      }
}

TEST_CASE("a mark beside the edge of the window is cut off there") {
  for (const int x : {0, 5, 39}) {
    Paper paper(40, 30);
    draw_cross(paper.canvas(), x, 29);
    draw_progress(paper.canvas(), 2);
    CHECK(paper.margin_is_white());
  }
  Paper paper(40, 30);
  draw_cross(paper.canvas(), 20, 15);
  CHECK(paper.at(20, 15) == 0xFFFFFF);
  CHECK(paper.at(16, 15) != 0xFFFFFF);
}

TEST_CASE("depth and distance are stretched over what is seen; where no surface is, it is black") {
  Image<float> objects(3, 1, 1), depth(3, 1, 1);
  objects.values = {1, 2, 0}, depth.values = {0.25F, 0.75F, 1};
  const AovPicture picture = aov_picture(Aov::depth, depth, objects);
  CHECK(picture.rgb8.values == std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 0, 0, 0});
  CHECK(picture.legend == "depth: 0.25 black to 0.75 white");
  CHECK(aov_picture(Aov::depth, depth, Image<float>(3, 1, 1)).legend == "depth: no surface");
}

TEST_CASE("unit vectors, coordinates of textures and numbers have colours of their own") {
  const Image<float> objects(1, 1, 1, 1);
  Image<float> normal(1, 1, 3);
  normal.values = {-1, 0, 1};
  CHECK(aov_picture(Aov::normal, normal, objects).rgb8.values == std::vector<std::uint8_t>{0, 128, 255});
  Image<float> uv(1, 1, 2);
  uv.values = {1.25F, -0.5F};
  CHECK(aov_picture(Aov::uv, uv, objects).rgb8.values == std::vector<std::uint8_t>{64, 128, 0});
  std::set<std::vector<std::uint8_t>> colours;
  for (int number = 1; number <= 200; ++number) {
    const std::vector<std::uint8_t> colour =
        aov_picture(Aov::triangle, Image<float>(1, 1, 1, static_cast<float>(number)), objects).rgb8.values;
    CHECK(colours.insert(colour).second);
    CHECK(*std::max_element(colour.begin(), colour.end()) == 255);
  }
}

TEST_CASE("edges are where the triangle or the object of the next pixel is another") {
  Image<float> objects(3, 2, 1, 1), triangles(3, 2, 1, 1);
  triangles.values = {7, 7, 8, 7, 7, 8};
  Image<std::uint8_t> rgb8(3, 2, 3, 200);
  draw_edges(rgb8, objects, triangles);
  for (int y = 0; y < 2; ++y) {
    CHECK(*rgb8.at(0, y) == 200);
    CHECK(*rgb8.at(1, y) == 100); // half of cyan, which has no red
    CHECK(rgb8.at(1, y)[2] == 227);
    CHECK(*rgb8.at(2, y) == 200);
  }
}

TEST_CASE("what was opened last is closed first, and a message goes by itself") {
  Screen screen;
  Paper paper(600, 400);
  CHECK_FALSE(screen.close_last());
  screen.show_fault("It is bad.", "scene.json:3: found \"x\",\nexpected a number");
  screen.marked = {{10, 10}};
  screen.show_story({"story"}, 600);
  screen.draw(paper.canvas());
  CHECK_FALSE(screen.close_at(300, 200));
  CHECK(screen.close_at(590, 5)); // the story, top right
  screen.switch_help();
  CHECK(screen.close_last()); // help
  CHECK(screen.close_last()); // the fault
  CHECK_FALSE(screen.close_last());

  screen.changed = false;
  screen.say("written", 5);
  CHECK(screen.changed);
  CHECK(screen.next_change() == 5);
  screen.changed = false;
  screen.forget(4.9);
  CHECK_FALSE(screen.changed);
  screen.forget(5);
  CHECK(screen.changed);
}
