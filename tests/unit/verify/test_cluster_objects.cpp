#include "verify/compare/cluster_objects.h"

#include "verify/compare/clusters.h"

#include <refraster/mesh.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <memory>

using namespace refraster;

namespace {

template <class Value>
Image<Value> image_of(int width, int height, std::vector<Value> values) {
  Image<Value> image(width, height, 1);
  REQUIRE(values.size() == image.values.size());
  image.values = std::move(values);
  return image;
}

/// A triangle before a camera that looks at it: it covers the left lower half of the image.
Scene scene_of_triangle(std::vector<std::string> names) {
  Scene scene;
  scene.camera.position = {0, 0, 1};
  scene.camera.target = {0, 0, 0};
  scene.camera.fov_y_degrees = 90;
  for (std::string& name : names) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
    mesh->normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh->triangles = {{0, 1, 2}};
    Object object;
    object.name = std::move(name);
    object.mesh = mesh;
    scene.objects.push_back(object);
  }
  return scene;
}

} // namespace

TEST_CASE("the pixels of a cluster are those that hang together with its worst one") {
  const auto marked = image_of<std::uint8_t>(4, 3,
                                             {
                                                 1, 0, 0, 1, //
                                                 0, 1, 0, 1, //
                                                 0, 0, 0, 0, //
                                             });
  const auto differences = image_of<double>(4, 3, {1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 0, 0});
  const auto clusters = clusters_of(marked, differences);
  REQUIRE(clusters.size() == 2);
  const auto sorted = [&](const Cluster& cluster) {
    auto pixels = cluster_pixels(marked, cluster);
    std::sort(pixels.begin(), pixels.end());
    return pixels;
  };
  using Pixels = std::vector<std::pair<int, int>>;
  CHECK(sorted(clusters[0]) == Pixels{{0, 0}, {1, 1}});
  CHECK(sorted(clusters[1]) == Pixels{{3, 0}, {3, 1}});
}

TEST_CASE("a cluster without any difference has its worst pixel within it") {
  const auto marked = image_of<std::uint8_t>(3, 1, {0, 0, 1});
  const auto clusters = clusters_of(marked, Image<double>(3, 1, 1));
  REQUIRE(clusters.size() == 1);
  CHECK(clusters[0].worst_x == 2);
  CHECK(cluster_pixels(marked, clusters[0]).size() == 1);
}

TEST_CASE("a cluster is named by what its own pixels see, most first, and not by its rectangle") {
  const auto marked = image_of<std::uint8_t>(3, 3, {1, 1, 1, 1, 0, 0, 1, 0, 1});
  const Image<double> differences(3, 3, 1, 1.0);
  SeenObjects seen;
  seen.names = {"cube", "floor"};
  seen.object = image_of<std::uint32_t>(3, 3, {2, 2, 0, 2, 1, 1, 1, 1, 1});
  const auto clusters = clusters_of(marked, differences);
  REQUIRE(clusters.size() == 2);
  CHECK(cluster_objects(marked, clusters[0], seen) == ObjectCounts{{"floor", 3}, {"background", 1}, {"cube", 1}});
  CHECK(cluster_objects(marked, clusters[1], seen) == ObjectCounts{{"cube", 1}});
}

TEST_CASE("objects of one name are told apart by their numbers, counted from 1") {
  using Names = std::vector<std::string>;
  CHECK(object_labels(scene_of_triangle({"cube", "floor"})) == Names{"cube", "floor"});
  CHECK(object_labels(scene_of_triangle({"cube", "floor", "cube", ""})) ==
        Names{"cube (object 1)", "floor", "cube (object 3)", "object 4"});
}

TEST_CASE("what pixels see is the scene at the images' size") {
  const SeenObjects seen = seen_objects(scene_of_triangle({"half"}), 6, 6);
  CHECK(seen.names == std::vector<std::string>{"half"});
  REQUIRE(seen.object.width == 6);
  CHECK(*seen.object.at(0, 5) == 1);
  CHECK(*seen.triangle.at(0, 5) == 1);
  CHECK(*seen.object.at(5, 0) == 0);
  CHECK(*seen.triangle.at(5, 0) == 0);
}

TEST_CASE("numbers of an AOV that are none are 0") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  CHECK(ids_of(image_of<float>(5, 1, {3, -1, nan, inf, 16777216})).values ==
        std::vector<std::uint32_t>{3, 0, 0, 0, 16777216});
}
