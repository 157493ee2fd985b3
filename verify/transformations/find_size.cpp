#include "verify/transformations/undoing.h"

namespace refraster {
namespace {

/// A side at half size: an odd one may be rounded either way.
bool is_half(int small, int large) {
  return small == large / 2 || small == (large + 1) / 2;
}

/// Holds the small image against the large one made small: by the mean of 2 x 2 pixels or by one of the four.
FoundTransformation judge_size(Transformation which, const StoredImage& large, const StoredImage& small, double limit) {
  FoundTransformation found{};
  found.which = which;
  if (large.image.channels != small.image.channels) return found;
  const auto has = [&](int x, int y) { return 2 * x + 1 < large.image.width && 2 * y + 1 < large.image.height; };
  const auto take = [&](const Judgement& judgement) {
    if (judgement.convinces()) found = found_transformation(which, judgement);
    return judgement.convinces();
  };
  const auto mean = [&](int x, int y, int c) {
    return (large.levels(2 * x, 2 * y, c) + large.levels(2 * x + 1, 2 * y, c) + large.levels(2 * x, 2 * y + 1, c) +
            large.levels(2 * x + 1, 2 * y + 1, c)) /
           4;
  };
  if (take(judge(known(which), large, small, limit, mean, has, has))) return found;
  for (const int corner : {0, 1, 2, 3}) {
    const auto one = [&](int x, int y, int c) { return large.levels(2 * x + corner % 2, 2 * y + corner / 2, c); };
    if (take(judge(known(which), large, small, limit, one, has, has))) return found;
  }
  return found;
}

} // namespace

std::optional<FoundTransformation> find_size_transformation(const StoredImage& a, const StoredImage& b, double limit) {
  // Of one pixel a half is one pixel too: only what has become smaller is half.
  const auto halved = [](const Image<float>& small, const Image<float>& large) {
    return is_half(small.width, large.width) && is_half(small.height, large.height) &&
           (small.width < large.width || small.height < large.height);
  };
  if (halved(b.image, a.image)) return judge_size(Transformation::half_size, a, b, limit);
  if (halved(a.image, b.image)) return judge_size(Transformation::double_size, b, a, limit);
  return std::nullopt;
}

} // namespace refraster
