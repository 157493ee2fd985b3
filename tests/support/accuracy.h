#pragma once
// A function's stated error bound against what is measured.

#include "math/elementary/ulp_bound.h"
#include "tests/support/for_all.h"
#include "tests/support/ulp.h"

#include <string_view>

namespace refraster {

/// error(random) gives the error of one trial in ulps. The measured figures are printed with `-s`.
template <class Trial>
void check_error(std::string_view function, const UlpBound& bound, int trials, const Trial& error) {
  UlpErrors errors;
  for_all(trials, [&](Random& random) {
    const double ulp = error(random);
    if (!(ulp <= bound.max)) CHECK_MESSAGE(ulp <= bound.max, function);
    errors.add(ulp);
  });
  const double most = errors.percentile_99(), worst = errors.max();
  CAPTURE(function);
  CAPTURE(worst);
  CAPTURE(most);
  CHECK(worst <= bound.max);
  CHECK(most <= bound.mostly);
}

inline Mpfr exact_log2(const Mpfr& x) {
  static const Mpfr ln2 = log(Mpfr(2));
  return log(x) / ln2;
}
inline Mpfr exact_exp2(const Mpfr& x) {
  return pow(Mpfr(2), x);
}

} // namespace refraster
