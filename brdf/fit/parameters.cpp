#include "brdf/fit/parameters.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr double min_width = 1e-4, max_width = 1e6;

bool is_diffuse(std::string_view name) {
  return name == "kd" || name == "albedo";
}

/// Calls use(lobe, name, value, range, is_width) for each number that is fitted.
template <class Lobes, class Use>
void for_each_number(Lobes& lobes, const Use& use) {
  for (std::size_t k = 0; k < lobes.size(); ++k)
    std::visit(
        [&](auto& block) {
          block.fields(block,
                       [&]<class Value>(std::string_view name, Value& value, const Range& range, std::string_view) {
                         if (name == "ka" || (k > 0 && is_diffuse(name))) return;
                         if constexpr (std::is_same_v<std::remove_const_t<Value>, Double3>) {
                           for (int c = 0; c < 3; ++c)
                             use(k, std::string(name) + "." + "rgb"[c], value[c], range, false);
                         } else if constexpr (std::is_same_v<std::remove_const_t<Value>, double>) {
                           const Range within{std::max(range.min, min_width), std::min(range.max, max_width)};
                           use(k, std::string(name), value, within, true);
                         }
                       });
        },
        lobes[k]);
}

bool has_two_ends(const Range& range) {
  return range.max < any_number.max;
}

/// Between 0 and 1, and back. At the ends the slope is 0: begin a little within.
double from_fraction(double fraction) {
  return std::asin(2 * std::clamp(fraction, 1e-6, 1 - 1e-6) - 1);
}
double to_fraction(double u) {
  return (std::sin(u) + 1) / 2;
}

double to_unbounded(double value, const Range& range, bool is_width) {
  if (is_width)
    return from_fraction(std::log(std::max(value, range.min) / range.min) / std::log(range.max / range.min));
  if (has_two_ends(range)) return from_fraction((value - range.min) / (range.max - range.min));
  const double above = std::max(value - range.min, 1e-6) + 1;
  return std::sqrt(above * above - 1);
}

double from_unbounded(double u, const Range& range, bool is_width) {
  if (is_width) return std::clamp(range.min * std::pow(range.max / range.min, to_fraction(u)), range.min, range.max);
  if (has_two_ends(range)) return range.min + (range.max - range.min) * to_fraction(u);
  return range.min + (u * u) / (std::sqrt(u * u + 1) + 1); // sqrt(u^2 + 1) - 1
}

} // namespace

bool FitParameter::is_at_end() const {
  constexpr double near = 1e-3;
  if (is_width) {
    const double all = std::log(range.max / range.min), at = std::log(value / range.min);
    return at < near * all || at > (1 - near) * all;
  }
  return has_two_ends(range) && value > range.max - near * (range.max - range.min); // black is no fault
}

std::vector<FitParameter> fit_parameters(const std::vector<BrdfModel>& lobes) {
  std::vector<FitParameter> parameters;
  for_each_number(lobes, [&](std::size_t lobe, std::string name, double value, const Range& range, bool is_width) {
    parameters.push_back({lobe, std::move(name), value, range, is_width});
  });
  return parameters;
}

std::vector<double> unbounded(const std::vector<FitParameter>& parameters) {
  std::vector<double> x;
  for (const FitParameter& p : parameters) x.push_back(to_unbounded(p.value, p.range, p.is_width));
  return x;
}

std::vector<BrdfModel> with_unbounded(std::vector<BrdfModel> lobes, const std::vector<double>& x) {
  std::size_t k = 0;
  for_each_number(lobes, [&](std::size_t, const std::string&, double& value, const Range& range, bool is_width) {
    value = from_unbounded(x[k++], range, is_width);
  });
  return lobes;
}

} // namespace refraster
