#pragma once
// What cycles are measured with.

namespace refraster::bench {

/// How fast the processor's time stamp counter runs, in GHz, measured against the wall clock for a few milliseconds; 0
/// where there is none. It counts at one rate whatever the cores' clock is: cycles by it are reference cycles, a
/// measure of time.
double time_stamp_ghz();

} // namespace refraster::bench
