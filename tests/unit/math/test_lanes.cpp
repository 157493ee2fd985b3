// What makes an image the same on every machine: a lane holds the same bits as the number alone.

#include "math/elementary.h"
#include "math/precisions.h"
#include "tests/support/for_all.h"

#include <string_view>

namespace refraster {
namespace {

template <class F>
F some_number(Random& random) {
  switch (random.below(8)) {
  case 0:
    return std::numeric_limits<F>::quiet_NaN();
  case 1:
    return static_cast<F>(random.sign()) * std::numeric_limits<F>::infinity();
  case 2:
  case 3:
    return random.hard<F>();
  default:
    return static_cast<F>(random.uniform(-2, 2));
  }
}

template <class T>
using Real = RealOf<T>;

template <class T>
T some_lanes(Random& random) {
  T x;
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) x.set(lane, some_number<Real<T>>(random));
  return x;
}
template <class T>
Vec3<Real<T>> lane_of(const Vec3<T>& a, int lane) {
  return {a.x[lane], a.y[lane], a.z[lane]};
}

/// The same bits; one NaN is as good as another.
template <class F>
bool same(F x, F y) {
  return bits_of(x) == bits_of(y) || (std::isnan(x) && std::isnan(y));
}

/// f takes a T and as well its lane type.
template <class T, class Function>
void check_lanes(std::string_view name, const Function& f, const T& x) {
  const T all = f(x);
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
    const Real<T> alone = f(x[lane]);
    if (!same(all[lane], alone)) CHECK_MESSAGE(same(all[lane], alone), name, " of ", x[lane], " in lane ", lane);
  }
}
template <class T, class Function>
void check_lanes(std::string_view name, const Function& f, const T& x, const T& y) {
  const T all = f(x, y);
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
    const Real<T> alone = f(x[lane], y[lane]);
    if (!same(all[lane], alone))
      CHECK_MESSAGE(same(all[lane], alone), name, " of ", x[lane], " and ", y[lane], " in lane ", lane);
  }
}

#define WIDTHS                                                                                                         \
  Wide<double, 2>, Wide<double, 4>, Wide<double, 8>, Wide<double, 16>, Wide<float, 2>, Wide<float, 4>, Wide<float, 8>, \
      Wide<float, 16>

TEST_CASE_TEMPLATE("each lane of an elementary function has the bits of the number alone", T, WIDTHS) {
  for_all(2000, [](Random& random) {
    const T x = some_lanes<T>(random), y = some_lanes<T>(random);
    constexpr double exponents[] = {0, 1e-300, 0.3, 1, 7.5, 1000, 1e6, 1e308};
    const double s = exponents[random.below(8)];
    check_lanes(
        "log2", [](const auto& a) { return log2(a); }, x);
    check_lanes(
        "exp2", [](const auto& a) { return exp2(a * decltype(a * a)(100)); }, x);
    check_lanes(
        "pow", [s](const auto& a) { return pow(a, s); }, x);
    check_lanes(
        "atan2", [](const auto& a, const auto& b) { return atan2(a, b); }, y, x);
  });
}

TEST_CASE_TEMPLATE("each lane of a highlight has the bits of the highlight alone", T, WIDTHS) {
  for_all(2000, [](Random& random) {
    const Vec3<T> a(some_lanes<T>(random), some_lanes<T>(random), some_lanes<T>(random));
    const Vec3<T> shift(some_lanes<T>(random), some_lanes<T>(random), some_lanes<T>(random));
    const Vec3<T> n = normalize(a);
    const Vec3<T> h = normalize(n + shift * T(static_cast<Real<T>>(random.log_uniform(1e-6, 1))));
    const double s = random.log_uniform(0.1, 1e6);
    const T all = cosine_power(n, h, s);
    for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
      const Vec3<Real<T>> alone = normalize(lane_of(a, lane));
      CHECK((same(n.x[lane], alone.x) && same(n.y[lane], alone.y) && same(n.z[lane], alone.z)));
      CHECK(same(all[lane], cosine_power(lane_of(n, lane), lane_of(h, lane), s)));
    }
  });
}

TEST_CASE_TEMPLATE("a direction with a subnormal component has the same bits alone, and beside whatever else", T,
                   WIDTHS) {
  using F = Real<T>;
  for_all(2000, [](Random& random) {
    const F tiny = std::numeric_limits<F>::min() * static_cast<F>(random.uniform(0, 4));
    const Vec3<F> a(static_cast<F>(random.uniform(1, 8000)), static_cast<F>(random.uniform(-20, 20)), tiny);
    const Vec3<F> alone = normalize(a);
    for (const F beside : {F(1), std::numeric_limits<F>::max()}) {
      Vec3<T> lanes{T(beside), T(beside), T(beside)};
      for (int c = 0; c < 3; ++c) lanes[c].set(0, a[c]);
      const Vec3<F> found = lane_of(normalize(lanes), 0);
      CHECK((same(found.x, alone.x) && same(found.y, alone.y) && same(found.z, alone.z)));
    }
  });
}

TEST_CASE("in the fast arithmetic, too, no lane's length and direction depend on the lanes beside it") {
  using T = FastPrecision::Number;
  for_all(2000, [](Random& random) {
    const auto ordinary = [&] {
      T x;
      for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) x.set(lane, static_cast<float>(random.uniform(-2, 2)));
      return x;
    };
    const Vec3<T> a(ordinary(), ordinary(), ordinary());
    const int changed = random.below(NumberTraits<T>::lanes);
    Vec3<T> b = a;
    for (T* component : {&b.x, &b.y, &b.z}) component->set(changed, static_cast<float>(random.sign()) * 1e30f);
    const Vec3<T> direction_a = normalize(a), direction_b = normalize(b);
    const T length_a = length(a), length_b = length(b);
    for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
      if (lane == changed) continue;
      CHECK(same(length_a[lane], length_b[lane]));
      CHECK(lane_of(direction_a, lane) == lane_of(direction_b, lane));
    }
    CHECK(std::isfinite(length_b[changed]));
  });
}

TEST_CASE_TEMPLATE("each lane of a basic operation has the bits of the number alone", T, WIDTHS) {
  for_all(2000, [](Random& random) {
    const T x = some_lanes<T>(random), y = some_lanes<T>(random);
    check_lanes(
        "sqrt", [](const auto& a) { return sqrt(a); }, x);
    check_lanes(
        "square", [](const auto& a) { return square(a); }, x);
    check_lanes(
        "abs", [](const auto& a) { return abs(a); }, x);
    check_lanes(
        "reciprocal_binade", [](const auto& a) { return reciprocal_binade(a); }, x);
    check_lanes(
        "fraction", [](const auto& a) { return floor_and_fraction(a).fraction; }, x);
    check_lanes(
        "min", [](const auto& a, const auto& b) { return min(a, b); }, x, y);
    check_lanes(
        "max", [](const auto& a, const auto& b) { return max(a, b); }, x, y);
    check_lanes(
        "quotient", [](const auto& a, const auto& b) { return a / b; }, x, y);

    const int n = 1 + random.below(random.below(2) ? 5 : 70000);
    const Cell<T> cells = floor_and_fraction(x);
    const IndexOf<T> wrapped = wrap_index(cells.index, n), clamped = clamp_index(next_index(cells.index), 2, n + 2);
    const MaskOf<T> less = x < y;
    int count = 0;
    for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
      const std::int32_t index = floor_and_fraction(x[lane]).index;
      CHECK(cells.index.i[lane] == index);
      CHECK(wrapped.i[lane] == wrap_index(index, n));
      CHECK(clamped.i[lane] == clamp_index(next_index(index), 2, n + 2));
      count += count_lanes(x[lane] < y[lane]);
    }
    CHECK(count_lanes(less) == count);
    CHECK(any(less) == (count > 0));
  });
}

TEST_CASE_TEMPLATE("the first lanes are the first, for every count", T, WIDTHS) {
  constexpr int lanes = NumberTraits<T>::lanes;
  for (int count = 0; count <= lanes; ++count) {
    const MaskOf<T> first = first_lanes<Real<T>, lanes>(count);
    CHECK(count_lanes(first) == count);
    CHECK(count_lanes(!first) == lanes - count);
    const T chosen = select(first, T(1), T(2));
    for (int lane = 0; lane < lanes; ++lane) CHECK(chosen[lane] == (lane < count ? 1 : 2));
  }
}

} // namespace
} // namespace refraster
