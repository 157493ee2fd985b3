#include "io/html/scale.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

std::vector<std::string> labels(const Scale& scale) {
  std::vector<std::string> words;
  for (const Tick& tick : scale.ticks()) words.push_back(tick.label);
  return words;
}

} // namespace

TEST_CASE("an axis begins and ends at round numbers around what it shows") {
  const Scale linear = Scale::around(Scale::Kind::linear, 0, 43, 100, 200);
  CHECK(labels(linear) == std::vector<std::string>{"0", "10", "20", "30", "40", "50"});
  CHECK(linear(0) == 100);
  CHECK(linear(25) == 150);
  const Scale logarithmic = Scale::around(Scale::Kind::logarithmic, 3, 90, 0, 1);
  CHECK(labels(logarithmic) == std::vector<std::string>{"2", "5", "10", "20", "50", "100"});
  CHECK(logarithmic(2) == 0);
  CHECK(logarithmic(100) == doctest::Approx(1));
  const Scale decades = Scale::around(Scale::Kind::logarithmic, 1e-16, 1e-7, 0, 1);
  CHECK(decades.from() <= 1e-16 * 1.05);
  CHECK(decades.to() >= 1e-7);
  const Scale whole = Scale::around(Scale::Kind::whole, 1, 3, 0, 1);
  CHECK(labels(whole) == std::vector<std::string>{"1", "2", "3"});
  CHECK(whole(2) == doctest::Approx(0.5));
  const Scale from_0 = Scale::around(Scale::Kind::whole, 1, 8, 0, 80); // in steps of 2
  CHECK(labels(from_0) == std::vector<std::string>{"0", "2", "4", "6", "8"});
  CHECK(from_0(1) == doctest::Approx(10));
}

TEST_CASE("an axis for one value has two ends") {
  for (const Scale::Kind kind : {Scale::Kind::linear, Scale::Kind::whole, Scale::Kind::logarithmic}) {
    const Scale scale = Scale::around(kind, 10, 10, 0, 1);
    CHECK(scale.ticks().size() >= 2);
    CHECK(scale.from() < scale.to());
  }
}
