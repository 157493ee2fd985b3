#include "brdf/fit/parameters.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr double min_width = 1e-4, max_width = 1e6;

/// What further lobes leave to the first: the ground, and how much of it is seen.
bool is_of_ground(std::string_view name) {
  return name == "kd" || name == "albedo" || name == "metallic" || name == "ior";
}

/// Metal and a higher refractive index both make the highlight of a ground stronger, and of a grey one nothing tells
/// them apart. So one of them is fitted: the index where the start has no metal at all, else the fraction that is
/// metal, with the index that the start has.
template <class Block>
std::string_view fixed_parameter(const Block& block) {
  if constexpr (std::is_same_v<Block, Microfacet>) return block.metallic == 0 ? "metallic" : "ior";
  return {};
}

FitScale scale_of(std::string_view name) {
  return name == "metallic" ? FitScale::fraction : FitScale::width;
}

Range fitted_range(const Range& range, FitScale scale) {
  return {std::max(range.min, min_width), scale == FitScale::width ? std::min(range.max, max_width) : range.max};
}

/// Calls use(lobe, name, value, range, scale) for each number that is fitted.
template <class Lobes, class Use>
void for_each_number(Lobes& lobes, const Use& use) {
  for (std::size_t k = 0; k < lobes.size(); ++k)
    std::visit(
        [&](auto& block) {
          const std::string_view fixed = fixed_parameter(block);
          block.fields(block,
                       [&]<class Value>(std::string_view name, Value& value, const Range& range, std::string_view) {
                         if (name == fixed || !is_of_f(block, name) || (k > 0 && is_of_ground(name))) return;
                         if constexpr (std::is_same_v<std::remove_const_t<Value>, Double3>) {
                           for (int c = 0; c < 3; ++c)
                             use(k, std::string(name) + "." + "rgb"[c], value[c], range, FitScale::channel);
                         } else if constexpr (std::is_same_v<std::remove_const_t<Value>, double>) {
                           const FitScale scale = scale_of(name);
                           use(k, std::string(name), value, fitted_range(range, scale), scale);
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

double to_unbounded(double value, const Range& range, FitScale scale) {
  if (scale == FitScale::width)
    return from_fraction(std::log(std::max(value, range.min) / range.min) / std::log(range.max / range.min));
  if (has_two_ends(range)) return from_fraction((value - range.min) / (range.max - range.min));
  const double above = std::max(value - range.min, 1e-6) + 1;
  return std::sqrt(above * above - 1);
}

double from_unbounded(double u, const Range& range, FitScale scale) {
  if (scale == FitScale::width)
    return std::clamp(range.min * std::pow(range.max / range.min, to_fraction(u)), range.min, range.max);
  if (has_two_ends(range)) return range.min + (range.max - range.min) * to_fraction(u);
  return range.min + (u * u) / (std::sqrt(u * u + 1) + 1); // sqrt(u^2 + 1) - 1
}

} // namespace

bool FitParameter::is_at_end() const {
  constexpr double near = 1e-3;
  if (scale == FitScale::width) {
    const double all = std::log(range.max / range.min), at = std::log(value / range.min);
    return at < near * all || at > (1 - near) * all;
  }
  // Black is no fault, nor is it one that all is metal, or nothing.
  return scale == FitScale::channel && has_two_ends(range) && value > range.max - near * (range.max - range.min);
}

std::vector<FitParameter> fit_parameters(const std::vector<BrdfModel>& lobes) {
  std::vector<FitParameter> parameters;
  for_each_number(lobes, [&](std::size_t lobe, std::string name, double value, const Range& range, FitScale scale) {
    parameters.push_back({lobe, std::move(name), value, range, scale});
  });
  return parameters;
}

std::vector<double> unbounded(const std::vector<FitParameter>& parameters) {
  std::vector<double> x;
  for (const FitParameter& p : parameters) x.push_back(to_unbounded(p.value, p.range, p.scale));
  return x;
}

std::vector<BrdfModel> with_unbounded(std::vector<BrdfModel> lobes, const std::vector<double>& x) {
  std::size_t k = 0;
  for_each_number(lobes, [&](std::size_t, const std::string&, double& value, const Range& range, FitScale scale) {
    value = from_unbounded(x[k++], range, scale);
  });
  return lobes;
}

} // namespace refraster
