#pragma once
// What a test does for every precision, it does for these.

#include <refraster/frame.h>

namespace refraster::test {

inline constexpr Precision every_precision[] = {Precision::double_, Precision::float_, Precision::fast,
                                                Precision::exact};

} // namespace refraster::test
