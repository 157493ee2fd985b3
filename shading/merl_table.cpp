#include "shading/merl_table.h"

#include "math/elementary.h"

#include <cassert>
#include <limits>
#include <utility>

namespace refraster {

namespace {

double unchanged(double f) {
  return f;
}

double logarithm(double f) {
  return log2(1 + f / MerlTable::log_epsilon);
}

} // namespace

MerlTable::MerlTable(PaddedVector<double> rgb) : doubles_(std::move(rgb)) {
  assert(doubles_.size() == 3 * samples);
}

template <class F>
const F* MerlTable::made_once(Copy<F>& copy, double (*encode)(double)) const {
  std::call_once(copy.made, [&] {
    copy.values.resize(doubles_.size());
    for (std::size_t i = 0; i < doubles_.size(); i += 3) {
      const bool measured = doubles_[i] >= 0 && doubles_[i + 1] >= 0 && doubles_[i + 2] >= 0;
      for (std::size_t channel = i; channel < i + 3; ++channel) {
        const double value = measured ? encode(doubles_[channel]) : -1;
        copy.values[channel] = static_cast<F>(minimum(value, static_cast<double>(std::numeric_limits<F>::max())));
      }
    }
  });
  return copy.values.data();
}

template <>
const double* MerlTable::values<double>() const {
  return doubles_.data();
}
template <>
const float* MerlTable::values<float>() const {
  return made_once(floats_, unchanged);
}
template <>
const double* MerlTable::log_values<double>() const {
  return made_once(log_doubles_, logarithm);
}
template <>
const float* MerlTable::log_values<float>() const {
  return made_once(log_floats_, logarithm);
}

} // namespace refraster
