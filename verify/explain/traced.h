#pragma once
// A number that remembers what was read from textures and tables to make it, and with which weight: so the product's
// own code says which texels a filter took, instead of a second copy of it.

#include "math/read_grid.h"
#include "math/scalar.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace refraster {

/// What was read, in order; a sample that is read twice is there twice. Of RgbGrid's values that begin at `grid`.
struct ReadLog {
  struct Read {
    const void* grid;
    std::int32_t i, j, k;
    bool operator==(const Read&) const = default;
  };
  std::vector<Read> reads;
};

/// A double with its derivatives by the values that were read, each named by its number in the log. Formulas that are
/// linear in what they read, as all filters are, have the weights as derivatives. For the operations that texture.h and
/// merl_lookup.h ask for.
class Traced {
public:
  using Weights = std::vector<std::pair<std::size_t, double>>; // by number, rising

  Traced() = default;
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit Traced(A x) : value_(static_cast<double>(x)) {}
  /// A place to read at: whatever is read there goes to `log`, which must outlive it.
  Traced(double x, ReadLog& log) : value_(x), log_(&log) {}
  /// A value that was read.
  Traced(double x, std::size_t number, ReadLog& log) : value_(x), weights_{{number, 1.0}}, log_(&log) {}

  double value() const { return value_; }
  const Weights& weights() const { return weights_; }
  ReadLog* log() const { return log_; }

  /// f(x) with its derivative there.
  Traced through(double f, double slope) const {
    Traced result = *this;
    result.value_ = f;
    for (auto& [number, weight] : result.weights_) weight *= slope;
    return result;
  }

  /// The same number, whose readings go where those at `other` go unless they have a log of their own.
  Traced in_place_of(const Traced& other) const {
    Traced result = *this;
    if (!result.log_) result.log_ = other.log_;
    return result;
  }

  friend Traced operator+(const Traced& a, const Traced& b) { return sum(a, 1, b, 1, a.value_ + b.value_); }
  friend Traced operator-(const Traced& a, const Traced& b) { return sum(a, 1, b, -1, a.value_ - b.value_); }
  friend Traced operator*(const Traced& a, const Traced& b) {
    return sum(a, b.value_, b, a.value_, a.value_ * b.value_);
  }
  friend Traced operator/(const Traced& a, const Traced& b) {
    return sum(a, 1 / b.value_, b, -a.value_ / (b.value_ * b.value_), a.value_ / b.value_);
  }
  friend Traced operator-(const Traced& a) { return a.through(-a.value_, -1); }
  Traced& operator+=(const Traced& b) { return *this = *this + b; }
  Traced& operator-=(const Traced& b) { return *this = *this - b; }
  Traced& operator*=(const Traced& b) { return *this = *this * b; }
  Traced& operator/=(const Traced& b) { return *this = *this / b; }

  friend bool operator<(const Traced& a, const Traced& b) { return a.value_ < b.value_; }
  friend bool operator>(const Traced& a, const Traced& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Traced& a, const Traced& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const Traced& a, const Traced& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Traced& a, const Traced& b) { return a.value_ == b.value_; }

private:
  /// a p + b q, as derivatives add up.
  static Traced sum(const Traced& a, double p, const Traced& b, double q, double value) {
    Traced result(value);
    result.log_ = a.log_ ? a.log_ : b.log_;
    auto i = a.weights_.begin();
    auto j = b.weights_.begin();
    while (i != a.weights_.end() || j != b.weights_.end()) {
      const bool of_a = j == b.weights_.end() || (i != a.weights_.end() && i->first <= j->first);
      const bool of_b = i == a.weights_.end() || (j != b.weights_.end() && j->first <= i->first);
      const std::size_t number = of_a ? i->first : j->first;
      double weight = 0;
      if (of_a) weight += p * (i++)->second;
      if (of_b) weight += q * (j++)->second;
      result.weights_.emplace_back(number, weight);
    }
    return result;
  }

  double value_ = 0;
  Weights weights_;
  ReadLog* log_ = nullptr;
};

/// An index that knows where its readings go.
struct TracedIndex {
  std::int32_t i = 0;
  ReadLog* log = nullptr;
};

inline namespace REFRASTER_KIT {

template <>
struct NumberTraits<Traced> {
  using Real = double;
  using Mask = bool;
  using Index = TracedIndex;
  static constexpr int lanes = 1;
  static constexpr bool has_lanes = false, decides = true, is_ieee = true;
  static constexpr double largest = NumberTraits<double>::largest;
};

} // namespace REFRASTER_KIT

/// One of two. It is a place to read at where either is: a coordinate that is clamped to a constant still is one.
inline Traced select(bool m, const Traced& x, const Traced& y) {
  return m ? x.in_place_of(y) : y.in_place_of(x);
}
inline Traced max(const Traced& x, const Traced& y) {
  return select(x > y, x, y);
}
inline Traced min(const Traced& x, const Traced& y) {
  return select(x < y, x, y);
}
inline Traced abs(const Traced& x) {
  return x < Traced(0) ? -x : x;
}
inline Traced square(const Traced& x) {
  return x * x;
}
inline Traced sqrt(const Traced& x) {
  const double root = std::sqrt(x.value());
  return x.through(root, root > 0 ? 0.5 / root : 0);
}
inline Traced exp2(const Traced& x) {
  const double f = std::exp2(x.value());
  return x.through(f, f * std::numbers::ln2);
}
inline Traced log2(const Traced& x) {
  return x.through(std::log2(x.value()), std::numbers::log2e / x.value());
}
inline Cell<Traced> floor_and_fraction(const Traced& x) {
  const Cell<double> at = floor_and_fraction(x.value());
  return {{at.index, x.log()}, x.through(at.fraction, 1)};
}
inline Traced fraction(const Traced& x) {
  return floor_and_fraction(x).fraction;
}
inline Traced reciprocal_binade(const Traced& x) {
  return Traced(reciprocal_binade(x.value()));
}
inline Traced exact_reciprocal(const Traced& x) {
  return Traced(exact_reciprocal(x.value()));
}
inline TracedIndex clamp_index(const TracedIndex& k, std::int32_t lo, std::int32_t hi) {
  return {clamp_index(k.i, lo, hi), k.log};
}
inline TracedIndex wrap_index(const TracedIndex& k, std::int32_t n) {
  return {wrap_index(k.i, n), k.log};
}
inline TracedIndex next_index(const TracedIndex& k) {
  return {k.i + 1, k.log};
}

/// Reads, and writes down that it did. A sample that was read before keeps its number.
template <class T, class F, class Value>
  requires std::same_as<T, Traced> Rgb<Traced> stored_value(const RgbGrid<F, Value>& grid, const TracedIndex& i,
                                                            const TracedIndex& j, const TracedIndex& k) {
    const Rgb<F> value = grid(i.i, j.i, k.i);
    const ReadLog::Read read{grid.values, i.i, j.i, k.i};
    ReadLog& log = *i.log;
    std::size_t number = 0;
    while (number < log.reads.size() && log.reads[number] != read) ++number;
    if (number == log.reads.size()) log.reads.push_back(read);
    const auto channel = [&](F x) { return Traced(static_cast<double>(x), number, log); };
    return {channel(value.x), channel(value.y), channel(value.z)};
  }

} // namespace refraster
