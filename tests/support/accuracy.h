#pragma once
// A function's stated error bound against what is measured.

#include "math/ulp_bound.h"
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

inline Exact exact_log2(const Exact& x) {
  static const Exact ln2 = log(Exact(2));
  return log(x) / ln2;
}
inline Exact exact_exp2(const Exact& x) {
  return pow(Exact(2), x);
}

} // namespace refraster
