#include "shading/srgb_curve.h"
#include "verify/transformations/scale_factor.h"
#include "verify/transformations/undoing.h"
#include "verify/transformations/whole_pixel_shift.h"

#include <cassert>

namespace refraster {
namespace {

/// Linear from the curve's values, both in levels.
double without_srgb_curve(double levels) {
  return 255 * srgb_decoded(levels / 255);
}

/// ITU-R BT.709: black at 16, white at 235.
double in_video_range(double levels) {
  return 16 + levels * 219 / 255;
}

/// Tries them all, and keeps the best.
class Finder {
public:
  Finder(const StoredImage& a, const StoredImage& b, const Image<float>& alpha, double limit)
      : a_(a), b_(b), alpha_(alpha), limit_(limit) {}

  std::optional<FoundTransformation> find() {
    const int width = a_.image.width, height = a_.image.height, channels = a_.image.channels;
    try_values(Transformation::srgb_curve_added, b_, a_, without_srgb_curve);
    try_values(Transformation::srgb_curve_missing, a_, b_, without_srgb_curve);
    try_out(Transformation::upside_down, b_, a_, [&](int x, int y, int c) { return b_.levels(x, height - 1 - y, c); });
    try_out(Transformation::mirrored, b_, a_, [&](int x, int y, int c) { return b_.levels(width - 1 - x, y, c); });
    if (channels >= 3)
      try_out(Transformation::red_blue_exchanged, b_, a_, [&](int x, int y, int c) {
        return b_.levels(x, y, c == 0 ? 2 : c == 2 ? 0 : c);
      });
    for (const PixelShift& shift : likely_shifts(a_, b_, limit_)) try_shift(shift);
    if (!alpha_.empty()) {
      try_alpha(Transformation::premultiplied, a_, b_);
      try_alpha(Transformation::unpremultiplied, b_, a_);
    }
    try_values(Transformation::video_range, a_, b_, in_video_range);
    try_values(Transformation::video_range_removed, b_, a_, in_video_range);
    try_scale();
    return found_;
  }

private:
  void consider(Transformation which, const Judgement& judgement, double factor = 1, PixelShift shift = {}) {
    if (!judgement.convinces() || (found_ && !judgement.better_than(best_))) return;
    best_ = judgement;
    found_ = found_transformation(which, judgement);
    found_->factor = factor;
    found_->x = shift.x, found_->y = shift.y;
  }

  template <class Undo>
  void try_out(Transformation which, const StoredImage& undone, const StoredImage& other, Undo&& undo) {
    consider(which, judge(known(which), undone, other, limit_, undo));
  }

  /// A map of each colour by itself; a fourth channel is alpha.
  template <class Map>
  void try_values(Transformation which, const StoredImage& undone, const StoredImage& other, Map&& map,
                  double factor = 1) {
    const int colours = undone.image.channels == 4 ? 3 : undone.image.channels;
    consider(which,
             judge(known(which), undone, other, limit_,
                   [&](int x, int y, int c) {
                     const double levels = undone.levels(x, y, c);
                     return c < colours ? map(levels) : levels;
                   }),
             factor);
  }

  void try_alpha(Transformation which, const StoredImage& undone, const StoredImage& other) {
    try_out(which, undone, other, [&](int x, int y, int c) {
      const double levels = undone.levels(x, y, c);
      return c < 3 ? levels * static_cast<double>(*alpha_.at(x, y)) : levels;
    });
  }

  void try_shift(const PixelShift& shift) {
    const int width = a_.image.width, height = a_.image.height;
    const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < width && y < height; };
    // Pixel (x, y) of a lies at (x + shift.x, y + shift.y) of b.
    consider(Transformation::shifted,
             judge(
                 known(Transformation::shifted), b_, a_, limit_,
                 [&](int x, int y, int c) { return b_.levels(x + shift.x, y + shift.y, c); },
                 [&](int x, int y) { return inside(x + shift.x, y + shift.y); },
                 [&](int x, int y) { return inside(x - shift.x, y - shift.y); }),
             1, shift);
  }

  void try_scale() {
    const double factor = scale_factor(a_, b_);
    if (!(factor > 0) || factor == 1) return;
    const bool darker = factor < 1;
    const double shrink = darker ? factor : 1 / factor;
    try_values(
        Transformation::scaled, darker ? a_ : b_, darker ? b_ : a_, [&](double levels) { return levels * shrink; },
        factor);
  }

  const StoredImage &a_, &b_;
  const Image<float>& alpha_;
  const double limit_;
  std::optional<FoundTransformation> found_;
  Judgement best_;
};

} // namespace

std::optional<FoundTransformation> find_transformation(const StoredImage& a, const StoredImage& b,
                                                       const Image<float>& alpha, double limit) {
  assert(a.image.width == b.image.width && a.image.height == b.image.height);
  assert(a.image.channels == b.image.channels);
  return Finder(a, b, alpha, limit).find();
}

} // namespace refraster
