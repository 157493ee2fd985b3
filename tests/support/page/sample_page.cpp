#include "tests/support/page/sample_page.h"

#include <refraster/render.h>

#include "io/file/build_info.h"
#include "io/file/text.h"
#include "tests/support/random.h"
#include "verify/compare/clusters.h"
#include "verify/page/verdict_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>

namespace refraster::test {
namespace {

enum Kind : std::uint8_t {
  exact,
  rounding,
  shading,
  texel,
  branch,
  shadow,
  edge,
  depth,
  undefined,
  unverifiable,
  unexplained
};
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kinds = {{
    {"exact", "The level that the exact value rounds to."},
    {"rounding", "A neighbour of that level, as rounding of the device's numbers may give it."},
    {"shading", "Within what the operations of the fragment function may be off."},
    {"texel", "Another texel or mip level may be read there."},
    {"branch", "A comparison in the fragment function may fall the other way."},
    {"shadow", "A comparison with a shadow map may fall the other way."},
    {"edge", "The sample is so near to an edge that either triangle may be seen."},
    {"depth", "Two surfaces are nearer to each other than the depth buffer tells."},
    {"undefined", "The mathematics leaves open what is right."},
    {"unverifiable", "The bound is so wide that any value would do."},
    {"unexplained", "No right device gives this."},
}};

Frame rendered(const Scene& scene, int width, int height) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.want_radiance = true;
  options.aovs = {Aov::object, Aov::triangle};
  return render(scene, options);
}

Scene with_phong(Scene scene) {
  const auto& blinn = std::get<BlinnPhong>(scene.objects.at(0).material.fragment_function);
  Phong phong;
  static_cast<PhongParameters&>(phong) = blinn;
  scene.objects[0].material.fragment_function = phong;
  return scene;
}

/// The level that a device gives whose sums are off in their last digits, and of which class that is: near the middle
/// between two levels it is the other one of them.
struct DeviceLevel {
  std::uint8_t level;
  Kind kind;
};
DeviceLevel device_level(float value, Random& random) {
  const double levels = std::clamp(255 * static_cast<double>(value), 0.0, 255.0), below = std::floor(levels);
  const double from_middle = levels - below - 0.5;
  const double nearest = from_middle < 0 ? below : below + 1, other = from_middle < 0 ? below + 1 : below;
  const auto of = [](double level) { return static_cast<std::uint8_t>(std::min(level, 255.0)); };
  if (levels == 255 || levels == 0) return {of(levels), exact};
  if (std::abs(from_middle) < 0.012) return {of(other), rounding};
  if (std::abs(from_middle) < 0.02 && random.below(3) == 0) return {of(other), shading};
  return {of(nearest), exact};
}

/// Now and then a pixel of a class that no rule above gives.
Kind rare_kind(Random& random) {
  constexpr Kind rare[] = {texel, branch, depth, undefined, unverifiable};
  const int pick = random.below(4000);
  return pick < 10 ? rare[pick % 5] : exact;
}

bool at_edge(const Image<std::uint32_t>& objects, int x, int y) {
  const auto other = [&](int nx, int ny) {
    return nx < objects.width && ny < objects.height && *objects.at(nx, ny) != *objects.at(x, y);
  };
  return other(x + 1, y) || other(x, y + 1);
}

std::string story(int x, int y, const std::uint8_t* reference, const std::uint8_t* actual) {
  return format("pixel (%d, %d)\n  sees knot, depth 0.98213\n  n·l 0.7312   n·h 0.9964   (n·h)^90 0.7226\n"
                "  ambient   0.030\n  diffuse   0.453 x 1.12\n  specular  0.542 x 1.12\n"
                "reference  %3d %3d %3d\nactual     %3d %3d %3d\n"
                "The specular term would have to be 0.211: (r·v)^90 is.",
                x, y, reference[0], reference[1], reference[2], actual[0], actual[1], actual[2]);
}

std::vector<PageCluster> named_clusters(const Image<std::uint8_t>& marked, const Image<double>& differences,
                                        const ReportPage& page) {
  std::vector<Cluster> found = clusters_of(marked, differences);
  found.resize(std::min(found.size(), max_clusters));
  std::vector<PageCluster> result;
  for (const Cluster& one : found) result.push_back({one, {{page.object_names[0], one.pixels}}});
  return result;
}

void add_words(ReportPage& page, std::uint64_t unexplained_pixels) {
  page.title = "refraster verify hello.json actual.png";
  page.tone = PageTone::failed;
  page.headline = with_commas(unexplained_pixels) + " pixels are unexplained";
  page.summary = {"Most likely: Phong in place of Blinn-Phong, which explains 99.6 % of them."};
  page.power = "Of all pixels 61 % are bounded to less than 0.1 level, 97 % to less than 1, 99 % to less than 4.";
  const std::uint64_t left = unexplained_pixels / 256;
  page.hypotheses = {{"Phong in place of Blinn-Phong",
                      0.996,
                      unexplained_pixels,
                      left,
                      "Tried on 4,096 unexplained pixels and as many others, of which it makes none unexplained.",
                      {}},
                     {"the light direction is not normalised",
                      0.31,
                      unexplained_pixels,
                      unexplained_pixels * 69 / 100,
                      "Makes 212 explained pixels unexplained.",
                      {}},
                     {"radiance is not applied", 0.042, unexplained_pixels, unexplained_pixels * 958 / 1000, "", {}}};
  page.tables = {{"Bias and variance",
                  "Of actual − reference, in levels.",
                  {"material", "pixels", "bias", "variance"},
                  {{"knot", "61,204", "+0.013", "0.21"}, {"plane <&\">", "199,996", "−0.002", "0.19"}}},
                 {"How well pixels are bounded",
                  "Width of the bound, in levels.",
                  {"narrower than", "pixels"},
                  {{"0.1", "61.3 %"}, {"1", "97.0 %"}, {"4", "99.4 %"}}}};
  page.provenance = {{"scene", "hello.json"},
                     {"scene sha256", "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"},
                     {"actual", "actual.png"},
                     {"device profile", "llvmpipe, version 1"},
                     {"driver", "llvmpipe (LLVM 15.0.6, 256 bits)"},
                     {"refraster", this_build().version}};
}

} // namespace

ReportPage sample_page(const Scene& scene, int width, int height, SampleImages images) {
  const Frame right = rendered(scene, width, height), wrong = rendered(with_phong(scene), width, height);
  ReportPage page;
  page.reference.source = "hello.json, precision double";
  page.actual.source = "actual.png";
  page.reference.rgb8 = right.rgb8;
  page.actual.rgb8 = wrong.rgb8;
  for (const auto& [name, meaning] : kinds)
    page.classes.push_back({std::string(name), verdict_colours[page.classes.size()], std::string(meaning)});
  for (const Object& object : scene.objects) page.object_names.push_back(object.name);
  page.objects = ids_of(right.aovs[0]);
  page.triangles = ids_of(right.aovs[1]);
  page.class_map = Image<std::uint8_t>(width, height, 1);
  page.bound_width = Image<float>(width, height, 1);
  Image<std::uint8_t> marked(width, height, 1);
  Image<double> differences(width, height, 1);
  std::uint64_t unexplained_pixels = 0;

  Random random(7);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* const r = right.rgb8.at(x, y);
      std::uint8_t* const a = page.actual.rgb8.at(x, y);
      int largest = 0;
      Kind kind = rare_kind(random);
      for (int c = 0; c < 3; ++c) {
        const DeviceLevel device = device_level(wrong.radiance.at(x, y)[c], random);
        a[c] = device.level;
        kind = std::max(kind, device.kind);
        largest = std::max(largest, std::abs(a[c] - r[c]));
      }
      if (largest > 1) kind = unexplained;
      else if (at_edge(page.objects, x, y)) kind = edge;
      *page.class_map.at(x, y) = kind;
      *differences.at(x, y) = largest;
      *marked.at(x, y) = kind == unexplained;
      const float steep = kind == edge ? 40.0F : 0.02F + 0.9F * static_cast<float>(r[0]) / 255;
      *page.bound_width.at(x, y) = kind == undefined ? std::numeric_limits<float>::quiet_NaN() : steep;
      if (kind != unexplained) continue;
      ++unexplained_pixels;
      PageInterval interval{x, y};
      for (std::size_t c = 0; c < 3; ++c)
        interval.low[c] = static_cast<float>(r[c]) - 0.6F - steep / 2,
        interval.high[c] = static_cast<float>(r[c]) + 0.6F + steep / 2;
      page.allowed.push_back(interval);
      if (unexplained_pixels % 16 == 1)
        page.notes.push_back(
            {x, y, {{"sample shift", 0.61}, {"pow", 0.3}, {"normalize", 0.07}, {"others", 0.02}}, story(x, y, r, a)});
    }
  }
  page.clusters = named_clusters(marked, differences, page);
  page.cluster_count = clusters_of(marked, differences).size();
  add_words(page, unexplained_pixels);
  page.hypotheses[0].image = {.label = "with Phong", .source = "hello.json, Phong", .rgb8 = wrong.rgb8};
  if (images == SampleImages::values) {
    page.reference.rgb8 = {}, page.actual.rgb8 = {}, page.hypotheses[0].image = {};
    page.reference.values = right.radiance, page.actual.values = wrong.radiance;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < std::min(width, 12); ++i) *page.actual.values.at(i, height / 2) = nan;
  }
  return page;
}

} // namespace refraster::test
