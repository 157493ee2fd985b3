#pragma once
// Numbers rounded to half precision, in which measured tables may be stored.

#include "math/half.h"

namespace refraster {

/// x rounded once, to the nearest half, halfway cases to even; beyond the largest, the largest of that sign. x is not
/// NaN.
Half half_of(double x);

} // namespace refraster
