#include "verify/explain/story_text.h"

#include "io/file/number_text.h"
#include "io/file/text.h"
#include "verify/explain/fragment_text.h"
#include "verify/explain/story_table.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace refraster {
namespace {

using namespace story;

/// What a run report calls by a word, in a sentence.
constexpr std::array<std::string_view, static_cast<std::size_t>(Undefined::count_)> undefined_sentences = {
    "the interpolated normal is 0: the triangle's own normal is used",
    "the triangle has no normal either: ambient light only",
    "the camera is at the surface point: no direction to the eye, v = 0",
    "a light is at the surface point: no direction to it, it gives nothing",
    "l = -v: there is no half vector, and no highlight",
    "glossiness 0 and a cosine of 0: 0^0 counts as 1",
    "no table sample around the direction was ever measured: f counts as 0",
    "a channel overflows: the largest finite number; or it is NaN: 0",
    "a texture coordinate is NaN or infinite: it counts as 0"};

std::string point_text(double x, double y) {
  return "(" + general(x, 12) + ", " + general(y, 12) + ")";
}

std::string levels_text(const std::array<int, 3>& levels) {
  return right(std::to_string(levels[0]), 4) + right(std::to_string(levels[1]), 4) +
         right(std::to_string(levels[2]), 4);
}

std::string title(const PixelStory& s) {
  std::string text =
      sentence("Pixel (" + std::to_string(s.x) + ", " + std::to_string(s.y) + ") of " + std::to_string(s.width) + "x" +
                   std::to_string(s.height) + (s.samples > 1 ? ", " + std::to_string(s.samples) + " samples" : "") +
                   (s.scene.empty() ? "" : ", " + one_line(s.scene)),
               2);
  if (s.fragments.empty()) return text + "shows the background\n";
  if (s.samples == 1) {
    const FragmentStory& f = s.fragments.front();
    return text +
           sentence("shows " + object_text(f.of) + ", triangle " + std::to_string(f.of.triangle) + ", " + f.function,
                    2);
  }
  for (const FragmentStory& f : s.fragments)
    text += sentence("shows " + object_text(f.of) + ", triangle " + std::to_string(f.of.triangle) + ", " + f.function +
                         ", in " + counted(static_cast<std::size_t>(f.samples), "sample"),
                     2);
  if (s.background_samples > 0)
    text += "shows the background in " + counted(static_cast<std::size_t>(s.background_samples), "sample") + "\n";
  return text;
}

/// "1 knot", for a column.
std::string short_object_text(const NamedTriangle& of, std::size_t width) {
  std::string text = std::to_string(of.object) + " " + one_line(of.name);
  if (text.size() > width) text = text.substr(0, width - 2) + "..";
  return text;
}

std::string candidate_text(const CoveringTriangle& c) {
  std::string text = "  " + left(name_of(c.fate), 12) + left(short_object_text(c.of, 18), 19) +
                     right(std::to_string(c.of.triangle), 8) + " " + left(name_of(c.side), 5) +
                     right(fixed(c.depth, 8), 11);
  if (c.weights)
    for (const double weight : *c.weights) text += right(fixed(weight, 4), 7);
  return text + "\n";
}

constexpr std::string_view candidate_columns =
    "              object             triangle side       depth  weights of corners\n";

/// Of one sample.
std::string coverage_text(const PixelStory& s) {
  const SampleStory& sample = s.sample_stories.front();
  std::string text = heading("COVERAGE of the sample " + point_text(sample.x, sample.y) + ", from near to far");
  if (sample.candidates.empty()) return text + "  no triangle covers it\n";
  text += candidate_columns;
  for (const CoveringTriangle& candidate : sample.candidates) text += candidate_text(candidate);
  return text;
}

/// Of triangles that cover a sample, each once.
std::string opacity_text(const PixelStory& s) {
  std::string text;
  std::set<std::pair<std::uint32_t, std::uint32_t>> said;
  for (const SampleStory& sample : s.sample_stories)
    for (const CoveringTriangle& c : sample.candidates) {
      if (!c.opacity || !said.emplace(c.of.object, c.of.triangle).second) continue;
      const bool there = c.opacity->value >= c.opacity->threshold;
      text +=
          sentence("  " + object_text(c.of) + ", triangle " + std::to_string(c.of.triangle) + ": " +
                       general(c.opacity->value, 9) + (there ? ", not below" : ", below") + " the threshold, " +
                       general(c.opacity->threshold, 6) + (there ? ": it is there" : ": none of it is in this pixel"),
                   4);
    }
  return text.empty() ? text : heading("OPACITY at the pixel's centre") + text;
}

/// Of several samples: what each sees, and how many more triangles cover it.
std::string samples_text(const PixelStory& s) {
  std::string text = heading("COVERAGE of the samples: what each sees, and how many more triangles cover it");
  text += "  sample" + left("  at", 24) + left("", 19) + right("triangle", 8) + right("depth", 13) + right("more", 7) +
          "\n";
  for (std::size_t i = 0; i < s.sample_stories.size(); ++i) {
    const SampleStory& sample = s.sample_stories[i];
    const auto seen = std::find_if(sample.candidates.begin(), sample.candidates.end(),
                                   [](const CoveringTriangle& c) { return c.fate == CandidateFate::seen; });
    const bool found = seen != sample.candidates.end();
    text += "  " + left(std::to_string(i), 6) + "  " + left(point_text(sample.x, sample.y), 22);
    text += found ? left(short_object_text(seen->of, 18), 19) + right(std::to_string(seen->of.triangle), 8) +
                        right(fixed(seen->depth, 8), 13)
                  : left("background", 40);
    text += right(std::to_string(sample.candidates.size() - (found ? 1 : 0)), 7) + "\n";
  }
  return text;
}

std::string direction_text(const NearMiss& miss) {
  const auto part = [](double d, const char* after, const char* before) {
    return general(std::abs(d), 3) + (d >= 0 ? after : before);
  };
  return part(miss.dx, " to the right", " to the left") + ", " + part(miss.dy, " below", " above");
}

std::string background_text(const PixelStory& s) {
  std::string text = heading("BACKGROUND");
  const std::vector<CoveringTriangle>& here = s.sample_stories.front().candidates;
  text +=
      sentence(here.empty() ? "  No triangle of the scene covers the pixel's sample."
                            : "  The triangles above cover the pixel, but none is drawn there: culled as the object "
                              "asks for, cut out by their opacity, or cut off by a depth plane.",
               0);
  for (const NearMiss& miss : s.near_misses)
    text += sentence("  Near: " + object_text(miss.of) + ", triangle " + std::to_string(miss.of.triangle) + ", whose " +
                         "outline is " + general(std::hypot(miss.dx, miss.dy), 3) + " pixels away (" +
                         direction_text(miss) + ").",
                     2);
  if (s.near_misses.empty()) text += "  Nothing lies near: no other triangle is in view.\n";
  return text + row("background", s.background);
}

std::string resolve_text(const PixelStory& s) {
  std::string text = heading_rgb("PIXEL: the mean of " + std::to_string(s.samples) + " samples");
  for (const FragmentStory& f : s.fragments)
    text += row(std::to_string(f.samples) + " x " + object_text(f.of, 24), f.radiance);
  if (s.background_samples > 0) text += row(std::to_string(s.background_samples) + " x background", s.background);
  return text + row("mean", s.in(Precision::double_).radiance);
}

std::string precisions_text(const PixelStory& s) {
  const bool srgb = s.transfer == Transfer::srgb;
  std::string text = "\n" + left("PRECISION", 10) + right("red", 16) + right("green", 16) + right("blue", 16) +
                     right("levels", 11) + (srgb ? right("sRGB", 9) : "") + "\n";
  const PrecisionStory& reference = s.in(Precision::double_);
  for (const PrecisionStory& p : s.precisions) {
    text += left("  " + std::string(name_of(p.precision)), 10);
    for (int c = 0; c < 3; ++c) {
      const double off = p.radiance[c] - reference.radiance[c];
      const bool is_reference = &p == &reference;
      text += right(is_reference ? general(p.radiance[c], 12)
                    : off == 0   ? "same"
                                 : (off > 0 ? "+" : "") + general(off, 3),
                    16);
    }
    text += levels_text(p.levels) + (srgb ? levels_text(p.srgb) : "") + "\n";
  }
  return text + "  (float, fast and exact: how far they are from double)\n";
}

std::string undefined_text(const PixelStory& s) {
  UndefinedCounts all;
  for (const FragmentStory& f : s.fragments) all += f.undefined;
  std::string text;
  for (std::size_t i = 0; i < undefined_sentences.size(); ++i)
    if (const std::uint64_t count = all.counts[i]; count > 0)
      text +=
          sentence("  " + std::string(undefined_names[i]) + (count > 1 ? ", " + std::to_string(count) + " times" : "") +
                       ": " + std::string(undefined_sentences[i]),
                   2);
  return text.empty() ? "" : heading("UNDEFINED in the mathematics, and what is done") + text;
}

/// The number of fewest digits in a narrow range: "60", where 59.85 to 60.02 is right.
std::string simplest(double least, double most) {
  constexpr int all_digits = 17;
  const double middle = least + (most - least) / 2;
  for (int digits = 1; digits < all_digits; ++digits) {
    double rounded = 0;
    read_number(general(middle, digits), rounded);
    if (least <= rounded && rounded <= most) return general(rounded, all_digits - 2);
  }
  return general(middle, all_digits);
}

/// "0.213", "0.2 to 0.3", "0.9 or more".
std::string range_text(double least, double most) {
  if (std::isinf(most)) return general(least, 4) + " or more";
  if (std::isinf(least)) return general(most, 4) + " or less";
  constexpr double narrow = 0.05; // of the value: beyond, a single number would say too much
  if (most - least <= narrow * std::abs(least + most) / 2) return simplest(least, most);
  return general(least, 3) + " to " + general(most, 3);
}

std::string would_be_text(const WouldBe& w) {
  constexpr std::array<std::string_view, 3> channel_names = {"red", "green", "blue"};
  std::string text = w.what;
  if (w.kind == WouldBe::Kind::factor) {
    const bool times = text.ends_with(", times");
    text += (times ? " " : ": ") + range_text(w.least[0], w.most[0]);
    if (!times) text += " instead of " + general(w.now[0], 4);
  }
  if (w.kind == WouldBe::Kind::channels) {
    bool first = true;
    for (std::size_t c = 0; c < 3; ++c)
      if (w.differs[c]) {
        text += (first ? ": " : ", ") + std::string(channel_names[c]) + " " + range_text(w.least[c], w.most[c]) +
                " instead of " + general(w.now[c], 4);
        first = false;
      }
  }
  return text + (w.remark.empty() ? "" : " (" + w.remark + ")");
}

std::string actual_text(const PixelStory& s) {
  const ActualStory& a = *s.actual;
  std::string text = heading_rgb("ACTUAL");
  text += sentence("  " + one_line(a.path), 2);
  text += row("actual, levels of 1/255", a.levels);
  text += row("double, the same before rounding", a.levels - a.difference);
  text += row("difference", a.difference);
  if (a.same) return text + "  The actual value is what double rounds to: nothing is to be explained.\n";
  if (a.would_be.empty())
    return text + sentence("  No single term explains it: whichever is changed alone, it would have to be negative, or "
                           "beyond what it can be, in some channel.",
                           0);
  constexpr std::size_t most = 8;
  text += "  It would be right if one of these were so, and all else stayed as it is:\n";
  for (std::size_t i = 0; i < std::min(most, a.would_be.size()); ++i)
    text += sentence("  - " + would_be_text(a.would_be[i]), 2);
  if (a.would_be.size() > most)
    text += "  and " + std::to_string(a.would_be.size() - most) + " less likely ones; --json has them.\n";
  return text;
}

std::string bounds_text(const BoundsStory& b) {
  std::string text = heading_rgb("BOUNDS: what a correct device may have");
  text += row("at least", b.least) + row("at most", b.most);
  for (const BoundsStory::Cause& cause : b.causes) text += row(cause.what, general(100 * cause.fraction, 3) + " %");
  return text;
}

} // namespace

std::string story_text(const PixelStory& s, const StoryTextOptions& options) {
  std::string text = title(s) + (s.samples == 1 ? coverage_text(s) : samples_text(s)) + opacity_text(s);
  for (const FragmentStory& f : s.fragments) {
    if (s.fragments.size() > 1)
      text += heading("FRAGMENT " + object_text(f.of) + ", triangle " + std::to_string(f.of.triangle));
    text += fragment_text(f, options);
  }
  if (s.fragments.empty()) text += background_text(s);
  if (s.samples > 1) text += resolve_text(s);
  text += precisions_text(s) + undefined_text(s);
  if (s.bounds) text += bounds_text(*s.bounds);
  if (s.actual) text += actual_text(s);
  return text;
}

} // namespace refraster
