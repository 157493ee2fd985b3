#pragma once
// How a fragment function declares its parameters: once, beside the member, with range and meaning. The scene reader,
// its error messages and the documentation all follow from that declaration.

#include <concepts>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

namespace refraster {

/// Whether the ends of a range belong to it.
enum class Ends { included, excluded };

/// What a number may be: finite, and from min to max; each channel for a colour, each coordinate for a vector.
struct Range {
  double min = 0;
  double max = std::numeric_limits<double>::max();
  Ends ends = Ends::included;

  /// False for NaN.
  constexpr bool contains(double x) const { return ends == Ends::included ? min <= x && x <= max : min < x && x < max; }
};

/// Every finite number.
inline constexpr Range any_number{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

/// The words that stand for the values of an enum in a scene file. Specialise beside the enum, one line a value:
///     static constexpr std::pair<Enum, std::string_view> names[] = {{Enum::a, "a"}, …};
/// The words "true" and "false" stand for the JSON literals.
template <class Enum>
struct EnumNames;

template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires {
  EnumNames<Enum>::names;
};

template <NamedEnum Enum>
constexpr std::string_view name_of(Enum value) {
  for (const auto& [listed, name] : EnumNames<Enum>::names)
    if (listed == value) return name;
  return {};
}

// A fragment function declares each parameter in its function `fields`, by one call:
//     field("kd", self.kd, Range{}, "diffuse reflection, r g b");
// for a Double3 (a colour), a double, or a named enum. A scene must give every colour and number; an enum, which
// chooses between conventions, may be left out and then keeps the value that the member has from the start.

} // namespace refraster
