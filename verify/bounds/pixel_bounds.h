#pragma once
// What a device may make of one pixel of one triangle: the product's own formulas on bounds.

#include "verify/bounds/device_triangle.h"

#include <refraster/frame.h>

#include <array>
#include <memory>
#include <string_view>

namespace refraster {

/// What makes a device's colours differ, apart: each can be left out, so that its share is seen. Without `shadows`
/// comparisons with shadow maps that a device may decide either way go as the reference's.
enum class BoundCause : std::uint8_t {
  sample_shift,
  interpolation,
  texture,
  level_of_detail,
  powers,
  arithmetic,
  shadows,
  count_
};
inline constexpr std::array<std::string_view, static_cast<std::size_t>(BoundCause::count_)> bound_cause_names = {
    "sample shift", "interpolation", "texture filter", "level of detail", "pow", "arithmetic", "shadow maps"};

/// A set of causes.
class BoundCauses {
public:
  static constexpr BoundCauses all() { return BoundCauses((1u << static_cast<unsigned>(BoundCause::count_)) - 1); }
  static constexpr BoundCauses only(BoundCause cause) { return BoundCauses(1u << static_cast<unsigned>(cause)); }
  constexpr BoundCauses without(BoundCause cause) const { return BoundCauses(set_ & ~only(cause).set_); }
  constexpr bool has(BoundCause cause) const { return (set_ & only(cause).set_) != 0; }

private:
  explicit constexpr BoundCauses(unsigned set) : set_(set) {}
  unsigned set_;
};

/// From lo to hi in each channel: linear, unclamped values.
struct ColourBox {
  Double3 lo{0}, hi{0};

  bool is_finite() const;
  /// The widest channel.
  double width() const;
};

/// What bounds say of a pixel.
struct PixelBounds {
  ColourBox colour;
  bool open = false;      // a comparison that they leave open was met: the box holds both sides
  bool undefined = false; // a case that the mathematics leaves undefined may be met
};

/// The opacity that a device may read of a triangle whose material has cut-outs, for pixel (x, y): as PixelBounder has
/// its other textures. Infinite where nothing is known. Sets the device's arithmetic of the thread that calls.
ValueRange opacity_bounds(const DeviceFrame& frame, const DeviceTriangle& triangle, int x, int y);

/// Evaluates pixels of a frame one by one; holds scratch memory: one for each thread. Sets the device's arithmetic of
/// the thread that calls.
class PixelBounder {
public:
  explicit PixelBounder(const DeviceFrame& frame);
  ~PixelBounder();
  PixelBounder(const PixelBounder&) = delete;
  PixelBounder& operator=(const PixelBounder&) = delete;

  /// The triangle's colour at pixel (x, y), shaded at its centre. Infinite where nothing is known: a triangle that has
  /// no area on our lattice, a fragment function of one's own.
  PixelBounds bounds(const DeviceTriangle& triangle, int x, int y, BoundCauses causes = BoundCauses::all());

  /// The same, open comparisons followed each way for itself: visit(bounds) for each, until it returns true. Returns
  /// whether it did. `complete` tells whether all ways were followed; if not, visit has seen their joint bounds last.
  template <class Visit>
  bool for_each_path(const DeviceTriangle& triangle, int x, int y, const Visit& visit,
                     BoundCauses causes = BoundCauses::all());

private:
  struct Scratch;
  const DeviceFrame& frame_;
  std::unique_ptr<Scratch> scratch_;
};

template <class Visit>
bool PixelBounder::for_each_path(const DeviceTriangle& triangle, int x, int y, const Visit& visit, BoundCauses causes) {
  bool complete = true;
  {
    Forks forks;
    do {
      if (visit(bounds(triangle, x, y, causes))) return true;
    } while (forks.next());
    complete = forks.is_complete();
  }
  return !complete && visit(bounds(triangle, x, y, causes));
}

} // namespace refraster
