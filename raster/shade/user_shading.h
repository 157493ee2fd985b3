#pragma once
// Fragments shaded by a fragment function of the user's: written to plain arrays, and read back.

#include <refraster/scene.h>

#include "shading/user_function.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace refraster {

/// Does what sum_light does, by a function that is not known here. Holds scratch memory; one for each thread.
template <class T>
class UserShading {
public:
  void sum_light(const Scene& scene, const UserFunction& function, PacketBatch<T>& batch, UndefinedCounts& counts) {
    std::uint32_t fragments = 0;
    for (int i = 0; i < batch.packets; ++i)
      fragments += static_cast<std::uint32_t>(count_lanes(batch.in_use[static_cast<std::size_t>(i)]));
    FragmentBatch asked;
    asked.wanted = FragmentBatch::Wanted::radiance;
    asked.fragments = fragments;
    asked.lights = light_spans(scene);
    asked.undefined = &counts;
    asked.visibility = batch.visibility;
    ask(function, asked, {batch.surface.data(), static_cast<std::size_t>(batch.packets)}, batch.sum.data());
  }

  /// The colour for the AOV of that name, of one packet.
  Rgb<T> albedo(const UserFunction& function, const PacketSurface<T>& surface) {
    FragmentBatch asked;
    asked.wanted = FragmentBatch::Wanted::albedo;
    asked.fragments = lanes;
    Rgb<T> result(T(0));
    ask(function, asked, {&surface, 1}, &result);
    return result;
  }

private:
  static constexpr auto lanes = static_cast<std::uint32_t>(NumberTraits<T>::lanes);

  void ask(const UserFunction& function, FragmentBatch& asked, std::span<const PacketSurface<T>> surfaces,
           Rgb<T>* results) {
    if constexpr (!BatchedNumber<T>) {
      throw std::invalid_argument("a number of one's own cannot shade \"" + std::string(function.name()) +
                                  "\", a fragment function of one's own");
    } else {
      using Traits = BatchTraits<T>;
      constexpr std::uint32_t padding = FragmentBatch::padding;
      asked.number = Traits::number;
      asked.stride = (static_cast<std::uint32_t>(surfaces.size()) * lanes + padding - 1) / padding * padding;
      values_.resize(std::size_t{FragmentBatch::rows} * asked.stride);
      rgb_.resize(std::size_t{3} * asked.stride);
      for (std::size_t p = 0; p < surfaces.size(); ++p) {
        const PacketSurface<T>& s = surfaces[p];
        const Vec3<T>* const vectors[] = {&s.position, &s.normal, &s.to_eye, &s.texture};
        for (std::size_t row = 0; row < FragmentBatch::rows; ++row)
          Traits::store((*vectors[row / 3])[static_cast<int>(row % 3)], &values_[row * asked.stride + p * lanes]);
      }
      asked.values = values_.data(), asked.rgb = rgb_.data();
      function.shade(asked);
      for (std::size_t p = 0; p < surfaces.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
          results[p][static_cast<int>(c)] = Traits::load(&rgb_[c * asked.stride + p * lanes]);
    }
  }

  template <class U>
  struct StoredOf {
    using type = char;
  };
  template <BatchedNumber U>
  struct StoredOf<U> {
    using type = typename BatchTraits<U>::Stored;
  };
  std::vector<typename StoredOf<T>::type> values_, rgb_;
};

} // namespace refraster
