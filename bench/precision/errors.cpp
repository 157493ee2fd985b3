#include "bench/precision/errors.h"

#include <cstdio>

namespace refraster::precision {

std::string hex(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%a", x);
  return buffer;
}

std::string hex(const Double3& a) {
  std::string all = hex(a.x);
  for (const double x : {a.y, a.z}) all += ", " + hex(x);
  return '(' + all + ')';
}

} // namespace refraster::precision
