#include "app/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace refraster {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

/// The number that the whole text is. from_chars takes no sign for an unsigned one, and no locale.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Exactly `count` whole numbers in [0, largest_side], and nothing else.
std::optional<std::vector<int>> numbers_from(std::string_view text, char separator, std::size_t count) {
  std::vector<int> numbers;
  for (const std::string_view part : split(text, separator)) {
    const std::optional<int> number = number_from<int>(part);
    if (!number || *number < 0 || *number > largest_side) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

} // namespace

std::optional<Size> size_from(std::string_view text) {
  const auto numbers = numbers_from(text, 'x', 2);
  if (!numbers || (*numbers)[0] < 1 || (*numbers)[1] < 1) return std::nullopt;
  return Size{(*numbers)[0], (*numbers)[1]};
}

std::optional<Crop> crop_from(std::string_view text) {
  const auto numbers = numbers_from(text, ',', 4);
  if (!numbers || (*numbers)[2] < 1 || (*numbers)[3] < 1) return std::nullopt;
  return Crop{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
}

std::optional<std::vector<Aov>> aovs_from(std::string_view text) {
  std::vector<Aov> aovs;
  for (const std::string_view name : split(text, ',')) {
    const auto* found = std::find(std::begin(aov_names), std::end(aov_names), name);
    if (found == std::end(aov_names)) return std::nullopt;
    const Aov aov = static_cast<Aov>(found - std::begin(aov_names));
    if (std::find(aovs.begin(), aovs.end(), aov) != aovs.end()) return std::nullopt;
    aovs.push_back(aov);
  }
  return aovs;
}

std::optional<Double3> reflectance_from(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> number = number_from<double>(part);
    if (!number || !(0 <= *number && *number <= 1)) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() == 1) return Double3(numbers[0]);
  if (numbers.size() == 3) return Double3(numbers[0], numbers[1], numbers[2]);
  return std::nullopt;
}

std::optional<double> distance_from(std::string_view text) {
  const std::optional<double> number = number_from<double>(text);
  return number && std::isfinite(*number) && *number >= 0 ? number : std::nullopt;
}

std::optional<std::uint64_t> count_from(std::string_view text) {
  return number_from<std::uint64_t>(text);
}

CLI::Option* add_list_option(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                             const std::vector<std::string>& choices, const std::string& description) {
  std::string form;
  for (const std::string& choice : choices) form += (form.empty() ? "" : "|") + choice;
  const auto fault = [choices, form](const std::string& given) {
    const bool known = std::find(choices.begin(), choices.end(), given) != choices.end();
    return known ? std::string() : "found \"" + given + "\", expected " + form;
  };
  return command.add_option(name, values, description)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name(form + ",…")
      ->check(CLI::Validator(fault, ""));
}

} // namespace refraster
