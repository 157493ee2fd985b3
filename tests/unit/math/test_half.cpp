// Half precision, for storage.

#include "math/half.h"
#include "tests/support/for_all.h"

#include <cmath>

namespace refraster {
namespace {

Half with_bits(int bits) {
  return {static_cast<std::uint16_t>(bits)};
}

/// IEEE 754-2008, 3.4: what the bits of a finite half mean.
double meaning(int bits) {
  const int sign = bits >> 15, exponent = bits >> 10 & 31, fraction = bits & 1023;
  const double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return sign ? -size : size;
}

constexpr int finite_sizes = 31 << 10; // the patterns below infinity

template <int N>
void check_lanes_of(int first) {
  HalfLanes<N> halves;
  for (int lane = 0; lane < N; ++lane) halves[lane] = with_bits(first + lane).bits;
  const Wide<float, N> all = widened<N>(halves), plain = half_detail::plain_widened<N>(halves);
  for (int lane = 0; lane < N; ++lane) {
    const float alone = static_cast<float>(with_bits(first + lane));
    REQUIRE(std::bit_cast<std::int32_t>(all[lane]) == std::bit_cast<std::int32_t>(alone));
    REQUIRE(std::bit_cast<std::int32_t>(plain[lane]) == std::bit_cast<std::int32_t>(alone));
  }
}

} // namespace

TEST_CASE("every finite half means what the standard says") {
  for (const int sign : {0, 0x8000})
    for (int size = 0; size < finite_sizes; ++size) {
      const Half half = with_bits(sign | size);
      REQUIRE(static_cast<double>(static_cast<float>(half)) == meaning(half.bits));
    }
}

TEST_CASE("lanes widen every finite half with the same bits, with and without the instruction") {
  for (const int sign : {0, 0x8000})
    for (int size = 0; size < finite_sizes; size += 16) {
      check_lanes_of<4>(sign | size);
      check_lanes_of<8>(sign | size);
      check_lanes_of<16>(sign | size);
    }
}

TEST_CASE("rows of halves are gathered as rows of floats are") {
  for_all(200, [](Random& random) {
    std::array<Half, 256> halves;
    std::array<float, 256> floats;
    for (std::size_t i = 0; i < halves.size(); ++i) {
      halves[i] = with_bits((random.below(2) << 15) | random.below(finite_sizes));
      floats[i] = static_cast<float>(halves[i]);
    }
    const auto check = [&]<int N>(std::integral_constant<int, N>) {
      std::array<std::size_t, N> place;
      for (std::size_t& p : place) p = static_cast<std::size_t>(random.below(253));
      const auto read = gather_rows<Half, N>([&](int lane) { return &halves[place[static_cast<std::size_t>(lane)]]; });
      const auto expected =
          gather_rows<float, N>([&](int lane) { return &floats[place[static_cast<std::size_t>(lane)]]; });
      for (std::size_t row = 0; row < 4; ++row)
        for (int lane = 0; lane < N; ++lane) REQUIRE(read[row][lane] == expected[row][lane]);
    };
    check(std::integral_constant<int, 4>{});
    check(std::integral_constant<int, 8>{});
    check(std::integral_constant<int, 16>{});
  });
}

} // namespace refraster
