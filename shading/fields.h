#pragma once
// How a fragment function declares its parameters: once, beside the member, with range and meaning. The scene reader,
// its error messages and the documentation all follow from that declaration.

#include <limits>
#include <string_view>

namespace refraster {

/// What a value may be: finite and min <= x <= max, each channel for a colour.
struct Range {
  double min = 0;
  double max = std::numeric_limits<double>::max();
};

/// A model declares each parameter by one call:
///     field("kd", kd, Range{}, "diffuse reflectance");
/// for Double3 (a colour), double, or an enum that has `enum_names` (a closed list of words).
/// Whether a parameter may be left out of a scene file is the third kind of call, `optional_field`.
template <class Enum>
struct EnumNames; // specialise: static constexpr std::pair<Enum, std::string_view> names[]

} // namespace refraster
