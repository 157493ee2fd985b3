#include "tests/support/for_all.h"
#include "tests/support/interval.h"

namespace refraster {
namespace {

// Code that must not compile: choosing by a comparison of bounds.
template <class T>
concept BranchesOnValues = requires(T x) {
  x < x ? 1 : 2;
};
static_assert(BranchesOnValues<double>);
static_assert(!BranchesOnValues<Interval>);

/// An interval, sometimes a single point, and some number in it.
struct Known {
  Interval bounds;
  double value;
};
Known some_known(Random& random, double lo, double hi) {
  const double a = random.uniform(lo, hi), b = random.below(3) ? random.uniform(lo, hi) : a;
  const Interval bounds(std::min(a, b), std::max(a, b));
  const double t[] = {bounds.lo, bounds.hi, std::clamp(random.uniform(bounds.lo, bounds.hi), bounds.lo, bounds.hi)};
  return {bounds, t[random.below(3)]};
}
Known some_hard(Random& random) {
  const double a = random.hard<double>(), b = random.below(3) ? random.hard<double>() : a;
  const Interval bounds(std::min(a, b), std::max(a, b));
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
    const auto holds = [](const Interval& bounds, double value) { return std::isnan(value) || bounds.contains(value); };
    CHECK(holds(x.bounds + y.bounds, x.value + y.value));
    CHECK(holds(x.bounds - y.bounds, x.value - y.value));
    CHECK(holds(x.bounds * y.bounds, x.value * y.value));
    CHECK(holds(x.bounds / y.bounds, x.value / y.value));
    CHECK(holds(-x.bounds, -x.value));
    CHECK(holds(square(x.bounds), square(x.value)));
    CHECK(holds(magnitude(x.bounds), magnitude(x.value)));
    CHECK(holds(root(x.bounds), root(x.value)));
    CHECK(holds(reciprocal_binade(x.bounds), reciprocal_binade(x.value)));
    CHECK(holds(maximum(x.bounds, y.bounds), maximum(x.value, y.value)));
    CHECK(holds(minimum(x.bounds, y.bounds), minimum(x.value, y.value)));
    CHECK(holds(log2(x.bounds), log2(x.value)));
    CHECK(holds(exp2(x.bounds), exp2(x.value)));
    CHECK(holds(atan2(y.bounds, x.bounds), atan2(y.value, x.value)));
    CHECK(holds(cell(x.bounds).fraction, cell(x.value).fraction));
    const double s = random.magnitude(1e-3, 1e6);
    CHECK(holds(power(x.bounds, s), power(x.value, s)));
  });
}

TEST_CASE("bounds of a cosine's power hold it, for directions and for any vectors") {
  for_all(20000, [](Random& random) {
    const double reach = random.below(2) ? 1e-3 : 1;
    Vec3<Interval> a, b;
    Double3 p, q;
    for (int i = 0; i < 3; ++i) {
      const double middle = random.uniform(-1, 1);
      const Known known_a = some_known(random, middle - reach, middle + reach);
      const Known known_b = some_known(random, middle - reach, middle + reach);
      a[i] = known_a.bounds, b[i] = known_b.bounds, p[i] = known_a.value, q[i] = known_b.value;
    }
    const double s = random.magnitude(0.1, 1e5);
    CHECK(cosine_power(a, b, s).contains(cosine_power(p, q, s)));
    CHECK(cosine_power(normalize(a), normalize(b), s).contains(cosine_power(normalize(p), normalize(q), s)));
  });
}

TEST_CASE("a comparison of bounds is certain exactly where no two points differ") {
  CHECK((Interval(0, 1) < Interval(2, 3)) == Certainty::yes);
  CHECK((Interval(2, 3) < Interval(0, 1)) == Certainty::no);
  CHECK((Interval(0, 2) < Interval(1, 3)) == Certainty::unknown);
  CHECK((Interval(1.0) < Interval(1.0)) == Certainty::no);
  CHECK((Interval(1.0) <= Interval(1.0)) == Certainty::yes);
  CHECK((Interval(0, 1) >= Interval(1, 2)) == Certainty::unknown);
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
  const Interval both = select(Certainty::unknown, Interval(0, 1), Interval(3, 4));
  CHECK(both.lo == 0);
  CHECK(both.hi == 4);
  CHECK(select(Certainty::yes, Interval(0, 1), Interval(3, 4)).hi == 1);
  CHECK(select(Certainty::no, Interval(0, 1), Interval(3, 4)).lo == 3);
}

TEST_CASE("exact operations keep a point a point") {
  const Interval x(3.0), zero(0.0);
  CHECK((x + Interval(0.25)).width() == 0);
  CHECK((x * Interval(0.25)).width() == 0);
  CHECK((x / Interval(4.0)).width() == 0);
  CHECK((zero * Interval(0.1, 7)).width() == 0);
  CHECK(root(Interval(9.0)).width() == 0);
  CHECK((Interval(1.0) / x).width() > 0);
}

TEST_CASE("a lookup in ranges of indices holds every value there, also round the corner") {
  const auto fetch = [](std::int32_t i, std::int32_t j, std::int32_t k) { return Rgb<double>(i * i, j, k); };
  const IndexRange i = {-2, 3}, j = {7, 7};
  const Rgb<Interval> rgb = lookup<Interval>(fetch, i, j, IndexRange{});
  CHECK(rgb.x.lo == 0);
  CHECK(rgb.x.hi == 9);
  CHECK(rgb.y.width() == 0);

  const IndexRange wrapped = wrap_index(IndexRange{-1, 1}, 10), within = wrap_index(IndexRange{12, 14}, 10);
  CHECK(wrapped.lo == 0);
  CHECK(wrapped.hi == 9);
  CHECK(within.lo == 2);
  CHECK(within.hi == 4);
}

} // namespace
} // namespace refraster
