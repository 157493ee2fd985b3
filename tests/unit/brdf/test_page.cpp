// Pictures and pages of reflectances.

#include "brdf/page/charts.h"
#include "brdf/page/colour_map.h"
#include "brdf/page/page.h"

#include <doctest/doctest.h>

#include <cctype>
#include <string>

using namespace refraster;

namespace {

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Whether it is printed somewhere as a number; within words, as in "luminance", it is none.
bool has_number(const std::string& text, const std::string& name) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + name.size())) return true;
  return false;
}

} // namespace

TEST_CASE("colour maps begin and end as they are published, and go beyond neither end") {
  CHECK(sequential_colour(0) == MapColour{0x44, 0x01, 0x54, 255});
  CHECK(sequential_colour(1) == MapColour{0xfd, 0xe7, 0x25, 255});
  CHECK(sequential_colour(2) == sequential_colour(1));
  CHECK(diverging_colour(-1) == MapColour{0x21, 0x66, 0xac, 255});
  CHECK(diverging_colour(0) == MapColour{0xf7, 0xf7, 0xf7, 255});
  CHECK(colour_strip(sequential_colour, 0, 1).at(0, 255)[0] < 0x48); // the first at the bottom
}

TEST_SUITE_BEGIN("slow"); // albedos of many angles

TEST_CASE("a page has every picture, and asks for nothing else") {
  const Brdf a("lambert:albedo=.5", {Lambert{}}), b("<b> & phong", {Phong{}});
  for (const BrdfChart& chart : brdf_charts) {
    const std::string one = chart.chart({a}), two = chart.chart({a, &b});
    CHECK(one.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    CHECK(one.ends_with("</svg>\n"));
    CHECK_FALSE(has_number(one, "nan"));
    CHECK_FALSE(has_number(two, "nan"));
    CHECK(two.find("<b>") == std::string::npos);
    CHECK(two.size() > one.size());
  }
  const std::string page = brdf_page_html({{a, &b}, "a & b", page_facts(a, "a"), "text <of> lines\n"});
  CHECK(count_of(page, "<svg") == brdf_charts.size());
  CHECK(count_of(page, "http") == brdf_charts.size()); // the name of SVG itself
  CHECK(page.find("<title>a &amp; b</title>") != std::string::npos);
  CHECK(page.find("text &lt;of&gt; lines") != std::string::npos);
  CHECK(page.find("<script") == std::string::npos);
}

TEST_CASE("a black surface, and one without bounds at the horizon, have pictures too") {
  const Brdf black("black", {Lambert{Double3(0)}});
  Phong endless;
  endless.ks = Double3(1e6), endless.glossiness = 0;
  const Brdf bright("bright", {endless});
  for (const BrdfChart& chart : brdf_charts) {
    CHECK_FALSE(has_number(chart.chart({black, &bright}), "nan"));
    CHECK_FALSE(has_number(chart.chart({black}), "inf"));
  }
}

TEST_SUITE_END();
