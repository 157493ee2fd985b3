#include "bench/precision/measure.h"
#include <cstdio>
#include <cstdlib>
using namespace refraster::precision;
int main(int argc, char** argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 1000;
  for (const auto& r : measure_functions(n))
    std::printf("%-14s %-36s %8.3g %8.3g | %8.3g %8.3g  bounds %g %g | %g %g\n", std::string(r.function).c_str(), std::string(r.inputs).c_str(), r.double_ulp.max, r.double_ulp.mostly, r.float_ulp.max, r.float_ulp.mostly, r.double_bound.max, r.double_bound.mostly, r.float_bound.max, r.float_bound.mostly);
  for (const auto& r : measure_coordinates(n))
    std::printf("%-3s %-10s %-14s double %8.3g %8.3g float %8.3g %8.3g\n", std::string(r.bound.coordinate).c_str(), std::string(r.bound.method).c_str(), std::string(r.bound.inputs).c_str(), r.double_bins.max, r.double_bins.mostly, r.float_bins.max, r.float_bins.mostly);
  for (const auto& r : measure_shading(n))
    std::printf("%-20s %-16s dT %7.3g %7.3g fT %7.3g %7.3g | dR %7.3g %7.3g fR %7.3g %7.3g | f-d %8.2g %8.2g other %g %g\n", std::string(r.bound.model).c_str(), std::string(r.bound.inputs).c_str(), r.double_terms.max, r.double_terms.mostly, r.float_terms.max, r.float_terms.mostly, r.double_result.max, r.double_result.mostly, r.float_result.max, r.float_result.mostly, r.float_from_double.max, r.float_from_double.mostly, r.double_other_bin, r.float_other_bin);
}
