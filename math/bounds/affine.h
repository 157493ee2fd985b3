#pragma once
// The bounds number of verification: a range, and beside it how the number depends on the sample's shift and on the few
// roundings that many formulas share. What is subtracted from itself, or normalized and multiplied with itself, so
// stays as narrow as it is.

#include "math/bounds/affine_form.h"
#include "math/bounds/interval_functions.h"

namespace refraster::inline REFRASTER_KIT {

/// The symbols of a fragment. Those of position, normal and texture coordinates stand for a component each; the first
/// is named.
enum class Symbol : std::uint8_t {
  shift_x = 0,
  shift_y = 1,
  inverse_w = 2,
  position = 3,
  normal = 6,
  uv = 9,
  other = 11
};

/// What a formula may give, exactly or in the arithmetic of a rounding budget: a number of [lo, hi], and of the form.
/// Both are computed, and the range is never wider than an Interval's; infinite ends mean that nothing is known on that
/// side, and of the form then nothing either.
template <class Budget>
class Affine {
public:
  using Range = Interval<Budget>;

  AffineForm form;
  double lo = 0, hi = 0;

  Affine() = default;
  /// A number that every format holds, such as 0, 1/2 or 255. Parameters enter by as<T>().
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit(!std::same_as<A, double>) Affine(A x) : lo(static_cast<double>(x)), hi(lo) { form.centre = lo; }
  /// Any number of the range, with symbols of its own only.
  Affine(double low, double high) : lo(low), hi(high) {
    assert(low <= high);
    forget();
  }
  explicit Affine(Range range) : Affine(range.lo, range.hi) {}

  /// A number of which the form holds the exact value and `computed` the exact and the computed one, which differ by
  /// at most relative |exact| + absolute.
  Affine(const AffineForm& exact, Range computed, double relative, double absolute) : form(exact) {
    using namespace affine_detail;
    const double most = std::max(std::abs(computed.lo), std::abs(computed.hi));
    const double radius = exact.radius();
    const double size = std::min(most, upward(std::abs(exact.centre) + radius));
    const double error = relative == 0 && absolute == 0 ? 0 : upward(relative * size + absolute);
    if (error != 0) form.rest = upward(form.rest + error);
    narrow(computed, upward(radius + error));
  }
  static Affine computed(const AffineForm& exact, Range computed) {
    return Affine(exact, computed, Budget::relative, Budget::absolute);
  }
  static Affine exactly(const AffineForm& exact, Range range) { return Affine(exact, range, 0, 0); }

  /// centre + radius e, e being that symbol.
  static Affine along(Symbol symbol, double centre, double radius) {
    AffineForm form;
    form.centre = centre;
    form.slope[static_cast<std::size_t>(symbol)] = radius;
    using namespace interval_detail;
    return exactly(form, Range(step_down(centre - radius), step_up(centre + radius)));
  }

  Range range() const { return {lo, hi}; }
  bool contains(double x) const { return lo <= x && x <= hi; }
  double width() const { return hi - lo; }
  bool is_point() const { return lo == hi; }
  /// How far the number may be from its form's centre.
  double reach() const {
    using namespace interval_detail;
    return std::max(step_up(std::abs(hi - form.centre)), step_up(std::abs(form.centre - lo)));
  }

  static Affine anything() { return Affine(Range::anything()); }

  /// The same number, of which it is known that it lies in [low, high].
  Affine clipped(double low, double high) const {
    Affine result = *this;
    // Of a zero's two signs that of `low`: Interval's atan2.
    result.lo = std::min(lo > low ? lo : low, high), result.hi = std::min(hi > low ? hi : low, high);
    result.simplify();
    return result;
  }
  /// The same number: what only it depends on is called by a symbol, so that what is computed from it remembers. To be
  /// called for one number of a fragment only, and a symbol that none has yet. There may be no such symbol.
  Affine named(int symbol) const {
    const auto k = static_cast<std::size_t>(symbol);
    Affine result = *this;
    if (k >= AffineForm::symbols || !form.is_finite() || form.slope[k] != 0) return result;
    result.form.slope[k] = form.rest;
    result.form.rest = 0;
    return result;
  }
  /// As one rounding to another format makes of it.
  template <class Other>
  Affine<Other> rounded_to() const {
    if constexpr (std::same_as<Other, DoubleArithmetic>) return Affine<Other>::exactly(form, {lo, hi});
    else return Affine<Other>::computed(form, Interval<Other>::computed({lo, hi}));
  }
  /// With a relative error more.
  Affine widened(double relative) const { return Affine(form, range().widened(relative), relative, Budget::absolute); }

  friend Affine operator-(const Affine& a) {
    Affine result;
    result.form = scaled(a.form, -1, {0.0});
    result.form.rest = a.form.rest; // nothing was rounded
    result.lo = -a.hi, result.hi = -a.lo;
    return result;
  }
  friend Affine operator+(const Affine& a, const Affine& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return computed(sum(a.form, b.form, 1), a.range() + b.range());
  }
  friend Affine operator-(const Affine& a, const Affine& b) {
    if (b.is_zero()) return a;
    if (a.is_zero()) return -b;
    return computed(sum(a.form, b.form, -1), a.range() - b.range());
  }
  friend Affine operator*(const Affine& a, const Affine& b) {
    const Range range = a.range() * b.range();
    if (a.is_power_of_two()) return Affine(scaled(b.form, a.lo, {0.0}), range, 0, Budget::absolute);
    if (b.is_power_of_two()) return Affine(scaled(a.form, b.lo, {0.0}), range, 0, Budget::absolute);
    return computed(product(a.form, a.reach(), b.form, b.reach()), range);
  }
  /// a / b = q + (a - q b) / b, q being the quotient of the centres: what a and b have in common cancels in a - q b.
  friend Affine operator/(const Affine& a, const Affine& b) {
    const Range range = a.range() / b.range();
    if (b.contains(0) || !std::isfinite(range.width())) return Affine(range);
    if (b.is_power_of_two()) return Affine(scaled(a.form, 1 / b.lo, {0.0}), range, 0, Budget::absolute);
    const AffineForm reciprocal = reciprocal_form(b);
    const double q = a.is_point() ? 0 : a.form.centre / b.form.centre;
    if (!std::isfinite(q) || !reciprocal.is_finite()) return Affine(range);
    const AffineForm difference = a.is_point() ? a.form : combined(1, a.form, -q, b.form);
    const AffineForm rest = product(difference, difference.radius(), reciprocal, reciprocal.radius());
    return Affine(scaled(rest, 1, {q}), range, Budget::quotient_relative, Budget::absolute);
  }
  Affine& operator+=(const Affine& b) { return *this = *this + b; }
  Affine& operator-=(const Affine& b) { return *this = *this - b; }
  Affine& operator*=(const Affine& b) { return *this = *this * b; }
  Affine& operator/=(const Affine& b) { return *this = *this / b; }

  friend Certainty operator<(const Affine& a, const Affine& b) {
    if constexpr (requires { Budget::decided(Certainty::unknown); }) return Budget::decided(certainly_less(a, b));
    else return certainly_less(a, b);
  }
  /// What the numbers say: where they leave it open, so does this.
  friend Certainty certainly_less(const Affine& a, const Affine& b) {
    const Certainty by_range = a.range() < b.range();
    if (by_range != Certainty::unknown || !a.form.is_finite() || !b.form.is_finite()) return by_range;
    const AffineForm d = sum(a.form, b.form, -1);
    const double radius = d.radius();
    return d.centre < -radius ? Certainty::yes : d.centre >= radius ? Certainty::no : Certainty::unknown;
  }
  friend Certainty operator>(const Affine& a, const Affine& b) { return b < a; }
  friend Certainty operator<=(const Affine& a, const Affine& b) { return !(b < a); }
  friend Certainty operator>=(const Affine& a, const Affine& b) { return b <= a; }

private:
  template <class>
  friend class Affine;

  bool is_zero() const { return lo == 0 && hi == 0; }
  bool is_power_of_two() const {
    int exponent = 0;
    return is_point() && std::isfinite(lo) && std::abs(std::frexp(lo, &exponent)) == 0.5;
  }

  /// 1 / b, b being all positive or all negative: the chord from end to end lies above 1 / x for positive x, the
  /// tangent of the same slope, at the geometric mean, below.
  static AffineForm reciprocal_form(const Affine& b) {
    using affine_detail::Bounds;
    const auto value = [](double x) { return Bounds(1.0) / Bounds(x); };
    const double low = std::min(std::abs(b.lo), std::abs(b.hi)), high = std::max(std::abs(b.lo), std::abs(b.hi));
    const double sign = b.lo > 0 ? 1 : -1, slope = -1 / low / high;
    if (!std::isfinite(slope) || slope == 0) return AffineForm::unknown();
    const auto above = [&](double x) { return value(x) - Bounds(slope) * Bounds(x); };
    // 1 / x - slope x >= 2 sqrt(-slope) for x > 0, with equality at the tangent's point.
    const double offset_low = (Bounds(2.0) * sqrt(Bounds(-slope))).lo;
    const double offset_high = std::max(above(low).hi, above(high).hi);
    return scaled(b.form, slope, sign > 0 ? Bounds(offset_low, offset_high) : Bounds(-offset_high, -offset_low));
  }

  /// Nothing is known but the range.
  void forget() {
    form = std::isfinite(lo) && std::isfinite(hi) ? AffineForm::anywhere_in(lo, hi) : AffineForm::unknown();
  }
  /// Where the range alone is narrower than the rest, the form says nothing beyond it.
  void simplify() {
    if (!form.is_finite() || !(2 * form.rest < hi - lo)) forget();
  }
  /// To what lies in the range and in the form. Where nothing does, operands were assumed to be what they cannot be
  /// together, such as in a cell of a grid that only the corner of their box reaches: then nobody comes here, and the
  /// range will do.
  void narrow(Range range, double radius) {
    using namespace interval_detail;
    lo = range.lo, hi = range.hi;
    const double low = std::max(lo, step_down(form.centre - radius)),
                 high = std::min(hi, step_up(form.centre + radius));
    if (form.is_finite() && std::isfinite(lo) && std::isfinite(hi) && low <= high) {
      lo = low, hi = high;
      simplify();
    } else {
      forget();
    }
  }
};

template <class Budget>
struct NumberTraits<Affine<Budget>> : BoundsTraits<Budget> {
  /// As it is, and as it is rounded to single precision: by the program, not by the device.
  static Affine<Budget> parameter(double x) {
    const auto range = NumberTraits<Interval<Budget>>::parameter(x);
    if constexpr (!std::same_as<Budget, DoubleArithmetic>) {
      const auto single = static_cast<double>(static_cast<float>(x));
      if (std::abs(single) >= Budget::smallest_normal && std::abs(single) <= Budget::largest)
        return {std::min(x, single), std::max(x, single)};
    }
    return Affine<Budget>(range);
  }
  static Affine<Budget> smallest_normal() { return Affine<Budget>(NumberTraits<Interval<Budget>>::smallest_normal()); }
  static Affine<Budget> constant(const RealConstant& c) {
    return Affine<Budget>(NumberTraits<Interval<Budget>>::constant(c));
  }
};

} // namespace refraster::inline REFRASTER_KIT
