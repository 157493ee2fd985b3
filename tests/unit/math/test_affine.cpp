#include "tests/support/affine_cases.h"
#include "tests/support/for_all.h"
#include "tests/support/squares_grid.h"

#include "math/exact.h"

#include <functional>
#include <numbers>
#include <type_traits>

namespace refraster {
namespace {

using Bounds = Affine<DoubleArithmetic>;
using Single = Affine<FloatArithmetic>;

// Code that must not compile: choosing by a comparison of bounds.
template <class T>
concept BranchesOnValues = requires(T x) {
  x < x ? 1 : 2;
};
static_assert(BranchesOnValues<double>);
static_assert(!BranchesOnValues<Bounds>);

void check_operations(int trials) {
  for_all(trials, [](Random& random) {
    const std::pair<Linear, Linear> both = some_pair(random);
    const Linear &x = both.first, &y = both.second;
    const double s = random.below(4) ? random.log_uniform(1e-2, 1e6) : 1;
    const Bounds a = x.bounds<DoubleArithmetic>(), b = y.bounds<DoubleArithmetic>();
    const Single c = x.bounds<FloatArithmetic>(), d = y.bounds<FloatArithmetic>();
    const Symbols e = some_symbols(random);
    const double u = x.at(e), v = y.at(e);
    const auto p = static_cast<float>(u), q = static_cast<float>(v);
    for_each_operation(s, [&](const char* name, const auto& f) {
      INFO(name);
      CAPTURE(s);
      CAPTURE(u);
      CAPTURE(v);
      const Bounds found = f(a, b);
      const Single single = f(c, d);
      CHECK(holds(found, f(u, v)));
      CHECK(holds(single, f(u, v)));
      const Exact exact = f(Exact(u), Exact(v));
      CHECK(holds(found, as_double(exact)));
      CHECK(form_holds(found, e, f(u, v)));
      CHECK(form_holds(single, e, f(u, v)));
      CHECK(holds(single, as_double(f(p, q))));
      CHECK(form_holds(single, e, as_double(f(p, q))));
      // Never wider than a range.
      using InDouble = Interval<DoubleArithmetic>;
      const InDouble plain = f(a.range(), b.range());
      CHECK(found.lo >= plain.lo);
      CHECK(found.hi <= plain.hi);
    });
  });
}

TEST_CASE("the result of an operation on affine bounds holds the operation's result, and so does its form") {
  check_operations(1000);
}

TEST_CASE("a form holds what exact arithmetic makes of exact operands: its own roundings too") {
  for_all(3000, [](Random& random) {
    const std::pair<Linear, Linear> both = some_pair(random);
    const Linear &x = both.first, &y = both.second;
    const AffineForm a{x.centre, x.slope, 0}, b{y.centre, y.slope, 0};
    const Symbols e = some_symbols(random);
    const auto at = [&](const AffineForm& form) {
      Exact value(form.centre);
      for (std::size_t k = 0; k < e.size(); ++k) value += Exact(form.slope[k]) * Exact(e[k]);
      return value;
    };
    const Exact u = at(a), v = at(b);
    const double p = random.uniform(-2, 2), q = random.uniform(-2, 2);
    const auto check = [&](const char* name, const AffineForm& found, const Exact& exact) {
      INFO(name);
      CHECK(abs(at(found) - exact) <= Exact(found.rest));
    };
    check("sum", sum(a, b, 1), u + v);
    check("difference", sum(a, b, -1), u - v);
    check("scaled", scaled(a, p, {q}), Exact(p) * u + Exact(q));
    check("combined", combined(p, a, q, b), Exact(p) * u + Exact(q) * v);
    check("product", product(a, a.radius(), b, b.radius()), u * v);
    check("square", square(a), square(u));
    check("join", join(a, b), u);
    check("join", join(a, b), v);
  });
}

TEST_CASE("a comparison of affine bounds is certain exactly where no two points differ") {
  for_all(5000, [](Random& random) {
    auto [x, y] = some_pair(random);
    if (random.below(2)) y = x, y.centre += random.uniform(-1e-3, 1e-3); // what they share decides
    const Bounds a = x.bounds<DoubleArithmetic>(), b = y.bounds<DoubleArithmetic>();
    const Symbols e = some_symbols(random);
    const auto agrees = [](Certainty c, bool fact) { return c == Certainty::unknown || (c == Certainty::yes) == fact; };
    CHECK(agrees(a < b, x.at(e) < y.at(e)));
    CHECK(agrees(a > b, x.at(e) > y.at(e)));
    CHECK(agrees(a <= b, x.at(e) <= y.at(e)));
    CHECK(agrees(a >= b, x.at(e) >= y.at(e)));
  });
  const Bounds x = Bounds::along(Symbol::shift_x, 1, 0.5);
  CHECK((x < x + Bounds(0.125)) == Certainty::yes);
  CHECK((x.range() < (x + Bounds(0.125)).range()) == Certainty::unknown);
}

TEST_CASE("vectors of affine bounds hold what is computed from their points") {
  for_all(3000, [](Random& random) {
    Vec3<Bounds> a, b;
    Double3 p, q;
    const Symbols e = some_symbols(random);
    const double reach = random.log_uniform(1e-9, 1);
    for (int i = 0; i < 3; ++i) {
      const Linear x = some_linear(random, -1, 1, reach, 4), y = some_linear(random, -1, 1, reach, 4);
      a[i] = x.bounds<DoubleArithmetic>(), p[i] = x.at(e);
      b[i] = y.bounds<DoubleArithmetic>(), q[i] = y.at(e);
    }
    if (!random.below(4)) b = a, q = p;
    const double s = random.log_uniform(0.1, 1e6);
    const auto check = [&](const Bounds& found, double value) {
      CHECK(holds(found, value));
      CHECK(form_holds(found, e, value));
    };
    check(dot(a, b), dot(p, q));
    check(length(a), length(p));
    const Vec3<Bounds> unit_a = normalize(a), unit_b = normalize(b);
    for (int i = 0; i < 3; ++i) check(unit_a[i], normalize(p)[i]);
    check(cosine_power(a, b, s), cosine_power(p, q, s));
    check(cosine_power(unit_a, unit_b, s), cosine_power(normalize(p), normalize(q), s));
  });
}

TEST_CASE("a sum with 0 and a product with a power of two are exact, and a point stays a point") {
  const Single x = Single::along(Symbol::shift_x, 3, 0.25), point(3.0);
  CHECK((x + Single(0)).form.rest == x.form.rest);
  CHECK((x * Single(0.25)).form.slope[0] == 0.0625);
  CHECK((x * Single(0.25)).width() <= x.width() / 4 + 0x1p-50);
  CHECK((x * Single(0)).width() == 0);
  CHECK((Bounds(3.0) + Bounds(0.25)).is_point());
  CHECK(sqrt(Bounds(9.0)).is_point());
  CHECK((x / Single(3.0)).width() > 0);
}

TEST_CASE("a grid read at an affine place holds what each point reads, within a cell and across borders") {
  for (const GridAxis axis : {GridAxis{GridAxis::Beyond::clamped, 10}, GridAxis{GridAxis::Beyond::repeated, 10}})
    for_all(5000, [&](Random& random) {
      const Linear x = some_linear(random, -15, 25, random.log_uniform(1e-6, 20), 3);
      const Symbols e = some_symbols(random);
      const Bounds found = squares_at(x.bounds<DoubleArithmetic>(), axis);
      CHECK(found.contains(squares_at(x.at(e), axis)));
      CHECK(form_holds(found, e, squares_at(x.at(e), axis)));
      CHECK(found.width() <= squares_at(x.bounds<DoubleArithmetic>().range(), axis).width());
    });
}

TEST_CASE("a grid read keeps the slope of its cells, also across a border") {
  const GridAxis axis{GridAxis::Beyond::clamped, 10};
  const Bounds inside = Bounds::along(Symbol::shift_x, 3.5, 0.1), across = Bounds::along(Symbol::shift_x, 3, 0.1);
  // Between samples 2 and 3 the slope is 5, between 3 and 4 it is 7.
  CHECK((squares_at(inside, axis) - Bounds(7.0) * inside).width() <= 1e-12);
  CHECK((squares_at(across, axis) - Bounds(6.0) * across).width() <= 2 * 1 * 0.1 + 1e-12);
}

/// How wide bounds are beside the hull of what points in them give: [-inf, inf] holds all, and must fail.
void check_tight(const char* name, double most, const std::function<Bounds(const Bounds&, const Bounds&)>& bounds,
                 const std::function<double(double, double)>& value) {
  CAPTURE(name);
  for_all(200, [&](Random& random) {
    // Both depend on both symbols.
    const double reach = 1e-3;
    Linear x = some_linear(random, 0.25, 0.75, reach, 2), y = some_linear(random, 0.25, 0.75, reach, 2);
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const Symbols e{2.0 * i / steps - 1, 2.0 * j / steps - 1};
        const double v = value(x.at(e), y.at(e));
        lo = std::min(lo, v), hi = std::max(hi, v);
      }
    const Bounds found = bounds(x.bounds<DoubleArithmetic>(), y.bounds<DoubleArithmetic>());
    CHECK(found.width() <= most * (hi - lo) + 0x1p-44);
  });
}

TEST_CASE("affine bounds are as tight as the values, whatever the operands share") {
  const auto tight = [](const char* name, double most, const auto& f) { check_tight(name, most, f, f); };
  const auto vector = [](const auto& x, const auto& y) {
    using T = std::decay_t<decltype(x)>;
    return Vec3<T>(x, y, T(0.5));
  };
  tight("+", 1.001, [](auto x, auto y) { return x + y; });
  tight("-", 1.001, [](auto x, auto y) { return x - y; });
  // The second order of a reach of 1e-3; more where the first nearly cancels.
  tight("*", 1.5, [](auto x, auto y) { return x * y; });
  tight("/", 1.5, [](auto x, auto y) { return x / y; });
  tight("sqrt", 1.5, [](auto x, auto y) { return sqrt(x) + y; });
  tight("log2", 1.5, [](auto x, auto y) { return log2(x) + y; });
  tight("exp2", 1.5, [](auto x, auto y) { return exp2(x) + y; });
  tight("pow", 2, [](auto x, auto y) { return pow(x, 100.5) + pow(y, 0.5); });
  tight("atan2", 1.5, [](auto x, auto y) { return atan2(x, y); });
  tight("normalize", 1.5, [&](auto x, auto y) { return normalize(vector(x, y)).x; });
  tight("length", 1.5, [&](auto x, auto y) { return length(vector(x, y)); });
  tight("cosine_power", 2,
        [&](auto x, auto y) { return cosine_power(normalize(vector(x, y)), normalize(vector(y, x)), 20); });
  CHECK_FALSE(Bounds::anything().width() <= 1e9);
}

TEST_CASE("what cancels is hundreds of times as tight as ranges are") {
  const auto check = [](const char* name, double times, const auto& f) {
    CAPTURE(name);
    for_all(200, [&](Random& random) {
      Bounds x[3];
      Interval<DoubleArithmetic> range[3];
      for (int i = 0; i < 3; ++i) {
        x[i] = some_linear(random, 0.25, 0.75, 1e-3, 3).bounds<DoubleArithmetic>();
        range[i] = x[i].range();
      }
      CHECK(f(x[0], x[1], x[2]).width() * times <= f(range[0], range[1], range[2]).width());
    });
  };
  check("x - x", 1e9, [](auto x, auto, auto) { return x - x; });
  check("x / x", 1e5, [](auto x, auto, auto) { return x / x; });
  check("(x + y)(x - y) - (x^2 - y^2)", 100,
        [](auto x, auto y, auto) { return (x + y) * (x - y) - (square(x) - square(y)); });
  check("n.n of a unit vector", 100, [](auto x, auto y, auto z) {
    const auto n = normalize(Vec3<decltype(x)>(x, y, z));
    return dot(n, n);
  });
  check("a sum of barycentric coordinates", 100, [](auto x, auto y, auto z) {
    const auto sum = x + y + z;
    return x / sum + y / sum + z / sum;
  });
  check("2^log2 x - x", 100, [](auto x, auto, auto) { return exp2(log2(x)) - x; });
}

TEST_SUITE("slow") {
  TEST_CASE("so do many more results") {
    check_operations(30000);
  }
}

TEST_SUITE("long") {
  TEST_CASE("so does a multitude of results") {
    check_operations(300000);
  }
}

} // namespace
} // namespace refraster
