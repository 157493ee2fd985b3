// One target as libFuzzer calls it. The build says which.

#include "tests/long/fuzz/targets.h"

#include <cstddef>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  refraster::fuzz::REFRASTER_FUZZ_TARGET({data, size});
  return 0;
}
