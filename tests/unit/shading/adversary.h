#pragma once
// An adversary of bounds: looks for values of a fragment function that lie outside of them, by ascent, on the worst
// devices that their budget allows and on the processor itself.

#include "math/bounds/affine_functions.h"
#include "math/bounds/device_arithmetic.h"
#include "shading/light.h"
#include "tests/support/affine_cases.h"
#include "tests/support/perturbed.h"
#include "tests/unit/shading/laws.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <cfenv>
#include <vector>

namespace refraster {

/// A fragment as rasterization leaves it: position and normal move with the sample, and each component was rounded.
struct Place {
  std::array<Linear, 3> position, normal; // the normal of any length
  Double3 eye, texture;
  PointLight light;
};

/// Symbols 0 and 1 are the sample's shift; each component has one of its own.
inline Place some_place(std::mt19937_64& random, double shift) {
  Place place;
  SurfacePair at = random() % 4 ? random_pair(random) : specular_pair(random);
  if (random() % 8 == 0) at.o = mirrored(at.i, at.n);
  const Double3 p(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2));
  const double size = uniform(random, 0.5, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = static_cast<int>(i);
    place.position[i].centre = p[c], place.normal[i].centre = at.n[c] * size;
    for (std::size_t k = 0; k < 2; ++k) {
      place.position[i].slope[k] = uniform(random, -shift, shift);
      place.normal[i].slope[k] = uniform(random, -shift, shift);
    }
    constexpr double rounding = 16 * 0x1p-24;
    place.position[i].slope[static_cast<std::size_t>(Symbol::position) + i] = rounding * 2;
    place.normal[i].slope[static_cast<std::size_t>(Symbol::normal) + i] = rounding * size;
  }
  place.eye = p + at.o * uniform(random, 1, 10);
  place.light.position = p + at.i * uniform(random, 1, 10);
  place.light.radiance = Double3(uniform(random, 0.5, 4), 1, 2);
  if (random() % 2) place.light.constant = 0.5, place.light.linear = 0.25, place.light.quadratic = 0.125;
  place.texture = Double3(uniform(random, 0, 1), 0.5, 1);
  return place;
}

template <class T, class Function>
Rgb<T> shaded(const Function& function, const Place& place, const Vec3<T>& position, const Vec3<T>& normal) {
  Fragment<T> at{position, normalize(normal), normalize(as<T>(place.eye) - position), as<T>(place.texture), nullptr};
  return ambient(function, at) + reflected(function, at, arriving(place.light, at));
}

template <class Number, class Budget>
Vec3<Number> bounds_of(const std::array<Linear, 3>& line) {
  const auto component = [&](std::size_t i) -> Number {
    const Affine<Budget> bounds = line[i].bounds<Budget>();
    if constexpr (std::same_as<Number, Affine<Budget>>) return bounds;
    else return bounds.range();
  };
  return {component(0), component(1), component(2)};
}
template <class T>
Vec3<T> point_of(const std::array<Linear, 3>& line, const Symbols& e) {
  const auto component = [&](std::size_t i) { return T(static_cast<RealOf<T>>(line[i].at(e))); };
  return {component(0), component(1), component(2)};
}

struct Spread {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  void add(double x) { lo = std::min(lo, x), hi = std::max(hi, x); }
};

/// Climbs to the least and the greatest value of one channel: steps in the symbols that shrink where they do not help,
/// and other signs of the roundings.
template <class Value>
Spread searched(Random& random, int evaluations, const Value& value) {
  Spread spread;
  for (const double sign : {1.0, -1.0}) {
    Symbols best = some_symbols(random);
    std::uint64_t best_flips = random.bits();
    double highest = sign * value(best, best_flips), step = 1;
    spread.add(sign * highest);
    for (int i = 1; i < evaluations / 2; ++i) {
      Symbols e = best;
      std::uint64_t flips = best_flips;
      if (random.below(3) == 0) flips = random.bits();
      else
        for (double& x : e)
          if (random.below(3) == 0) x = std::clamp(x + step * random.uniform(-2, 2), -1.0, 1.0);
      const double found = value(e, flips);
      spread.add(found);
      if (sign * found > highest) highest = sign * found, best = e, best_flips = flips, step = std::min(1.0, 2 * step);
      else step = std::max(step * 0.9, 1e-3);
    }
  }
  return spread;
}

/// The value that so much of all are below.
inline double rank(std::vector<double> values, double at) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(at * static_cast<double>(values.size() - 1))];
}

/// The processor's arithmetic as it is here, and otherwise: rounding in a direction, denormals read and given as 0.
class ProcessorMode {
public:
  enum class Denormals { kept, flushed };
  ProcessorMode(int rounding, Denormals denormals) : control_(control()), rounding_(std::fegetround()) {
    std::fesetround(rounding);
    if (denormals == Denormals::flushed) set_control(control() | denormals_flushed);
  }
  ~ProcessorMode() {
    std::fesetround(rounding_);
    set_control(control_);
  }
  ProcessorMode(const ProcessorMode&) = delete;
  ProcessorMode& operator=(const ProcessorMode&) = delete;

  /// What is made of this vector is computed after the call: a compiler knows nothing of its value from before.
  static void compute_after(Vec3<float>& v) {
#if defined(__aarch64__)
    asm volatile("" : "+w"(v.x), "+w"(v.y), "+w"(v.z));
#else
    asm volatile("" : "+x"(v.x), "+x"(v.y), "+x"(v.z));
#endif
  }

private:
  // The register that says how the processor computes: FPCR of ARM, where one bit flushes what is read and what is
  // given; MXCSR of x86, where each has its own.
#if defined(__aarch64__)
  using Control = std::uint64_t;
  static constexpr Control denormals_flushed = 1U << 24;
  static Control control() {
    Control value;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
  static void set_control(Control value) { asm volatile("msr fpcr, %0" : : "r"(value)); }
#else
  using Control = unsigned;
  static constexpr Control denormals_flushed = 1U << 15 | 1U << 6;
  static Control control() { return _mm_getcsr(); }
  static void set_control(Control value) { _mm_setcsr(value); }
#endif

  Control control_;
  int rounding_;
};

struct Found {
  std::vector<double> ratio, of_intervals;
  long evaluations = 0, outside = 0;
  long unknown = 0; // places of which the bounds say nothing
};

/// Of so many places of one function, from the one numbered `first`. 2/3 of the evaluations are on the worst device of
/// the budget, the others in double and in float; of a device's budget, which allows it, in float that rounds in any
/// direction, and keeps denormals or not.
template <class Budget>
Found search(const FragmentFunction& function, int first, int places, int evaluations, double shift) {
  using Bounds = Affine<Budget>;
  using Hull = Interval<Budget>;
  using Device = Perturbed<Budget>;
  Found found;
  for (int k = first; k < first + places; ++k) {
    std::mt19937_64 random(static_cast<std::uint64_t>(k));
    const Place place = some_place(random, shift);
    Random adversary(static_cast<std::uint64_t>(k));
    std::visit(
        [&](const auto& f) {
          const auto over = [&]<class T>(T) {
            return shaded<T>(f, place, bounds_of<T, Budget>(place.position), bounds_of<T, Budget>(place.normal));
          };
          const Rgb<Bounds> bounds = over(Bounds(0));
          const Rgb<Hull> range = over(Hull(0));
          const auto value = [&](const Symbols& e, std::uint64_t flips) {
            const auto in = [&]<class T>(T) {
              return static_cast<double>(
                  shaded<T>(f, place, point_of<T>(place.position, e), point_of<T>(place.normal, e)).x);
            };
            ++found.evaluations;
            Device::flips() = Random(flips);
            double result = 0;
            if (flips % 6 == 0) {
              result = in(0.0);
            } else if (flips % 6 == 1) {
              if constexpr (requires { Budget::use(OperationErrors{}); }) {
                constexpr int roundings[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
                const std::uint64_t mode = flips / 6 % 8;
                Vec3<float> position = point_of<float>(place.position, e), normal = point_of<float>(place.normal, e);
                volatile float kept = 0;
                {
                  const ProcessorMode now(roundings[mode % 4], mode < 4 ? ProcessorMode::Denormals::kept
                                                                        : ProcessorMode::Denormals::flushed);
                  ProcessorMode::compute_after(position), ProcessorMode::compute_after(normal);
                  kept = shaded<float>(f, place, position, normal).x;
                }
                result = static_cast<double>(kept);
              } else {
                result = in(0.0f);
              }
            } else {
              result = in(Device(0));
            }
            found.outside += !bounds.x.contains(result);
            return result;
          };
          const Spread spread = searched(adversary, evaluations, value);
          // Where more of a table may be read than a device's budget reads, nothing is known; ranges read it all.
          if (bounds.x.width() >= Budget::largest) {
            ++found.unknown;
            return;
          }
          found.outside += bounds.x.lo < range.x.lo || bounds.x.hi > range.x.hi;
          if (spread.hi > spread.lo) {
            found.ratio.push_back(bounds.x.width() / (spread.hi - spread.lo));
            found.of_intervals.push_back(range.x.width() / (spread.hi - spread.lo));
          }
        },
        function);
  }
  return found;
}

inline std::vector<NamedFunction> tried_functions() {
  std::vector<NamedFunction> list;
  for (const double glossiness : {8.0, 128.0, 1e6}) {
    const PhongParameters parameters{{0.1, 0.2, 0}, {0.5, 0.3, 0.7}, {0.4, 0, 1}, glossiness, SpecularGate::open};
    list.push_back({"phong " + std::to_string(glossiness), Phong{parameters}});
    list.push_back({"blinn_phong " + std::to_string(glossiness), BlinnPhong{parameters}});
  }
  for (const NamedFunction& f : all_fragment_functions()) {
    if (std::holds_alternative<Merl>(f.function)) list.push_back(f);
    // A highlight that is far narrower than a place is found by no search: nothing would be known of the spread there.
    if (const auto* const m = std::get_if<Microfacet>(&f.function); m && m->roughness > 0.01) list.push_back(f);
  }
  return list;
}

} // namespace refraster
