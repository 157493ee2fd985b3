#include <refraster/material.h>

#include "math/elementary.h"
#include "math/half_of.h"

#include <limits>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace refraster {

namespace {

bool is_measured(const double* rgb) {
  return rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0;
}

template <class Stored>
constexpr double largest = static_cast<double>(std::numeric_limits<Stored>::max());
template <>
constexpr double largest<Half> = Half::largest;

template <class Stored>
Stored rounded(double x) {
  if constexpr (std::is_same_v<Stored, Half>) return half_of(x);
  else return static_cast<Stored>(x);
}

/// Every measured value encoded and rounded once to Stored; the others as -1.
template <class Stored, class Encode>
void encode_all(const PaddedVector<double>& rgb, const Encode& encode, PaddedVector<Stored>& stored) {
  stored.resize(rgb.size());
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    const bool measured = is_measured(&rgb[i]);
    for (std::size_t channel = i; channel < i + 3; ++channel)
      stored[channel] = rounded<Stored>(measured ? min(encode(rgb[channel]), largest<Stored>) : -1);
  }
}

double unchanged(double f) {
  return f;
}

double logarithm(double f) {
  return log2(1 + f / MerlTable::log_epsilon);
}

/// The least power of two in which the greatest value is not beyond the largest half. Within float, as lanes are.
double unit_of(const PaddedVector<double>& rgb) {
  double greatest = 0;
  for (std::size_t i = 0; i < rgb.size(); i += 3)
    if (is_measured(&rgb[i])) greatest = max(greatest, max(rgb[i], max(rgb[i + 1], rgb[i + 2])));
  double unit = 0x1p-100;
  while (greatest > Half::largest * unit && unit < 0x1p100) unit *= 2;
  return unit;
}

} // namespace

struct MerlTable::Copies {
  template <class Stored>
  struct Copy {
    std::once_flag made;
    PaddedVector<Stored> values;
    double unit = 1;
  };
  Copy<float> floats, log_floats;
  Copy<double> log_doubles;
  Copy<Half> halves;
};

MerlTable::MerlTable(PaddedVector<double> rgb) : doubles_(std::move(rgb)), copies_(std::make_unique<Copies>()) {
  if (doubles_.size() != 3 * samples)
    throw std::invalid_argument("MerlTable: found " + std::to_string(doubles_.size()) + " values, expected " +
                                std::to_string(3 * samples));
}

MerlTable::~MerlTable() = default;

template <>
const double* MerlTable::values<double>() const {
  return doubles_.data();
}
template <>
const float* MerlTable::values<float>() const {
  std::call_once(copies_->floats.made, [this] { encode_all(doubles_, unchanged, copies_->floats.values); });
  return copies_->floats.values.data();
}
template <>
const Half* MerlTable::values<Half>() const {
  std::call_once(copies_->halves.made, [this] {
    const double unit = copies_->halves.unit = unit_of(doubles_);
    encode_all(
        doubles_, [unit](double f) { return f / unit; }, copies_->halves.values);
  });
  return copies_->halves.values.data();
}

template <>
double MerlTable::unit<double>() const {
  return 1;
}
template <>
double MerlTable::unit<float>() const {
  return 1;
}
template <>
double MerlTable::unit<Half>() const {
  values<Half>();
  return copies_->halves.unit;
}

template <>
const double* MerlTable::log_values<double>() const {
  std::call_once(copies_->log_doubles.made, [this] { encode_all(doubles_, logarithm, copies_->log_doubles.values); });
  return copies_->log_doubles.values.data();
}
template <>
const float* MerlTable::log_values<float>() const {
  std::call_once(copies_->log_floats.made, [this] { encode_all(doubles_, logarithm, copies_->log_floats.values); });
  return copies_->log_floats.values.data();
}

} // namespace refraster
