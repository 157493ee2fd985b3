// adversary EVALUATIONS [FIRST]: so many evaluations of fragment functions, in millions, by an adversary that looks for
// what lies outside of the bounds of a device: whose float rounds in any direction. Places are numbered from FIRST (0):
// another number, others. A line for each function; exit code 1 if anything lay outside.

#include "tests/unit/shading/adversary.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace refraster;
  constexpr int a_place = 3000; // evaluations
  constexpr double shift = 1e-5;
  const double millions = argc >= 2 ? std::atof(argv[1]) : 0;
  const int first = argc >= 3 ? std::atoi(argv[2]) : 0;
  const auto functions = tried_functions();
  const int places = static_cast<int>(millions * 1e6 / a_place / static_cast<double>(functions.size())) + 1;
  if (!(millions > 0 && millions < 1e6 && first >= 0 && argc <= 3)) {
    std::fprintf(stderr, "usage: adversary MILLIONS [FIRST]\n");
    return 2;
  }
  OperationErrors errors;
  errors.quotient_relative = errors.root_relative = 2 * errors.relative;
  errors.atan2_units = 4; // Vulkan's 2,048 would leave hardly anything known of what a table is read for
  DeviceArithmetic::use(errors);
  long evaluations = 0, outside = 0;
  for (const NamedFunction& tried : functions) {
    const Found found = search<DeviceArithmetic>(tried.function, first, places, a_place, shift);
    evaluations += found.evaluations, outside += found.outside;
    std::printf("%-40s %d places, %ld evaluations, %ld outside; nothing known of %ld; width over spread %.2f / %.2f\n",
                tried.name.c_str(), places, found.evaluations, found.outside, found.unknown, rank(found.ratio, 0.5),
                rank(found.ratio, 0.95));
    std::fflush(stdout);
  }
  std::printf("%ld evaluations, %ld outside\n", evaluations, outside);
  return outside == 0 ? 0 : 1;
}
