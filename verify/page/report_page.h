#pragma once
// A page for people: two images, what was found of them, and pixel by pixel why. Whoever has found something fills a
// ReportPage, and report_html() makes one HTML file of it. docs/report-page.md says how to read it.

#include <refraster/compare.h>
#include <refraster/image.h>

#include "verify/compare/cluster_objects.h"
#include "verify/compare/heat_image.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// How the headline looks: a check mark, a cross, or neither.
enum class PageTone { passed, failed, neutral };

/// An image as it is shown and read pixel by pixel. One of rgb8 and values is empty. Of 3 channels or more the first
/// three are red, green and blue; of 1 or 2 the first is grey. There is no alpha: what is a channel is a number.
struct PageImage {
  std::string label;                // a word or two: "reference"
  std::string source = {};          // where it is from: a file, a scene and a precision
  Image<std::uint8_t> rgb8 = {};    // levels
  Image<float> values = {};         // 1 is white; beyond 1, below 0, NaN and infinity are shown as what they are
  std::vector<std::string> names{}; // of channels; by default R G B, or Y of a single one

  int width() const { return rgb8.empty() ? values.width : rgb8.width; }
  int height() const { return rgb8.empty() ? values.height : rgb8.height; }
  int channels() const { return rgb8.empty() ? values.channels : rgb8.channels; }
  bool empty() const { return rgb8.empty() && values.empty(); }
};

/// A kind of pixels. The page has at most 256, from the least to the most severe: where an image is made smaller to be
/// shown, the last of the kinds under a point of the screen is seen. verdict_colours.h has colours for eleven.
struct PageClass {
  std::string name;
  Rgb8 colour{};
  std::string meaning = {}; // a sentence
};

/// What a pixel may be. A pixel may have several (each triangle that may be seen there has one): any of them will do.
struct PageInterval {
  int x = 0, y = 0;
  std::array<float, 3> low{}, high{}; // levels (1/255, also of an image of values), R G B; of grey the first counts
};

/// What is said of one pixel; at most one a pixel is shown.
struct PageNote {
  int x = 0, y = 0;
  std::vector<std::pair<std::string, double>> attribution = {}; // causes of the bound's width; fractions of 1
  std::string text = {};                                        // lines, shown as they are, in equal letters
};

/// A fault that may be the cause.
struct PageHypothesis {
  std::string text;                    // "normals are transformed by the model matrix"
  double explained = 0;                // fraction of the unexplained pixels that it explains
  std::uint64_t before = 0, after = 0; // unexplained pixels without and with it
  std::string detail = {};             // a sentence: where it was tried, what speaks against it
  PageImage image = {};                // what the reference is with this fault; may be empty
};

/// Pixels that lie together, and what is seen there.
struct PageCluster {
  Cluster where;
  ObjectCounts objects = {};
};

/// Any table: counts by class, bias and variance by material. The first column holds words, the others numbers.
struct PageTable {
  std::string title, about = {};
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// All that a page shows. What is empty is not shown, but for the two images. Per-pixel images have 1 channel and the
/// size of the two. Texts may hold anything: they are escaped.
struct ReportPage {
  std::string title = {};    // "verify torus.json"
  std::string headline = {}; // the verdict: "9,972 pixels are unexplained"
  PageTone tone = PageTone::neutral;
  std::vector<std::string> summary = {}; // a line each, below the headline
  std::string power = {};                // which share of the pixels is bounded how well: a line by the headline

  PageImage reference = {.label = "reference"}, actual = {.label = "actual"};

  std::vector<PageClass> classes = {};
  Image<std::uint8_t> class_map = {}; // of each pixel the index into classes

  Image<float> bound_width = {}; // levels, of the channel that is widest; NaN or infinity where there is no bound

  std::vector<std::string> object_names = {};
  Image<std::uint32_t> objects = {};   // of each pixel 1 + the index into object_names; 0: none
  Image<std::uint32_t> triangles = {}; // of each pixel 1 + the index in its object's mesh; 0: none

  std::vector<PageInterval> allowed = {}; // of some pixels, in any order
  std::vector<PageNote> notes = {};       // likewise

  std::vector<PageHypothesis> hypotheses = {}; // the best one first
  std::vector<PageCluster> clusters = {};      // the largest first; of how many: cluster_count
  std::uint64_t cluster_count = 0;
  std::vector<PageTable> tables = {};
  std::vector<std::pair<std::string, std::string>> provenance = {}; // "scene sha256", "driver" …, in this order
};

/// One file that needs nothing else: no network, no other file. The same page gives the same bytes. Takes some tens of
/// bytes a pixel while it works. Throws std::invalid_argument where the sizes of its images do not agree, or a number
/// of the page is beyond the list that it points into.
std::string report_html(const ReportPage& page);

} // namespace refraster
