#pragma once
// The colours that shading makes of a tile's fragments.

#include "math/vec.h"
#include "raster/buffer.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace refraster {

/// The colours of a tile's fragments, in the order of fragment numbers: of lanes, a plane for each channel.
template <class T>
class FragmentColours {
public:
  using Real = RealOf<T>;
  static constexpr std::uint32_t lanes = NumberTraits<T>::lanes;

  /// Room for whole registers beyond the last fragment.
  void resize(std::uint32_t fragments) {
    fragments_ = fragments;
    for (Buffer<Real>& channel : channel_) channel.resize_uninitialized(fragments + lanes);
  }
  std::uint32_t fragments() const { return fragments_; }
  /// All lanes; beyond the last fragment of a group they hold nothing, and are overwritten by the next group.
  void store(std::uint32_t first, const Rgb<T>& rgb) {
    for (int c = 0; c < 3; ++c) std::memcpy(&channel_[static_cast<std::size_t>(c)][first], &rgb[c].v, sizeof rgb[c].v);
  }
  Rgb<T> load(std::uint32_t first) const {
    Rgb<T> rgb;
    for (int c = 0; c < 3; ++c) std::memcpy(&rgb[c].v, &channel_[static_cast<std::size_t>(c)][first], sizeof rgb[c].v);
    return rgb;
  }
  /// Whole registers: where others are reached, 0 is added to them as well.
  void add_zero(std::uint32_t first, std::uint32_t fragments) {
    for (std::uint32_t i = first; i < first + fragments; i += lanes) store(i, load(i) + Rgb<T>(T(0)));
  }
  Rgb<Real> operator[](std::uint32_t i) const { return {channel_[0][i], channel_[1][i], channel_[2][i]}; }
  void set(std::uint32_t i, const Rgb<Real>& rgb) {
    for (int c = 0; c < 3; ++c) channel_[static_cast<std::size_t>(c)][i] = rgb[c];
  }

private:
  std::uint32_t fragments_ = 0;
  std::array<Buffer<Real>, 3> channel_;
};

/// Of a number without lanes, one after the other.
template <class T>
  requires(!NumberTraits<T>::has_lanes)
class FragmentColours<T> {
public:
  using Real = T; // of a channel
  static constexpr std::uint32_t lanes = 1;

  void resize(std::uint32_t fragments) { rgb_.resize(fragments); }
  void store(std::uint32_t first, const Rgb<T>& rgb) { rgb_[first] = rgb; }
  void add_zero(std::uint32_t first, std::uint32_t fragments) {
    if constexpr (NumberTraits<T>::is_ieee) // others have no -0
      for (std::uint32_t i = first; i < first + fragments; ++i) rgb_[i] += Rgb<T>(T(0));
  }
  Rgb<T> operator[](std::uint32_t i) const { return rgb_[i]; }
  void set(std::uint32_t i, const Rgb<T>& rgb) { rgb_[i] = rgb; }

private:
  std::vector<Rgb<T>> rgb_;
};

} // namespace refraster
