// soak [--scenes N] [--first SEED]: renders N random scenes in many ways, and requires the laws of each. Ends at the
// first that is broken, with its seed. Prints what was rendered.

#include "tests/support/invariants.h"
#include "tests/support/scenes/random_scene.h"
#include "verify/explain/explain_pixel.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {
using namespace refraster;
using namespace refraster::test;

struct Sums {
  std::uint64_t frames = 0, pixels = 0, triangles = 0, drawn = 0, fragments = 0, undefined = 0;
};

std::uint64_t seed_now = 0;

void require(const std::string& fault, const char* law) {
  if (fault.empty()) return;
  std::fprintf(stderr, "soak --first %llu --scenes 1: %s: %s\n", static_cast<unsigned long long>(seed_now), law,
               fault.c_str());
  std::exit(1);
}

template <class Value>
bool is_part(const Image<Value>& part, const Image<Value>& whole, const PixelRect& crop) {
  for (int y = 0; y < crop.height; ++y)
    if (std::memcmp(part.at(0, y), whole.at(crop.x, crop.y + y),
                    static_cast<std::size_t>(crop.width * whole.channels) * sizeof(Value)) != 0)
      return false;
  return true;
}

std::string crop_fault(const Frame& part, const Frame& whole, const PixelRect& crop) {
  if (!is_part(part.rgb8, whole.rgb8, crop)) return "levels";
  if (!is_part(part.radiance, whole.radiance, crop)) return "radiance";
  for (std::size_t i = 0; i < whole.aovs.size(); ++i)
    if (!is_part(part.aovs[i], whole.aovs[i], crop)) return "aov " + std::to_string(i);
  return "";
}

/// The image cut in four: each quarter is a part of the whole, and together they count what the whole counts.
void check_crops(const Scene& scene, const RenderOptions& options, const Frame& whole, Random& random, Sums& sums) {
  const int x = random.below(options.width), y = random.below(options.height);
  FrameCounts sum;
  for (const PixelRect& crop :
       {PixelRect{0, 0, x, y}, PixelRect{x, 0, options.width - x, y}, PixelRect{0, y, x, options.height - y},
        PixelRect{x, y, options.width - x, options.height - y}}) {
    if (crop.width == 0 || crop.height == 0) continue;
    RenderOptions cropped = options;
    cropped.crop = crop;
    const Frame part = render(scene, cropped);
    ++sums.frames;
    require(fault_of(part, scene, cropped), "a crop's invariants");
    require(crop_fault(part, whole, crop), "a crop is a part of the whole image");
    sum.pixels += part.counts.pixels;
    sum.shaded += part.counts.shaded;
    sum.fragments += part.counts.fragments;
    sum.undefined += part.counts.undefined;
  }
  const FrameCounts& all = whole.counts;
  require(sum.pixels == all.pixels && sum.shaded == all.shaded && sum.fragments == all.fragments ? "" : "fragments",
          "crops count what the whole counts");
  require(sum.undefined.counts == all.undefined.counts ? "" : "what is undefined", "crops count what the whole counts");
}

/// A pixel's story tells of the radiance that the frame has there.
void check_story(const Scene& scene, const RenderOptions& options, const Frame& whole, Random& random) {
  const int x = random.below(options.width), y = random.below(options.height);
  const PixelStory story =
      explain_pixel(scene, {x, y, options.width, options.height, options.samples, options.transfer});
  const Double3& told = story.in(options.precision).radiance;
  const float* const drawn = whole.radiance.at(x, y);
  for (int c = 0; c < 3; ++c)
    require(static_cast<float>(told[c]) == drawn[c] ? "" : "radiance", "a pixel is explained as it is in the frame");
}

void check_scene(std::uint64_t seed, Sums& sums) {
  seed_now = seed;
  Random random(seed);
  const Scene scene = random_scene(random);
  require(fault_of(scene), "the scene is valid");
  RenderOptions options = random_options(random);
  options.threads = 1;
  const Frame whole = render(scene, options);
  ++sums.frames;
  require(fault_of(whole, scene, options), "a frame's invariants");
  if (options.samples == 1) { // the sample is the pixel's centre, where the aovs are
    std::uint64_t seen = 0;
    for (const float index : whole.aovs[static_cast<std::size_t>(Aov::triangle)].values) seen += index > 0;
    require(seen == whole.counts.shaded ? "" : "pixels", "what is seen is shaded, and nothing else");
  }
  for (const int threads : {2, 3}) {
    RenderOptions other = options;
    other.threads = threads;
    other.tile_size = 8 << random.below(5);
    require(difference(render(scene, other), whole), "threads and tiles change nothing");
    ++sums.frames;
  }
  check_crops(scene, options, whole, random, sums);
  check_story(scene, options, whole, random);
  sums.pixels += whole.counts.pixels;
  sums.triangles += whole.counts.triangles;
  sums.drawn += whole.counts.drawn;
  sums.fragments += whole.counts.fragments;
  for (const std::uint64_t count : whole.counts.undefined.counts) sums.undefined += count;
}

std::uint64_t number(const char* word) {
  std::uint64_t value = 0;
  const char* const end = word + std::strlen(word);
  if (std::from_chars(word, end, value).ptr != end) {
    std::fprintf(stderr, "soak: not a number: %s\n", word);
    std::exit(2);
  }
  return value;
}

} // namespace

int main(int count, char** words) {
  std::uint64_t scenes = 100, first = 0;
  for (int i = 1; i < count; i += 2) {
    const std::string_view option = words[i];
    if (i + 1 == count || (option != "--scenes" && option != "--first")) {
      std::fprintf(stderr, "usage: soak [--scenes N] [--first SEED]\n");
      return 2;
    }
    (option == "--scenes" ? scenes : first) = number(words[i + 1]);
  }
  Sums sums;
  for (std::uint64_t seed = first; seed < first + scenes; ++seed) check_scene(seed, sums);
  const auto shown = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%llu scenes, %llu frames, %llu pixels, %llu triangles of which %llu drawn, %llu fragments, "
              "%llu undefined cases: every law holds\n",
              shown(scenes), shown(sums.frames), shown(sums.pixels), shown(sums.triangles), shown(sums.drawn),
              shown(sums.fragments), shown(sums.undefined));
}
