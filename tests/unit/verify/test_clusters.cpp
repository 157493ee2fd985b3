#include "verify/compare/clusters.h"

#include <doctest/doctest.h>

#include <limits>

using namespace refraster;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

Image<double> differences(int width, int height, std::vector<double> values) {
  Image<double> image(width, height, 1);
  REQUIRE(values.size() == image.values.size());
  image.values = std::move(values);
  return image;
}

} // namespace

TEST_CASE("pixels that touch, at a corner too, are one cluster; the largest comes first") {
  const auto found = clusters_over(differences(6, 4,
                                               {
                                                   1, 0, 0, 0, 0, 2, //
                                                   0, 3, 0, 0, 0, 0, //
                                                   0, 0, 4, 0, 0, 0, //
                                                   0, 0, 0, 0, 5, 5, //
                                               }),
                                   0);
  REQUIRE(found.size() == 3);
  CHECK(found[0].pixels == 3); // the diagonal
  CHECK(found[0].x == 0);
  CHECK(found[0].y == 0);
  CHECK(found[0].width == 3);
  CHECK(found[0].height == 3);
  CHECK(found[0].largest == 4);
  CHECK(found[0].worst_x == 2);
  CHECK(found[0].worst_y == 2);
  CHECK(found[1].pixels == 2);
  CHECK(found[1].x == 4);
  CHECK(found[1].worst_x == 4); // the first of two alike
  CHECK(found[2].pixels == 1);
  CHECK(found[2].x == 5);
  CHECK(found[2].y == 0);
}

TEST_CASE("what is not over the limit is in no cluster and joins none; infinity is over any") {
  const auto found = clusters_over(differences(5, 1, {3, 2, inf, 2, 2.5}), 2);
  REQUIRE(found.size() == 3);
  CHECK(found[0].x == 0);
  CHECK(found[1].x == 2);
  CHECK(found[1].largest == inf);
  CHECK(found[2].x == 4);
  CHECK(clusters_over(differences(2, 2, {0, 0, 0, 0}), 0).empty());
}

TEST_CASE("a whole image that differs is one cluster, however large") {
  const auto found = clusters_over(Image<double>(1500, 1000, 1, 7.0), 0);
  REQUIRE(found.size() == 1);
  CHECK(found[0].pixels == 1'500'000);
  CHECK(found[0].width == 1500);
  CHECK(found[0].height == 1000);
}
