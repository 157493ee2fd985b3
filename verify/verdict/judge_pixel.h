#pragma once
// One pixel that is not the reference rounded: what explains it.

#include "verify/bounds/candidates.h"
#include "verify/verdict/stored_value.h"

namespace refraster {

/// What is known of a pixel before it is looked at closely.
struct PixelCase {
  PixelPlace at;
  std::vector<const VisibleSet*> samples; // what each of them may show
  std::optional<std::uint32_t> ours;      // the triangle that the reference shows, by its number in the frame
  Double3 reference{0};                   // linear radiance
  Double3 actual{0};                      // in levels
  std::optional<std::uint32_t> shown;     // what the device says it shows: a triangle …
  bool shows_background = false;          // … or nothing
  std::optional<double> depth;            // what it says of that
};

/// For one thread.
class PixelJudge {
public:
  PixelJudge(const DeviceFrame& frame, const StoredValue& stored) : frame_(frame), stored_(stored), bounder_(frame) {}

  /// Fills in what is found, the objection and what is allowed, the latter in levels.
  JudgedDetail judge(const PixelCase& pixel);

private:
  /// What a surface may look like: a triangle, or nothing for the background.
  using Surface = std::optional<std::uint32_t>;

  bool is_within(const ColourBox& box, const PixelCase& pixel) const { return stored_.may_be(box, pixel.actual); }
  PixelBounds bounds_of(const Surface& surface, const PixelPlace& at, BoundCauses causes = BoundCauses::all());
  PixelClass by_own_surface(const PixelCase& pixel, std::uint32_t number, JudgedDetail& detail);
  PixelClass by_own_surface(const PixelCase& pixel, std::uint32_t number, BoundCauses causes, JudgedDetail& detail);
  PixelClass by_other_surface(const PixelCase& pixel, JudgedDetail& detail);
  PixelClass by_samples(const PixelCase& pixel, JudgedDetail& detail);
  enum class Match {
    no,
    undefined, // by its depth; the mathematics leaves its colour undefined
    yes,
  };
  Match match(const PixelCase& pixel, const Surface& surface);
  bool matches_ids(const PixelCase& pixel, const Surface& surface) const;
  bool matches_depth(const PixelCase& pixel, const Surface& surface) const;
  ColourBox in_levels(const ColourBox& box) const;

  const DeviceFrame& frame_;
  const StoredValue& stored_;
  PixelBounder bounder_;
};

} // namespace refraster
