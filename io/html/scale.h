#pragma once
// From values to places on an axis.

#include <string>
#include <vector>

namespace refraster {

/// A mark on an axis: where, and what is written there ("" for a line without a number).
struct Tick {
  double value;
  std::string label;
};

/// Values from..to lie at pixels a..b; either way round.
class Scale {
public:
  enum class Kind {
    linear,
    whole, // linear, with marks at whole numbers only
    logarithmic
  };

  /// Covers least..most, and the round numbers around them; 1..2 if they are no range. Logarithmic: both > 0.
  static Scale around(Kind kind, double least, double most, double a, double b);

  double operator()(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  double from() const { return from_; }
  double to() const { return to_; }

private:
  Kind kind_ = Kind::linear;
  double from_ = 0, to_ = 1, a_ = 0, b_ = 1;
  std::vector<Tick> ticks_;
};

} // namespace refraster
