// Affine bounds against a device that errs as much as its budget allows.

#include "tests/support/affine_cases.h"
#include "tests/support/for_all.h"
#include "tests/support/perturbed.h"

#include "math/bounds/device_arithmetic.h"

namespace refraster {
namespace {

using Single = Affine<FloatArithmetic>;

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

} // namespace
} // namespace refraster
