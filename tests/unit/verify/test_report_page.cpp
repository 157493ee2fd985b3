#include "tests/support/text.h"
#include "verify/page/report_page.h"

#include <refraster/files.h>

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/random.h"
#include "tests/unit/verify/unpacked.h"
#include "verify/page/verdict_colours.h"

#include <doctest/doctest.h>

#include <bit>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

using namespace refraster;

namespace {

/// Two images of this size, of levels that rise, and nothing else.
ReportPage plain_page(int width, int height) {
  ReportPage page;
  page.title = "a page";
  page.headline = "A verdict";
  page.reference.rgb8 = Image<std::uint8_t>(width, height, 3);
  for (std::size_t i = 0; i < page.reference.rgb8.values.size(); ++i)
    page.reference.rgb8.values[i] = static_cast<std::uint8_t>(i * 7);
  page.actual.rgb8 = page.reference.rgb8;
  return page;
}

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Ends every context that a text of a page could stand in.
const std::string hostile = "</script><!--<b a='\" onclick=x>&amp;]]> {{data}} \\u003c";

} // namespace

TEST_CASE("a text of a scene stays a text, wherever it is shown") {
  const std::string plain = report_html(plain_page(2, 2));
  ReportPage page = plain_page(2, 2);
  page.title = page.headline = page.power = hostile;
  page.summary = {hostile};
  page.reference.label = page.reference.source = hostile;
  page.classes = {{hostile, {1, 2, 3}, hostile}};
  page.class_map = Image<std::uint8_t>(2, 2, 1);
  page.object_names = {hostile};
  page.objects = Image<std::uint32_t>(2, 2, 1, 1);
  page.notes = {{0, 0, {{hostile, 0.5}}, hostile}};
  page.hypotheses = {{hostile, 0.5, 2, 1, hostile, page.reference}};
  page.clusters = {{{0, 0, 1, 1, 1, 5, 0, 0}, {{hostile, 1}}}};
  page.tables = {{hostile, hostile, {hostile}, {{hostile}}}};
  page.provenance = {{hostile, hostile}};
  const std::string html = report_html(page);
  CHECK_FALSE(holds(html, "<b a="));
  CHECK_FALSE(holds(html, "<!--"));
  // One element for each plane more, each ended once.
  CHECK(count_of(html, "</script>") == count_of(html, "<script"));
  CHECK(count_of(html, "</script>") == count_of(plain, "</script>") + 4); // classes, objects, hypothesis, notes
  CHECK(holds(html, "&lt;/script&gt;"));
  CHECK(holds(html, "\\u003c/script>"));
  CHECK(count_of(html, "\"not_a_number\"") == 1); // what looks like the template's {{data}} was not filled in
}

TEST_CASE("a page asks for nothing but itself") {
  const std::string html = report_html(plain_page(3, 2));
  for (const char* const part : {"http:", "https:", "src=", "url(", "@import", "import(", "fetch(", "XMLHttp"})
    CHECK_MESSAGE(!holds(html, part), part);
  CHECK(holds(html, "default-src 'none'"));
}

TEST_CASE("the images of a page are those that it was given, NaN and all, the second as a difference") {
  Random random(5);
  ReportPage page = plain_page(31, 17);
  for (std::uint8_t& level : page.actual.rgb8.values) level = static_cast<std::uint8_t>(level + random.below(2));
  const std::string html = report_html(page);
  const auto reference = test::unpacked_rows(test::plane_of(html, "reference"), 31, 17, 3);
  CHECK(reference == page.reference.rgb8.values);
  CHECK(holds(
      html,
      R"(id="plane-actual" data-type="u8" data-width="31" data-height="17" data-channels="3" data-base="reference")"));
  const auto left = test::unpacked_rows(test::plane_of(html, "actual"), 31, 17, 3);
  for (std::size_t i = 0; i < left.size(); ++i)
    CHECK(static_cast<std::uint8_t>(reference[i] + left[i]) == page.actual.rgb8.values[i]);

  // Levels beside values: each as it is.
  page.actual = {.label = "actual", .values = Image<float>(31, 17, 1, std::numeric_limits<float>::quiet_NaN())};
  const std::string mixed = report_html(page);
  CHECK(holds(mixed, R"(id="plane-actual" data-type="f32" data-width="31" data-height="17" data-channels="1">)"));
  for (const std::uint32_t bits : test::numbers_of(test::unpacked_rows(test::plane_of(mixed, "actual"), 31, 68, 1)))
    CHECK((bits & 0x7fffffff) > 0x7f800000);
}

TEST_CASE("allowed intervals come in the order of their pixels, those of one pixel as they were given") {
  ReportPage page = plain_page(4, 3);
  const auto interval = [](int x, int y, float low) {
    PageInterval one{x, y};
    one.low.fill(low);
    one.high.fill(low + 1);
    return one;
  };
  page.allowed = {interval(3, 2, 5), interval(0, 1, 7), interval(3, 2, 1), interval(1, 0, 9)};
  const std::string html = report_html(page);
  const auto pixels = test::numbers_of(test::unpacked_rows(test::plane_of(html, "allowed-pixels"), 4, 4, 1));
  CHECK(pixels == std::vector<std::uint32_t>{1, 4, 11, 11}); // 4 y + x
  const auto ends = test::numbers_of(test::unpacked_rows(test::plane_of(html, "allowed-ends"), 4, 4, 6));
  std::vector<float> lows, highs;
  for (std::size_t i = 0; i < 4; ++i) {
    lows.push_back(std::bit_cast<float>(ends[6 * i]));
    highs.push_back(std::bit_cast<float>(ends[6 * i + 5]));
  }
  CHECK(lows == std::vector<float>{9, 7, 5, 1});
  CHECK(highs == std::vector<float>{10, 8, 6, 2});
}

TEST_CASE("classes are counted, hypotheses rounded down, and what is empty leaves no section") {
  ReportPage page = plain_page(3, 1);
  const std::string plain = report_html(page);
  for (const char* const id :
       {"id=\"causes\"", "id=\"clusters\"", "id=\"numbers\"", "id=\"provenance\"", "plane-notes\""})
    CHECK_MESSAGE(!holds(plain, id), id);
  page.classes = {{"good", {1, 2, 3}}, {"odd", {255, 0, 16}}};
  page.class_map = Image<std::uint8_t>(3, 1, 1);
  page.class_map.values = {0, 1, 1};
  page.hypotheses = {{"nearly all", 0.99999, 100'000, 1}, {"all", 1, 100'000, 0}};
  const std::string html = report_html(page);
  CHECK(holds(html, "\"colour\": \"#ff0010\""));
  CHECK(holds(html, "\"pixels\": 2"));
  CHECK(holds(html, "<b>99.9 %</b>"));
  CHECK(holds(html, "<b>100 %</b>"));
  CHECK(holds(html, "100,000 pixels"));
  CHECK(holds(html, "1 pixel<"));
}

TEST_CASE("one pixel makes a page, and so does a row of 8192") {
  CHECK(holds(report_html(plain_page(1, 1)), "data-width=\"1\" data-height=\"1\""));
  CHECK(holds(report_html(plain_page(8192, 1)), "data-width=\"8192\" data-height=\"1\""));
}

TEST_CASE("the same page gives the same bytes") {
  CHECK(report_html(plain_page(20, 10)) == report_html(plain_page(20, 10)));
}

TEST_CASE("a page of two nearly equal images takes no more than their PNG files") {
  Random random(11);
  ReportPage page = plain_page(1024, 768);
  for (int y = 0; y < 768; ++y)
    for (int x = 0; x < 1024; ++x)
      for (int c = 0; c < 3; ++c)
        page.reference.rgb8.at(x, y)[c] = static_cast<std::uint8_t>((x * (c + 1) + y) / 8 % 200 + random.below(20));
  page.actual.rgb8 = page.reference.rgb8;
  for (std::uint8_t& level : page.actual.rgb8.values) level = static_cast<std::uint8_t>(level + (random.below(8) == 0));
  const test::TemporaryFolder folder;
  write_image(folder / "a.png", page.reference.rgb8);
  write_image(folder / "b.png", page.actual.rgb8);
  const auto files = std::filesystem::file_size(folder / "a.png") + std::filesystem::file_size(folder / "b.png");
  CHECK(report_html(page).size() <= files);
}

TEST_CASE("a page whose parts do not fit together is refused") {
  const auto refused = [](auto change) {
    ReportPage page = plain_page(4, 3);
    change(page);
    CHECK_THROWS_AS(report_html(page), std::invalid_argument);
  };
  refused([](ReportPage& page) { page.actual = {.label = "none"}; });
  refused([](ReportPage& page) { page.actual.rgb8 = Image<std::uint8_t>(3, 4, 3); });
  refused([](ReportPage& page) { page.actual.values = Image<float>(4, 3, 3); }); // both
  refused([](ReportPage& page) { page.actual.names = {"R"}; });
  refused([](ReportPage& page) { page.bound_width = Image<float>(4, 2, 1); });
  refused([](ReportPage& page) { page.triangles = Image<std::uint32_t>(4, 3, 2); });
  refused([](ReportPage& page) { page.class_map = Image<std::uint8_t>(4, 3, 1); }); // no class 0
  refused([](ReportPage& page) { page.objects = Image<std::uint32_t>(4, 3, 1, 1); });
  refused([](ReportPage& page) { page.allowed = {{4, 0}}; });
  refused([](ReportPage& page) { page.notes = {{0, -1}}; });
  refused([](ReportPage& page) { page.tables = {{"", "", {"a", "b"}, {{"1"}}}}; });
  refused([](ReportPage& page) {
    page.hypotheses = {{"", 0, 0, 0, "", {.label = "", .values = Image<float>(1, 1, 1)}}};
  });
}
