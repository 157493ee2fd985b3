#pragma once
// The elementary functions of a Number: branch-free, total, the same bits in every lane as alone, and with a maximal
// error that is tested. No libm: its results change with the machine. For bounds see math/bounds/interval_functions.h,
// for 60 digits math/exact.h.

#include "math/elementary/atan2.h"
#include "math/elementary/cosine_power.h"
#include "math/elementary/degrees.h"
#include "math/elementary/exp_log.h"
#include "math/elementary/pow.h"
