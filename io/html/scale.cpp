#include "io/html/scale.h"

#include "io/file/text.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

std::string superscript(int n) {
  const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = n < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(n))) text += digits[c - '0'];
  return text;
}

/// "0.01", "10", "10⁶".
std::string power_of_ten(int n) {
  if (n >= -3 && n <= 4) return format("%g", std::pow(10, n));
  return "10" + superscript(n);
}

/// 1, 2 or 5 times a power of ten, so that about `count` steps make up `length`.
double round_step(double length, int count) {
  const double raw = length / count, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw * 0.999) return factor * power;
  return 10 * power;
}

/// 1, 2 and 5 times all powers of ten from below `least` to above `most`; of those within, over many decades only the
/// powers of ten are kept, and every so many of them have numbers.
std::vector<Tick> logarithmic_ticks(double least, double most) {
  const int first = static_cast<int>(std::floor(std::log10(least))),
            last = static_cast<int>(std::ceil(std::log10(most)));
  const bool fine = last - first <= 3;
  const int every = 1 + (last - first - 1) / 8;
  std::vector<Tick> all;
  for (int decade = first; decade <= last; ++decade)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10, decade);
      std::string label;
      if (factor == 1 && (decade - first) % every == 0) label = power_of_ten(decade);
      if (factor != 1 && fine && decade >= -3 && decade <= 3) label = format("%g", value);
      all.push_back({value, label});
    }
  // A value that reaches beyond a mark by a few per cent does not need the next one.
  const auto begin = std::find_if(all.rbegin(), all.rend(), [&](const Tick& t) { return t.value <= least * 1.05; });
  const auto end = std::find_if(all.begin(), all.end(), [&](const Tick& t) { return t.value >= most / 1.05; });
  std::vector<Tick> ticks(begin == all.rend() ? all.begin() : begin.base() - 1, end == all.end() ? end : end + 1);
  if (ticks.size() < 2) ticks.push_back({ticks.front().value * 10, ""});
  if (fine) return ticks;
  const auto is_decade = [](const Tick& t) {
    return std::abs(std::log10(t.value) - std::round(std::log10(t.value))) < 1e-9;
  };
  // The ends stay: they are the ends of the axis.
  for (std::size_t i = ticks.size() - 1; i-- > 1;)
    if (!is_decade(ticks[i])) ticks.erase(ticks.begin() + static_cast<std::ptrdiff_t>(i));
  return ticks;
}

std::vector<Tick> linear_ticks(double least, double most, double smallest_step) {
  const double step = std::max(round_step(most - least, 5), smallest_step);
  const double first = std::floor(least / step + 1e-9), last = std::ceil(most / step - 1e-9);
  std::vector<Tick> ticks;
  for (double i = first; i <= std::max(last, first + 1); ++i) ticks.push_back({i * step, format("%g", i * step)});
  return ticks;
}

} // namespace

Scale Scale::around(Kind kind, double least, double most, double a, double b) {
  if (!(std::isfinite(least) && std::isfinite(most) && least <= most)) least = 1, most = 2; // nothing to be shown
  if (least == most && kind != Kind::logarithmic) most += std::max(std::abs(most), 1.0);
  Scale scale;
  scale.kind_ = kind;
  scale.a_ = a, scale.b_ = b;
  scale.ticks_ = kind == Kind::logarithmic ? logarithmic_ticks(least, most)
                                           : linear_ticks(least, most, kind == Kind::whole ? 1 : 0);
  scale.from_ = scale.ticks_.front().value;
  scale.to_ = scale.ticks_.back().value;
  return scale;
}

double Scale::operator()(double value) const {
  const double fraction =
      kind_ == Kind::logarithmic ? std::log(value / from_) / std::log(to_ / from_) : (value - from_) / (to_ - from_);
  return a_ + (b_ - a_) * fraction;
}

} // namespace refraster
