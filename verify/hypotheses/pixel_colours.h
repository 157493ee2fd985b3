#pragma once
// The colour of a pixel as any hypothesis has it.

#include "verify/hypotheses/prepared.h"
#include "verify/hypotheses/reflection.h"
#include "verify/hypotheses/surface.h"
#include "verify/hypotheses/views.h"
#include "verify/hypotheses/window_geometry.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace refraster::hypotheses {

/// What is the same for all pixels.
struct Setting {
  const Scene& scene; // the right one
  const Prepared& prepared;
  Transfer transfer;
  double scale;              // of Output::scaled
  std::vector<bool> suspect; // by object: those that a hypothesis changes
  bool background_suspect = false;
};

/// No object.
inline constexpr std::uint32_t no_object = ~0u;

/// What is seen of those that cover a sample; nothing where it is the background.
std::optional<Covering> seen_of(std::span<const Covering> covering, const Scene& scene, const Steps& steps);

/// A pixel of one view. For one thread.
class PixelColours {
public:
  /// Places that a device's rounding of vertices may show instead: the right one, and four a lattice step beside it.
  static constexpr int alternatives = 5;

  /// covering: those of each alternative, tap by tap.
  PixelColours(const Setting& setting, const WindowGeometry& geometry, std::span<const Tap> taps,
               std::span<const std::vector<Covering>> covering)
      : setting_(setting), geometry_(geometry), taps_(taps), covering_(covering) {}

  /// Whether it shows other triangles than the first alternative.
  bool differs(const Steps& steps, int alternative) const;

  /// In stored values, not cut off. dx, dy: how far it is moved, in subpixels.
  Double3 stored(const Steps& steps, int alternative, const Nudge& nudge = {}, double dx = 0, double dy = 0);

  /// The object at the first tap.
  std::uint32_t object(const Steps& steps) const;

  /// Whether any suspect object that is seen has a texture with mip levels.
  bool has_mip_levels(const Steps& steps) const;

private:
  std::optional<Covering> seen(const Steps& steps, int alternative, std::size_t tap) const {
    return seen_of(covering_[static_cast<std::size_t>(alternative) * taps_.size() + tap], setting_.scene, steps);
  }
  const Material& material_of_covering(const Covering& covering) const;
  SampleData<double>& data_of(std::uint32_t triangle);
  Rgb<double> linear(const Covering& covering, const Tap& tap, const Steps& steps, const Nudge& nudge, double dx,
                     double dy);

  const Setting& setting_;
  const WindowGeometry& geometry_;
  std::span<const Tap> taps_;
  std::span<const std::vector<Covering>> covering_;
  std::vector<std::pair<std::uint32_t, std::unique_ptr<SampleData<double>>>> data_;
};

} // namespace refraster::hypotheses
