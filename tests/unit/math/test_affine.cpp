#include "tests/support/affine_cases.h"
#include "tests/support/for_all.h"
#include "tests/support/perturbed.h"

#include "math/bounds/device_arithmetic.h"
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

/// Every operation of one and two numbers, by its name: check(name, operation). `s` is an exponent.
template <class Check>
void for_each_operation(double s, const Check& check) {
  check("+", [](const auto& x, const auto& y) { return x + y; });
  check("-", [](const auto& x, const auto& y) { return x - y; });
  check("*", [](const auto& x, const auto& y) { return x * y; });
  check("/", [](const auto& x, const auto& y) { return x / y; });
  check("minus", [](const auto& x, const auto&) { return -x; });
  check("max", [](const auto& x, const auto& y) { return max(x, y); });
  check("min", [](const auto& x, const auto& y) { return min(x, y); });
  check("abs", [](const auto& x, const auto&) { return abs(x); });
  check("square", [](const auto& x, const auto&) { return square(x); });
  check("sqrt", [](const auto& x, const auto&) { return sqrt(abs(x)); });
  check("fraction", [](const auto& x, const auto&) { return fraction(x); });
  check("log2", [](const auto& x, const auto&) { return log2(abs(x)); });
  check("exp2", [](const auto& x, const auto&) { return exp2(x); });
  check("pow", [s](const auto& x, const auto&) { return pow(x, s); });
  check("atan2", [](const auto& x, const auto& y) { return atan2(x, y); });
  check("atan2 of abs", [](const auto& x, const auto& y) { return atan2(abs(x), y); });
  check("select", [](const auto& x, const auto& y) { return select(x < y, x * y, x + y); });
}

template <class T>
double as_double(const T& x) {
  return static_cast<double>(x);
}

/// Whether bounds hold what was computed; NaN comes only of what is not finite.
template <class B>
bool holds(const Affine<B>& bounds, double value) {
  return std::isnan(value) || bounds.contains(value);
}

/// And whether the form alone does, with the symbols where they are: not only their hull.
template <class B>
bool form_holds(const Affine<B>& bounds, const Symbols& e, double value) {
  if (!std::isfinite(value) || !bounds.form.is_finite()) return true;
  Exact at(bounds.form.centre);
  for (std::size_t k = 0; k < e.size(); ++k) at += Exact(bounds.form.slope[k]) * Exact(e[k]);
  return abs(Exact(value) - at) <= Exact(bounds.form.rest);
}

/// A pair of numbers of any size, or of hard ones.
std::pair<Linear, Linear> some_pair(Random& random) {
  const double size = random.below(4) ? 2 : random.log_uniform(1e-3, 1e3);
  const double reach = size * random.log_uniform(1e-9, 2);
  const int symbols = 1 + random.below(static_cast<int>(AffineForm::symbols));
  Linear x = some_linear(random, -size, size, reach, symbols), y = some_linear(random, -size, size, reach, symbols);
  if (!random.below(8)) x.centre = 0;
  if (!random.below(8)) y = {std::ldexp(1.0, random.below(9) - 4), {}};
  if (!random.below(8)) x = {random.uniform(-size, size), {}};
  return {x, y};
}

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

TEST_CASE("a device's errors are read when the program runs, and bounds hold what it may make of an operation") {
  using OnDevice = Affine<DeviceArithmetic>;
  using Device = Perturbed<DeviceArithmetic>;
  OperationErrors errors;
  for_all(3000, [&](Random& random) {
    errors.relative = random.log_uniform(0x1p-24, 1e-6); // what the program itself rounds to float, at least
    errors.quotient_relative = errors.relative * random.uniform(1, 3), errors.root_relative = errors.quotient_relative;
    errors.log2_absolute = random.log_uniform(1e-9, 1e-6);
    DeviceArithmetic::use(errors);
    const std::pair<Linear, Linear> both = some_pair(random);
    const Linear &x = both.first, &y = both.second;
    const double s = random.log_uniform(1e-2, 1e2);
    const OnDevice a = x.bounds<DeviceArithmetic>(), b = y.bounds<DeviceArithmetic>();
    const Symbols e = some_symbols(random);
    for_each_operation(s, [&](const char* name, const auto& f) {
      INFO(name);
      const OnDevice found = f(a, b);
      const double value = f(Device(x.at(e)), Device(y.at(e))).value;
      CHECK(holds(found, value));
      CHECK(form_holds(found, e, value));
      const Interval<DeviceArithmetic> plain = f(a.range(), b.range());
      CHECK(plain.contains(value));
      CHECK((found.lo >= plain.lo && found.hi <= plain.hi));
    });
    Vec3<OnDevice> p, q;
    Vec3<Device> at_p, at_q;
    for (int i = 0; i < 3; ++i) {
      const Linear of_p = some_linear(random, -1, 1, 1e-3, 4), of_q = some_linear(random, -1, 1, 1e-3, 4);
      p[i] = of_p.bounds<DeviceArithmetic>(), at_p[i] = Device(of_p.at(e));
      q[i] = of_q.bounds<DeviceArithmetic>(), at_q[i] = Device(of_q.at(e));
    }
    const auto check = [&](const OnDevice& found, const Device& value) {
      CHECK(holds(found, value.value));
      CHECK(form_holds(found, e, value.value));
    };
    check(dot(p, q), dot(at_p, at_q));
    check(length(p), length(at_p));
    check(cosine_power(normalize(p), normalize(q), s), cosine_power(normalize(at_p), normalize(at_q), s));
  });
  const OnDevice third = OnDevice(1.0) / OnDevice(3.0);
  errors.quotient_relative = 0.25;
  DeviceArithmetic::use(errors);
  CHECK((OnDevice(1.0) / OnDevice(3.0)).width() == doctest::Approx(2 * 0.25 / 3));
  CHECK(third.width() < 1e-5);
  DeviceArithmetic::use({});
}

/// Exact points, so that only the budgets are between bounds and what a device makes of them.
template <class Budget>
void check_vectors_of_points() {
  using T = Affine<Budget>;
  using Device = Perturbed<Budget>;
  for_all(5000, [](Random& random) {
    Vec3<T> a, b;
    Vec3<Device> p, q;
    const double apart = random.log_uniform(1e-3, 1);
    for (int i = 0; i < 3; ++i) {
      const double x = static_cast<double>(static_cast<float>(random.uniform(-1, 1)));
      const double y = static_cast<double>(static_cast<float>(x + random.uniform(-apart, apart)));
      a[i] = T(x), p[i] = Device(x), b[i] = T(y), q[i] = Device(y);
    }
    Device::flips() = Random(random.bits());
    const double s = random.log_uniform(0.5, 8);
    const Vec3<T> unit = normalize(a);
    const T product = dot(a, b), size = length(a), squared = squared_length(a), power = cosine_power(a, b, s);
    const T angle = atan2(a.y, a.x);
    for (int again = 0; again < 20; ++again) {
      CHECK(product.contains(dot(p, q).value));
      CHECK(size.contains(length(p).value));
      CHECK(squared.contains(squared_length(p).value));
      CHECK(power.contains(cosine_power(p, q, s).value));
      CHECK(angle.contains(atan2(p.y, p.x).value));
      CHECK(unit.x.contains(normalize(p).x.value));
    }
  });
}

TEST_CASE("vectors of points have the budget of the device, and no less") {
  check_vectors_of_points<FloatArithmetic>();
  DeviceArithmetic::use({});
  check_vectors_of_points<DeviceArithmetic>();
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

/// A straight line between samples k^2 of a grid, as a filter reads it.
template <Number T>
T squares_at(const T& x, GridAxis axis) {
  return read_grid(std::array{x}, std::array{axis}, [&](const std::array<Cell<T>, 1>& cell) {
    const auto place = [&](IndexOf<T> k) {
      return axis.beyond == GridAxis::Beyond::repeated ? wrap_index(k, axis.count) : clamp_index(k, 0, axis.count - 1);
    };
    const auto value = [&](IndexOf<T> k) {
      const auto fetch = [](std::int32_t i, std::int32_t, std::int32_t) { return Rgb<double>(i * i, 0, 0); };
      return stored_value<T>(fetch, place(k), 0, 0).x;
    };
    const T low = value(cell[0].index), high = value(next_index(cell[0].index));
    return low + (high - low) * cell[0].fraction;
  });
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

TEST_CASE("interpolation holds what a device makes of it, in the order of the formula") {
  using Device = Perturbed<FloatArithmetic>;
  for_all(20000, [](Random& random) {
    const double size = random.log_uniform(1e-3, 1e3), apart = random.log_uniform(1e-6, 1);
    const Symbols e = some_symbols(random);
    const bool are_points = random.below(2);
    const auto some = [&](double lo, double hi, double reach) {
      Linear line = some_linear(random, lo, hi, reach, 3);
      if (are_points) line.slope = {};
      return line;
    };
    std::array<Linear, 4> tap;
    for (Linear& line : tap) line = some(size, size * (1 + apart), size * apart);
    const Linear f = some(0.3, 0.7, 0.29);
    const auto bounds = [&](const Linear& line) {
      return are_points ? Single(line.centre) : line.bounds<FloatArithmetic>();
    };
    const auto four = [](const auto& x) { return Vec4<std::decay_t<decltype(x)>>(x, x, x, x); };
    const auto bound = [&](std::size_t i) { return four(bounds(tap[i])); };
    const auto device = [&](std::size_t i) { return four(Device(tap[i].at(e))); };
    const Single linear = mix(bound(0), bound(1), bounds(f)).x;
    const Single cubic = mix_cubic(bound(0), bound(1), bound(2), bound(3), bounds(f)).x;
    for (int again = 0; again < 4; ++again) {
      const double mixed = mix(device(0), device(1), Device(f.at(e))).x.value;
      const double smooth = mix_cubic(device(0), device(1), device(2), device(3), Device(f.at(e))).x.value;
      CHECK(linear.contains(mixed));
      CHECK(form_holds(linear, e, mixed));
      CHECK(cubic.contains(smooth));
      CHECK(form_holds(cubic, e, smooth));
    }
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
    check_operations(100000);
  }
}

} // namespace
} // namespace refraster
