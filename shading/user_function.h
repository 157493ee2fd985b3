#pragma once
// A fragment function of one's own, from its block of parameters and its formula.

#include <refraster/material.h>

#include "math/bounds/interval_functions.h"
#include "math/exact.h"
#include "math/precisions.h"
#include "shading/fragment_batch.h"
#include "shading/sum_light.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace refraster::inline REFRASTER_KIT {

/// How a batch holds numbers of T: `Stored` in memory, its number, and as many fragments of it as one T holds.
template <class T>
struct BatchTraits;

template <class F, int N, Arithmetic arithmetic>
struct BatchTraits<Wide<F, N, arithmetic>> {
  using T = Wide<F, N, arithmetic>;
  using Stored = F;
  static constexpr BatchNumber number = std::is_same_v<F, double> ? BatchNumber::double_lanes
                                        : is_fast<T>              ? BatchNumber::fast_lanes
                                                                  : BatchNumber::float_lanes;
  static T load(const Stored* at) {
    T x;
    std::memcpy(&x, at, sizeof x);
    return x;
  }
  static void store(const T& x, Stored* at) { std::memcpy(at, &x, sizeof x); }
  static MaskOf<T> first(std::uint32_t count) { return first_lanes<F, N>(static_cast<int>(count)); }
};

template <>
struct BatchTraits<Exact> {
  using Stored = Exact::Value;
  static constexpr BatchNumber number = BatchNumber::exact;
  static Exact load(const Stored* at) { return Exact(*at); }
  static void store(const Exact& x, Stored* at) { *at = x.value(); }
  static bool first(std::uint32_t count) { return count > 0; }
};

template <class Budget>
  requires(std::is_same_v<Budget, DoubleArithmetic> || std::is_same_v<Budget, FloatArithmetic>)
struct BatchTraits<Interval<Budget>> {
  struct Stored {
    double lo, hi;
  };
  static constexpr BatchNumber number =
      std::is_same_v<Budget, DoubleArithmetic> ? BatchNumber::double_bounds : BatchNumber::float_bounds;
  static Interval<Budget> load(const Stored* at) { return {at->lo, at->hi}; }
  static void store(const Interval<Budget>& x, Stored* at) { *at = {x.lo, x.hi}; }
  static Certainty first(std::uint32_t count) { return count > 0 ? Certainty::yes : Certainty::no; }
};

/// Whether a fragment function of one's own can be asked in T.
template <class T>
concept BatchedNumber = requires {
  BatchTraits<T>::number;
};

namespace user_function_detail {

/// Shows parameters as FieldVisitor takes them.
struct Shown {
  FieldVisitor& visitor;

  template <class Value>
  void operator()(std::string_view name, Value& value, const Range& range, std::string_view meaning) const {
    if constexpr (NamedEnum<Value>) {
      NamedValue named;
      for (const auto& [listed, word] : EnumNames<Value>::names) {
        if (listed == value) named.index = named.names.size();
        named.names.push_back(word);
      }
      visitor.field(name, named, range, meaning);
      value = EnumNames<Value>::names[named.index].first;
    } else {
      visitor.field(name, value, range, meaning);
    }
  }
};

template <class T, class Function>
void shade_in(const Function& function, const FragmentBatch& batch) {
  using Traits = BatchTraits<T>;
  constexpr auto lanes = static_cast<std::uint32_t>(NumberTraits<T>::lanes);
  const auto* const values = static_cast<const typename Traits::Stored*>(batch.values);
  auto* const rgb = static_cast<typename Traits::Stored*>(batch.rgb);
  const auto vector = [&](int row, std::uint32_t i) {
    const auto* at = values + static_cast<std::size_t>(row) * batch.stride + i;
    return Vec3<T>(Traits::load(at), Traits::load(at + batch.stride), Traits::load(at + 2 * batch.stride));
  };
  const auto put = [&](std::uint32_t i, const Rgb<T>& sum) {
    for (int c = 0; c < 3; ++c) Traits::store(sum[c], rgb + static_cast<std::size_t>(c) * batch.stride + i);
  };
  if (batch.wanted == FragmentBatch::Wanted::albedo) {
    for (std::uint32_t i = 0; i < batch.fragments; i += lanes)
      put(i, albedo<T>(function, vector(FragmentBatch::texture, i)));
    return;
  }
  PacketBatch<T> packets;
  for (std::uint32_t first = 0; first < batch.fragments; first += lanes * PacketBatch<T>::capacity) {
    packets.packets = 0;
    const std::uint32_t end = std::min(batch.fragments, first + lanes * PacketBatch<T>::capacity);
    for (std::uint32_t i = first; i < end; i += lanes) {
      const auto p = static_cast<std::size_t>(packets.packets++);
      packets.surface[p] = {vector(FragmentBatch::position, i), vector(FragmentBatch::normal, i),
                            vector(FragmentBatch::to_eye, i), vector(FragmentBatch::texture, i)};
      packets.in_use[p] = Traits::first(std::min(lanes, end - i));
    }
    packets.visibility = batch.visibility.from(first);
    sum_light(batch.lights, function, packets, *batch.undefined);
    for (std::uint32_t i = first; i < end; i += lanes) put(i, packets.sum[(i - first) / lanes]);
  }
}

template <class Function>
class UserFunctionOf final : public UserFunction {
public:
  explicit UserFunctionOf(Function function) : function_(std::move(function)) {}

  std::string_view name() const override { return Function::name; }
  void fields(FieldVisitor& visitor) override { Function::fields(function_, Shown{visitor}); }
  std::shared_ptr<UserFunction> copy() const override { return std::make_shared<UserFunctionOf>(function_); }
  void shade(const FragmentBatch& batch) const override {
    switch (batch.number) {
    case BatchNumber::double_lanes:
      return shade_in<DoublePrecision::Number>(function_, batch);
    case BatchNumber::float_lanes:
      return shade_in<FloatPrecision::Number>(function_, batch);
    case BatchNumber::fast_lanes:
      return shade_in<FastPrecision::Number>(function_, batch);
    case BatchNumber::exact:
      return shade_in<Exact>(function_, batch);
    case BatchNumber::double_bounds:
      return shade_in<Interval<DoubleArithmetic>>(function_, batch);
    case BatchNumber::float_bounds:
      return shade_in<Interval<FloatArithmetic>>(function_, batch);
    }
    throw std::invalid_argument(std::string(name()) + ": is not compiled for number " +
                                std::to_string(static_cast<int>(batch.number)));
  }

private:
  Function function_;
};

} // namespace user_function_detail

/// A fragment function of one's own, for Material::user_function and SceneOptions::user_functions. Function is a block
/// of parameters like Phong in <refraster/material.h>: copyable, with
///     static constexpr std::string_view name;              the word in "fragment_function"
///     static void fields(auto& self, auto&& field);        each parameter: <refraster/fields.h>
/// and with these, in its own namespace, for every Number T:
///     Rgb<T> ambient(const Function&, const Fragment<T>&);                        without any light
///     Rgb<T> reflected(const Function&, const Fragment<T>&, const Incident<T>&);  from one light
/// Compiles them for every precision and for bounds.
template <class Function>
std::shared_ptr<UserFunction> user_function(Function function = {}) {
  return std::make_shared<user_function_detail::UserFunctionOf<Function>>(std::move(function));
}

/// The formula by itself, for values worked out by hand: radiance from one light, in the arithmetic of the precision
/// `double`.
template <class Function>
Double3 reflected_value(const Function& function, const Fragment<double>& at, const Incident<double>& light) {
  using T = DoublePrecision::Number;
  const Fragment<T> lanes{Vec3<T>(at.position), Vec3<T>(at.normal), Vec3<T>(at.to_eye), Rgb<T>(at.texture), nullptr};
  const Rgb<T> rgb = reflected(function, lanes, Incident<T>{Vec3<T>(light.direction), Rgb<T>(light.radiance)});
  return {rgb.x[0], rgb.y[0], rgb.z[0]};
}

} // namespace refraster::inline REFRASTER_KIT
