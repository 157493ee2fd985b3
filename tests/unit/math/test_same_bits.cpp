#include "math/elementary.h"
#include "tests/support/checksum.h"
#include "tests/support/for_all.h"

namespace refraster {
namespace {

template <class F>
std::uint64_t hash_of_elementary_functions() {
  Checksum hash;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Random random(seed);
    const F x = random.any_finite<F>(), y = random.any_finite<F>();
    const F u = F(random.uniform(-1, 1)), v = F(random.uniform(-1, 1)), w = F(random.uniform(-1, 1));
    const double s = random.uniform(0, 200);
    const Vec3<F> a = normalize(Vec3<F>(u, v, w)), b = normalize(a + Vec3<F>(v, w, u) * F(0.1));
    for (const F result : {log2(x), log2(F(1) + u), exp2(x), exp2(u * F(100)), pow(x, s), pow(u, s), atan2(y, x),
                           atan2(v, u), a.x, a.y, cosine_power(a, b, s), cosine_power(a, b, std::floor(s)),
                           length(Vec3<F>(x, y, u)), floor_and_fraction(x).fraction})
      hash.add(result);
  }
  return hash.value();
}

// These stand for every compiler, optimisation level and instruction set: where one differs, so do its images. They
// change with the code of a function, and only with it.
TEST_CASE("elementary functions of double have the same bits on every machine") {
  CHECK(hash_of_elementary_functions<double>() == 8020465481345597581u);
}
TEST_CASE("elementary functions of float have the same bits on every machine") {
  CHECK(hash_of_elementary_functions<float>() == 2915319686598712737u);
}
TEST_CASE("angles in degrees have the same bits on every machine") {
  Checksum hash;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Random random(seed);
    const double angle = random.uniform(-720, 720);
    hash.add(sin_degrees(angle));
    hash.add(cos_degrees(angle));
    hash.add(tan_degrees(angle));
  }
  CHECK(hash.value() == 11633702801097996922u);
}

} // namespace
} // namespace refraster
