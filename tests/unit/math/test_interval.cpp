#include "tests/support/for_all.h"
#include "tests/support/squares_grid.h"

#include "math/bounds/interval_functions.h"
#include "math/exact.h"
#include <functional>
#include <numbers>

namespace refraster {
namespace {

using Bounds = Interval<DoubleArithmetic>;

// Code that must not compile: choosing by a comparison of bounds.
template <class T>
concept BranchesOnValues = requires(T x) {
  x < x ? 1 : 2;
};
static_assert(BranchesOnValues<double>);
static_assert(!BranchesOnValues<Bounds>);

/// An interval, sometimes a single point, and some number in it.
struct Known {
  Bounds bounds;
  double value;
};
Known some_known(Random& random, double lo, double hi) {
  const double a = random.uniform(lo, hi), b = random.below(3) ? random.uniform(lo, hi) : a;
  const Bounds bounds(std::min(a, b), std::max(a, b));
  const double t[] = {bounds.lo, bounds.hi, std::clamp(random.uniform(bounds.lo, bounds.hi), bounds.lo, bounds.hi)};
  return {bounds, t[random.below(3)]};
}
Known some_hard(Random& random) {
  const double a = random.hard<double>(), b = random.below(3) ? random.hard<double>() : a;
  const Bounds bounds(std::min(a, b), std::max(a, b));
  const double between = bounds.lo / 2 + bounds.hi / 2;
  const double t[] = {bounds.lo, bounds.hi, bounds.contains(between) ? between : bounds.lo};
  return {bounds, t[random.below(3)]};
}

TEST_CASE("the result of an operation on bounds holds the operation's result") {
  for_all(50000, [](Random& random) {
    const Known x = random.below(2) ? some_known(random, -2, 2) : some_hard(random);
    const Known y = random.below(2) ? some_known(random, -2, 2) : some_hard(random);
    CAPTURE(x.value);
    CAPTURE(y.value);
    const auto holds = [](const Bounds& bounds, double value) { return std::isnan(value) || bounds.contains(value); };
    CHECK(holds(x.bounds + y.bounds, x.value + y.value));
    CHECK(holds(x.bounds - y.bounds, x.value - y.value));
    CHECK(holds(x.bounds * y.bounds, x.value * y.value));
    CHECK(holds(x.bounds / y.bounds, x.value / y.value));
    CHECK(holds(-x.bounds, -x.value));
    CHECK(holds(square(x.bounds), square(x.value)));
    CHECK(holds(abs(x.bounds), abs(x.value)));
    CHECK(holds(sqrt(x.bounds), sqrt(x.value)));
    CHECK(holds(max(x.bounds, y.bounds), max(x.value, y.value)));
    CHECK(holds(min(x.bounds, y.bounds), min(x.value, y.value)));
    CHECK(holds(log2(x.bounds), log2(x.value)));
    CHECK(holds(exp2(x.bounds), exp2(x.value)));
    CHECK(holds(atan2(y.bounds, x.bounds), atan2(y.value, x.value)));
    CHECK(holds(fraction(x.bounds), fraction(x.value)));
    const double s = random.log_uniform(1e-3, 1e6);
    CHECK(holds(pow(x.bounds, s), pow(x.value, s)));
  });
}

TEST_CASE("bounds of a cosine's power hold it, for directions and for any vectors") {
  for_all(20000, [](Random& random) {
    const double reach = random.below(2) ? 1e-3 : 1;
    Vec3<Bounds> a, b;
    Double3 p, q;
    for (int i = 0; i < 3; ++i) {
      const double middle = random.uniform(-1, 1);
      const Known known_a = some_known(random, middle - reach, middle + reach);
      const Known known_b = some_known(random, middle - reach, middle + reach);
      a[i] = known_a.bounds, b[i] = known_b.bounds, p[i] = known_a.value, q[i] = known_b.value;
    }
    const double s = random.log_uniform(0.1, 1e5);
    CHECK(cosine_power(a, b, s).contains(cosine_power(p, q, s)));
    CHECK(cosine_power(normalize(a), normalize(b), s).contains(cosine_power(normalize(p), normalize(q), s)));
  });
}

TEST_CASE("a step is to the next double") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto check = [&](double x) {
    CHECK(interval_detail::step_up(x) == std::nextafter(x, infinity));
    CHECK(interval_detail::step_down(x) == std::nextafter(x, -infinity));
  };
  for (const double x : {0.0, -0.0, infinity, -infinity}) check(x);
  for_all(10000, [&](Random& random) { check(random.hard<double>()); });
}

TEST_CASE("a comparison of bounds is certain exactly where no two points differ") {
  CHECK((Bounds(0, 1) < Bounds(2, 3)) == Certainty::yes);
  CHECK((Bounds(2, 3) < Bounds(0, 1)) == Certainty::no);
  CHECK((Bounds(0, 2) < Bounds(1, 3)) == Certainty::unknown);
  CHECK((Bounds(1.0) < Bounds(1.0)) == Certainty::no);
  CHECK((Bounds(1.0) <= Bounds(1.0)) == Certainty::yes);
  CHECK((Bounds(0, 1) >= Bounds(1, 2)) == Certainty::unknown);
  for_all(5000, [](Random& random) {
    const Known x = some_known(random, -1, 1), y = some_known(random, -1, 1);
    const auto agrees = [](Certainty c, bool fact) { return c == Certainty::unknown || (c == Certainty::yes) == fact; };
    CHECK(agrees(x.bounds < y.bounds, x.value < y.value));
    CHECK(agrees(x.bounds > y.bounds, x.value > y.value));
    CHECK(agrees(x.bounds <= y.bounds, x.value <= y.value));
    CHECK(agrees(x.bounds >= y.bounds, x.value >= y.value));
  });
}

TEST_CASE("choosing by what is unknown takes both") {
  const Bounds both = select(Certainty::unknown, Bounds(0, 1), Bounds(3, 4));
  CHECK(both.lo == 0);
  CHECK(both.hi == 4);
  CHECK(select(Certainty::yes, Bounds(0, 1), Bounds(3, 4)).hi == 1);
  CHECK(select(Certainty::no, Bounds(0, 1), Bounds(3, 4)).lo == 3);
}

TEST_CASE("exact operations keep a point a point") {
  const Bounds x(3.0), zero(0.0);
  CHECK((x + Bounds(0.25)).width() == 0);
  CHECK((x * Bounds(0.25)).width() == 0);
  CHECK((x / Bounds(4.0)).width() == 0);
  CHECK((zero * Bounds(0.1, 7)).width() == 0);
  CHECK(sqrt(Bounds(9.0)).width() == 0);
  CHECK((Bounds(1.0) / x).width() > 0);
}

TEST_CASE("a grid read in a range of places holds what each of them reads, within a cell and across borders") {
  for (const GridAxis axis : {GridAxis{GridAxis::Beyond::clamped, 10}, GridAxis{GridAxis::Beyond::repeated, 10}})
    for_all(20000, [&](Random& random) {
      const Known x = some_known(random, -15, 25);
      const double reach = random.below(2) ? 1 : 0.01;
      const Bounds place(x.value - reach, x.value + reach);
      CHECK(squares_at(place, axis).contains(squares_at(random.uniform(place.lo, place.hi), axis)));
    });
}

TEST_CASE("a grid read across a border is as narrow as the values there, index and fraction staying together") {
  const GridAxis clamped{GridAxis::Beyond::clamped, 10}, repeated{GridAxis::Beyond::repeated, 10};
  // Between samples 2 and 3 the slope is 5, between 3 and 4 it is 7.
  const Bounds border = squares_at(Bounds(2.9, 3.1), clamped);
  CHECK(border.lo == doctest::Approx(8.5));
  CHECK(border.hi == doctest::Approx(9.7));
  // From sample 9 to sample 0: a whole turn is no more than all samples.
  const Bounds seam = squares_at(Bounds(8.5, 9.5), repeated), all = squares_at(Bounds(-1e9, 1e9), repeated);
  CHECK(seam.lo == doctest::Approx(40.5));
  CHECK(seam.hi == doctest::Approx(81));
  CHECK(all.lo == 0);
  CHECK(all.hi == doctest::Approx(81));
  CHECK(squares_at(Bounds(-1e30, -5), clamped).width() == 0);
}

/// How wide bounds are beside the hull of what points in them give: an interval of everything holds all, and must fail.
/// `most`: 2 for one operation, whose own rounding is as wide as the hull of a point; more where x stands twice.
void check_tight(const char* name, double most, const std::function<Bounds(const Bounds&, const Bounds&)>& bounds,
                 const std::function<double(double, double)>& value) {
  CAPTURE(name);
  for_all(300, [&](Random& random) {
    const double a = random.uniform(0.25, 0.75), b = random.uniform(0.25, 0.75), reach = 1e-3;
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const double v = value(a - reach + 2 * reach * i / steps, b - reach + 2 * reach * j / steps);
        lo = std::min(lo, v), hi = std::max(hi, v);
      }
    const Bounds found = bounds({a - reach, a + reach}, {b - reach, b + reach});
    CHECK(found.width() <= most * (hi - lo));
  });
}

TEST_CASE("bounds of one operation are as tight as its values") {
  // Monotone in both arguments: the corners of the box are among the samples, and only roundings are added.
  constexpr double monotone = 1 + 1e-6;
  const auto tight = [&](const char* name, const auto& f) { check_tight(name, monotone, f, f); };
  tight("+", [](auto x, auto y) { return x + y; });
  tight("-", [](auto x, auto y) { return x - y; });
  tight("*", [](auto x, auto y) { return x * y; });
  tight("/", [](auto x, auto y) { return x / y; });
  tight("sqrt", [](auto x, auto y) { return sqrt(x) + y; });
  tight("log2", [](auto x, auto y) { return log2(x) + y; });
  tight("exp2", [](auto x, auto y) { return exp2(x) + y; });
  tight("pow", [](auto x, auto y) { return pow(x, 100.5) + pow(y, 0.5); });
  tight("atan2", [](auto x, auto y) { return atan2(x, y); });
  tight("normalize", [](auto x, auto y) { return normalize(Vec3<decltype(x)>(x, y, decltype(x)(0.5))).x; });
  tight("length", [](auto x, auto y) { return length(Vec3<decltype(x)>(x, y, decltype(x)(0.5))); });
  CHECK_FALSE(Bounds::anything().width() <= monotone);
}

TEST_CASE("the budget of float holds float arithmetic and what is exact") {
  using Single = Interval<FloatArithmetic>;
  for_all(50000, [](Random& random) {
    const float x = random.below(2) ? static_cast<float>(random.uniform(-2, 2)) : random.hard<float>();
    const float y = random.below(2) ? static_cast<float>(random.uniform(-2, 2)) : random.hard<float>();
    CAPTURE(x);
    CAPTURE(y);
    const double a = static_cast<double>(x), b = static_cast<double>(y);
    const auto holds = [](const Single& bounds, float single, const Exact& exact) {
      const bool is_double = abs(exact) <= Exact(std::numeric_limits<double>::max());
      const bool holds_exact = !is_double || (Exact(bounds.lo) <= exact && exact <= Exact(bounds.hi));
      return (std::isnan(single) || bounds.contains(static_cast<double>(single))) && holds_exact;
    };
    CHECK(holds(Single(a) + Single(b), x + y, Exact(a) + Exact(b)));
    CHECK(holds(Single(a) - Single(b), x - y, Exact(a) - Exact(b)));
    CHECK(holds(Single(a) * Single(b), x * y, Exact(a) * Exact(b)));
    if (b != 0) CHECK(holds(Single(a) / Single(b), x / y, Exact(a) / Exact(b)));
    CHECK(holds(square(Single(a)), square(x), square(Exact(a))));
    CHECK(holds(atan2(Single(b), Single(a)), atan2(y, x), atan2(Exact(b), Exact(a))));
    if (x > 0) {
      CHECK(holds(sqrt(Single(a)), sqrt(x), sqrt(Exact(a))));
      CHECK(holds(log2(Single(a)), log2(x), log2(Exact(a))));
    }
    const double parameter = random.uniform(-100, 100);
    const Single entered = as<Single>(parameter);
    CHECK(holds(entered, static_cast<float>(parameter), Exact(parameter)));
  });
}

TEST_CASE("bounds hold what rounds just below a cell, what is far outside, and what counts as zero") {
  // -2^-54 + 1 rounds to 1, of which the fraction is the largest number below it.
  CHECK(fraction(Bounds(-0x1p-54)).contains(fraction(-0x1p-54)));
  const GridAxis repeated{GridAxis::Beyond::repeated, 10};
  for (const double x : {1e12, -1e12, 1e300, -1e300})
    CHECK(squares_at(Bounds(x), repeated).contains(squares_at(x, repeated)));
  const auto point = [](const Double3& a) { return Vec3<Bounds>(Bounds(a.x), Bounds(a.y), Bounds(a.z)); };
  const Double3 a(1, 0, 0), nearly_across(1e-310, 1, 0), long_one(1, 1.7e308, 0);
  CHECK(cosine_power(point(a), point(nearly_across), 0.01).contains(cosine_power(a, nearly_across, 0.01)));
  CHECK(normalize(point(long_one)).x.contains(normalize(long_one).x));
  CHECK(as<Interval<FloatArithmetic>>(std::numeric_limits<double>::quiet_NaN()).contains(1e300));
  // Just below pi other numbers hold the angle with the rounding of pi.
  const Vec2<Bounds> seam(Bounds(1.0), Bounds(-3.5e-16, 0));
  const double below_pi = atan2(3.5e-16, -1.0) - std::numbers::pi;
  CHECK(line_angle(seam).contains(below_pi));
  CHECK(line_angle(seam).width() <= 0x1p-45); // 64 times 2^-52, and the box
}

} // namespace
} // namespace refraster
