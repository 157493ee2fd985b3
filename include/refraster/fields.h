#pragma once
// How fragment functions and lights declare their parameters: once, beside the member, with range and meaning. The
// scene reader, its error messages and the documentation all follow from that declaration.

#include <refraster/vector.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace refraster {

/// Whether the ends of a range belong to it.
enum class Ends { included, excluded };

/// Whether the vector of length 0 belongs to a range.
enum class Zero { included, excluded };

/// Whether a scene file must have a key.
enum class Need { required, optional };

/// What a number may be: finite, and from min to max; each channel for a colour, each coordinate for a vector.
struct Range {
  double min = 0;                                  ///< the least
  double max = std::numeric_limits<double>::max(); ///< the greatest
  Ends ends = Ends::included;                      ///< whether those two belong to it
  Zero zero = Zero::included;                      ///< for a vector: whether it may have no direction
  Need need = Need::required;                      ///< of a fragment function's colour or number

  /// False for NaN.
  constexpr bool contains(double x) const { return ends == Ends::included ? min <= x && x <= max : min < x && x < max; }
};

/// Every finite number.
inline constexpr Range any_number{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

/// Every vector that has a direction, at any length.
inline constexpr Range any_direction{any_number.min, any_number.max, Ends::included, Zero::excluded};

/// The words that stand for the values of an enum in a scene file. Specialise beside the enum, one line a value:
///     static constexpr std::pair<Enum, std::string_view> names[] = {{Enum::a, "a"}, …};
/// The words "true" and "false" stand for the JSON literals.
template <class Enum>
struct EnumNames;

/// An enumeration whose values have names.
template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires {
  EnumNames<Enum>::names;
};

/// The name of a value; empty of what is none of the listed.
template <NamedEnum Enum>
constexpr std::string_view name_of(Enum value) {
  for (const auto& [listed, name] : EnumNames<Enum>::names)
    if (listed == value) return name;
  return {};
}

/// The value of this name; nothing if there is none.
template <NamedEnum Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
  for (const auto& [value, listed] : EnumNames<Enum>::names)
    if (listed == name) return value;
  return std::nullopt;
}

// A fragment function, or a type of light, declares each parameter in its function `fields`, by one call:
//     field("kd", self.kd, Range{}, "diffuse reflection, r g b");
// for a Double3 (a colour), a double, or a named enum. A scene must give every colour and number whose range does not
// say that it is optional; an enum, which chooses between conventions, may be left out. What is left out keeps the
// value that the member has from the start.

/// An enum whose type is not known here: the words for its values, and which of them it is.
struct NamedValue {
  std::vector<std::string_view> names = {}; ///< in the order of the enum
  std::size_t index = 0;                    ///< of the value
};

/// Is shown the parameters of a fragment function whose type is not known here, one by one, as `fields` declares them,
/// and may change their values.
class FieldVisitor {
public:
  virtual ~FieldVisitor() = default;
  /// A number.
  virtual void field(std::string_view name, double& value, const Range& range, std::string_view meaning) = 0;
  /// A colour or a vector; the range is that of each component.
  virtual void field(std::string_view name, Double3& value, const Range& range, std::string_view meaning) = 0;
  /// A choice. The index must stay below the number of names.
  virtual void field(std::string_view name, NamedValue& value, const Range& range, std::string_view meaning) = 0;
};

} // namespace refraster
