#include "verify/page/compare_page.h"

#include <refraster/files.h>

#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

using namespace refraster;

namespace {

/// Two grey files of these values, compared.
struct Compared {
  Compared(const std::vector<float>& a, const std::vector<float>& b, const CompareLimits& limits = {},
           const std::optional<SeenObjects>& seen = std::nullopt) {
    Image<float> image(static_cast<int>(a.size()), 1, 1);
    image.values = a;
    write_image(folder / "a.pfm", image);
    image.values = b;
    write_image(folder / "b.pfm", image);
    const ImagePair images = read_image_pair(folder / "a.pfm", folder / "b.pfm");
    const PixelScale scale(images.full_scale, CompareUnit::levels);
    report = {folder / "a.pfm", folder / "b.pfm", limits, compare(images.a, images.b, scale, limits)};
    page = comparison_page(report, images, scale, seen);
  }

  test::TemporaryFolder folder;
  ComparisonReport report;
  ReportPage page;
};

std::vector<std::string> class_names(const ReportPage& page) {
  std::vector<std::string> names;
  for (const std::uint8_t which : page.class_map.values) names.push_back(page.classes[which].name);
  return names;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("each pixel of a comparison is equal, within the limit, over it, or without a difference") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> a = {0, 0, 0, nan}, b = {0, 1.0F / 255, 9.0F / 255, nan};
  CHECK(class_names(Compared(a, b, {.max_abs = 2}).page) ==
        Names{"equal", "within the limit", "over the limit", "no difference"});
  CHECK(class_names(Compared(a, b).page) == Names{"equal", "different", "different", "no difference"});
}

TEST_CASE("the page of a comparison says its verdict, whose pixels lie where, and of which files") {
  SeenObjects seen;
  seen.names = {"ball"};
  seen.object = Image<std::uint32_t>(3, 1, 1, 1);
  seen.triangle = Image<std::uint32_t>(3, 1, 1, 7);
  const Compared compared({0, 0, 0}, {0, 0, 1}, {.max_abs = 2}, seen);
  const ReportPage& page = compared.page;
  CHECK(page.headline == "Differ by more than max-abs 2 levels");
  CHECK(page.tone == PageTone::failed);
  REQUIRE(page.clusters.size() == 1);
  CHECK(page.clusters[0].where.worst_x == 2);
  CHECK(page.object_names == Names{"ball"});
  CHECK(page.reference.values.values == std::vector<float>{0, 0, 0});
  CHECK(page.actual.values.values == std::vector<float>{0, 0, 1});
  CHECK(page.provenance[0] == std::pair<std::string, std::string>{"A", compared.folder / "a.pfm"});
  CHECK(page.provenance[1].second.size() == 64);
  CHECK_FALSE(report_html(page).empty());

  const ReportPage equal = Compared({0.5F}, {0.5F}).page;
  CHECK(equal.headline == "Equal");
  CHECK(equal.tone == PageTone::passed);
  CHECK(equal.clusters.empty());
}

TEST_CASE("files of 8 bits are shown in whole levels, of 16 bits in values") {
  const test::TemporaryFolder folder;
  write_image(folder / "a.png", Image<std::uint8_t>(2, 1, 3, 200));
  Image<float> values(2, 1, 3, 200.0F / 255);
  write_image(folder / "b.pfm", values);
  const auto page_of = [&](const std::string& b) {
    const ImagePair images = read_image_pair(folder / "a.png", folder / b);
    const PixelScale scale(images.full_scale, CompareUnit::levels);
    return comparison_page({folder / "a.png", folder / b, {}, compare(images.a, images.b, scale, {})}, images, scale,
                           {});
  };
  CHECK(page_of("a.png").reference.rgb8.values == std::vector<std::uint8_t>(6, 200));
  CHECK(page_of("a.png").reference.values.empty());
  CHECK(page_of("b.pfm").reference.values.values == values.values);
}
