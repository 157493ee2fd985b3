// Normals that are computed: which faces share one, what cancels, and what counts.

#include <refraster/notes.h>

#include "io/mesh/obj_file.h"
#include "tests/support/for_all.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

namespace refraster::test {
namespace {

Mesh mesh_of(const std::string& text, const MeshNormals& normals = {}) {
  return mesh_of_obj("m.obj", text, {normals, nullptr});
}

constexpr MeshNormals smooth{NormalsFrom::smooth}, flat{NormalsFrom::flat};
MeshNormals crease(double degrees) {
  return {NormalsFrom::crease, degrees};
}

using Key = std::tuple<float, float, float>;
Key key(const Float3& a) {
  return {a.x, a.y, a.z};
}

/// The different normals at each place.
std::map<Key, std::set<Key>> normals_at(const Mesh& mesh) {
  std::map<Key, std::set<Key>> result;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) result[key(mesh.positions[i])].insert(key(mesh.normals[i]));
  return result;
}

/// The normal at the corner of a triangle.
Float3 normal_at(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
  return mesh.normals[mesh.triangles[triangle][corner]];
}

/// 180 for a normal that is none.
double degrees_between(const Float3& a, const Double3& b) {
  const Double3 n = Double3(a);
  if (a == Float3(0)) return 180;
  return std::atan2(length(cross(n, b)), dot(n, b)) * 180 / 3.14159265358979323846;
}

std::string vertex(const Double3& p) {
  std::ostringstream text;
  text.precision(17); // so that it is rounded once, by the reader
  text << "v " << p.x << " " << p.y << " " << p.z << "\n";
  return text.str();
}

/// A turn by no round angle about no axis.
Double3 askew(const Double3& p) {
  const Double3 x(0.36, 0.48, -0.8), y(-0.8, 0.6, 0), z(0.48, 0.64, 0.6);
  const Double3 a = x * p.x + y * p.y + z * p.z;
  const double c = std::cos(0.7), s = std::sin(0.7);
  return {a.x, c * a.y - s * a.z, s * a.y + c * a.z};
}

/// A sheet of n x n quads, one row of vertices after the other, in waves, turned askew.
std::string sheet_vertices(int n, const Double3& offset = Double3(0)) {
  std::string text;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) text += vertex(askew({0.1 * i, 0.1 * j, 0.03 * std::sin(1.0 * i + 0.7 * j)}) + offset);
  return text;
}

enum class Cut { quads, one_diagonal, other_diagonal };
enum class Side { front, back };

/// Its faces; `first`: which corner comes first.
std::string sheet_faces(int n, Cut cut, Side side, std::size_t first = 0) {
  std::string text;
  const auto face = [&](std::vector<int> corners) {
    if (side == Side::back) std::reverse(corners.begin(), corners.end());
    text += "f";
    for (std::size_t k = 0; k < corners.size(); ++k)
      text += " " + std::to_string(corners[(k + first) % corners.size()]);
    text += "\n";
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = 1 + j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (cut == Cut::quads) face({a, b, c, d});
      if (cut == Cut::one_diagonal) face({a, b, c}), face({a, c, d});
      if (cut == Cut::other_diagonal) face({a, b, d}), face({b, c, d});
    }
  return text;
}

std::string cube_vertices(double half, Double3 (*place)(const Double3&)) {
  std::string text;
  for (int i = 0; i < 8; ++i) text += vertex(place({i & 4 ? half : -half, i & 2 ? half : -half, i & 1 ? half : -half}));
  return text;
}
const std::string cube_faces = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

Double3 as_it_is(const Double3& p) {
  return p;
}

/// On axes that are orthogonal, 7 long, and whole numbers.
Double3 on_sevenths(const Double3& p) {
  return Double3(2, 3, 6) * p.x + Double3(3, -6, 2) * p.y + Double3(6, 2, -3) * p.z;
}

/// A prism on n corners about the z axis, without its base.
std::string prism(int n) {
  std::string text, top = "f", sides;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    text += vertex({std::cos(angle), std::sin(angle), 0}) + vertex({std::cos(angle), std::sin(angle), 1});
    const int a = 2 * i + 1, b = 2 * ((i + 1) % n) + 1;
    top += " " + std::to_string(a + 1);
    sides += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(b + 1) + " " +
             std::to_string(a + 1) + "\n";
  }
  return text + top + "\n" + sides;
}

} // namespace

TEST_CASE("of a sheet whose faces are there twice, once each way round, all normals cancel: they are 0") {
  // Also where the back is listed from other corners, and where its quads are cut along other diagonals: flat sheets
  // only, since in waves these are other surfaces.
  const std::string in_waves = sheet_vertices(8);
  for (const Cut cut : {Cut::quads, Cut::one_diagonal})
    for (const std::size_t first : {0u, 1u, 2u}) {
      const Mesh mesh =
          mesh_of(in_waves + sheet_faces(8, cut, Side::front) + sheet_faces(8, cut, Side::back, first), smooth);
      for (const Float3& n : mesh.normals) CHECK(n == Float3(0));
    }
  for_all(50, [](Random& random) {
    std::string text;
    const Double3 origin(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const auto any = [&] { return random.uniform(-1, 1); };
    const Double3 right(any(), any(), any()), up(any(), any(), any());
    if (length(cross(right, up)) < 0.3) return;
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i <= 3; ++i) text += vertex(origin + right * (1.0 * i) + up * (1.0 * j));
    const Mesh mesh = mesh_of(text + "s 7\n" + sheet_faces(3, Cut::one_diagonal, Side::front) +
                              sheet_faces(3, Cut::quads, Side::back, 1));
    // At the corners of the sheet the front's two triangles take the quad's angle; everywhere they add up to it.
    for (const Float3& n : mesh.normals) CHECK(n == Float3(0));
  });
}

TEST_CASE("a sheet that is there three times, twice one way round, has the normals of that way") {
  const std::string once = sheet_faces(6, Cut::one_diagonal, Side::front);
  const Mesh mesh =
                 mesh_of(sheet_vertices(6) + "s 1\n" + once + once + sheet_faces(6, Cut::one_diagonal, Side::back, 2)),
             single = mesh_of(sheet_vertices(6) + "s 1\n" + once);
  REQUIRE(mesh.normals.size() == single.normals.size());
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    CHECK(degrees_between(mesh.normals[i], Double3(single.normals[i])) < 1e-3);
}

TEST_CASE("the normal along the rim of a thin wedge is no rounding: it points away from it") {
  // Two rectangles that enclose 1e-4 radians, about an edge on the x axis: by symmetry the normal there is -y.
  const std::string wedge = "v 0 0 0\nv 1 0 0\nv 1 1 0.00005\nv 0 1 0.00005\nv 1 1 -0.00005\nv 0 1 -0.00005\n"
                            "f 1 2 3 4\nf 1 6 5 2\n";
  const Mesh mesh = mesh_of(wedge, smooth);
  CHECK(degrees_between(normal_at(mesh, 0, 0), {0, -1, 0}) < 1);
  CHECK(degrees_between(normal_at(mesh, 0, 1), {0, -1, 0}) < 1);
}

TEST_CASE("by crease each side of a sheet that is there twice has its own normals") {
  const std::string front = sheet_faces(5, Cut::one_diagonal, Side::front);
  const Mesh both = mesh_of(sheet_vertices(5) + front + sheet_faces(5, Cut::one_diagonal, Side::back, 1)),
             one = mesh_of(sheet_vertices(5) + front);
  REQUIRE(both.triangles.size() == 2 * one.triangles.size());
  for (std::size_t t = 0; t < one.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) CHECK(normal_at(both, t, k) == normal_at(one, t, k));
  for (const auto& [place, list] : normals_at(both)) {
    REQUIRE(list.size() == 2);
    const auto [a, b] = std::pair(*list.begin(), *list.rbegin());
    CHECK(degrees_between(std::make_from_tuple<Float3>(a), -Double3(std::make_from_tuple<Float3>(b))) < 1e-4);
  }
}

TEST_CASE("a corner that is named twice, or stands twice in one place, counts once") {
  // A ridge: by symmetry the normals of its two vertices are (0, 0, 1), if both faces take a right angle there.
  const std::string ridge = "v -1 -1 -1\nv 0 -1 0\nv 0 1 0\nv 1 -1 -1\nv 0 1 0\nv 0 1.00000001 1e-9\n";
  const Mesh plain = mesh_of(ridge + "f 1 2 3\nf 2 4 3\n", smooth);
  CHECK(degrees_between(normal_at(plain, 0, 2), {0, 0, 1}) < 1e-5);
  for (const char* const face :
       {"f 1 2 3 3\n", "f 3 1 2 3\n", "f 3 3 1 2\n", "f 1 2 3 3 3\n", "f 1 1 2 3\n", "f 1 2 2 3\n", "f 1 1 2 2 3 3\n",
        "f 1 2 3 5\n", "f 1 2 5 3\n", "f 1 2 3 6\n", "f 1 2 5 3 6 3\n"}) {
    CAPTURE(face);
    const Mesh mesh = mesh_of(ridge + face + "f 2 4 3\n", smooth);
    const std::size_t last = mesh.triangles.size() - 1;
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(degrees_between(normal_at(mesh, last, k), Double3(normal_at(plain, 1, k))) < 1e-4);
  }
}

TEST_CASE("a sphere whose pole faces are quads that name the pole twice is the sphere of triangles") {
  constexpr int segments = 16;
  std::string points = "v 0 1 0\n", triangles, quads, split;
  for (int ring = 1; ring <= 3; ++ring)
    for (int i = 0; i < segments; ++i) {
      const double a = 2 * 3.14159265358979323846 * i / segments, polar = 0.4 * ring;
      points += vertex({std::sin(polar) * std::cos(a), std::cos(polar), -std::sin(polar) * std::sin(a)});
    }
  std::string poles;
  for (int i = 0; i < segments; ++i) {
    poles += "v 0 1 0\n";
    const auto at = [](int ring, int k) { return " " + std::to_string(2 + ring * segments + k % segments); };
    const auto pole = [](int k) { return " " + std::to_string(2 + 3 * segments + k % segments); };
    triangles += "f 1" + at(0, i) + at(0, i + 1) + "\n";
    quads += "f 1" + at(0, i) + at(0, i + 1) + " 1\n";
    split += "f" + pole(i) + at(0, i) + at(0, i + 1) + pole(i + 1) + "\n";
    for (std::string* const faces : {&triangles, &quads, &split})
      for (const int ring : {0, 1})
        *faces += "f" + at(ring, i) + at(ring + 1, i) + at(ring + 1, i + 1) + at(ring, i + 1) + "\n";
  }
  for (const MeshNormals& normals : {MeshNormals{}, smooth}) {
    const auto of_triangles = normals_at(mesh_of(points + triangles, normals));
    CHECK(normals_at(mesh_of(points + quads, normals)) == of_triangles);
    for (const auto& [place, list] : normals_at(mesh_of(points + poles + split, normals)))
      if (place == Key(0, 1, 0)) { // each of two neighbouring faces, which lean 0.2 radians
        CHECK(list.size() == segments);
        for (const auto& [x, y, z] : list) CHECK(degrees_between({x, y, z}, {0, 1, 0}) < 12);
      } else {
        CHECK(list == of_triangles.at(place));
      }
  }
}

TEST_CASE("a needle that fills a T-junction has no say in the normals around it") {
  // A wall on z = 0 whose lower edge has a vertex between; a needle of rounding's height fills the gap. It could face
  // anywhere, and takes half a turn at that vertex.
  for_all(100, [](Random& random) {
    const double at = random.uniform(0.2, 0.8);
    const std::string points = vertex(askew({-1, 1, 0})) + vertex(askew({-1, -1, 0})) +
                               vertex(askew({2 * at - 1, -1, 0})) + vertex(askew({1, -1, 0})) +
                               vertex(askew({1, 1, 0})) + vertex(askew({0, -2, 0}));
    const Mesh mesh = mesh_of(points + "s 1\nf 1 2 4 5\nf 2 3 4\nf 2 6 3\nf 3 6 4\n");
    const Double3 n = cross(askew({1, 0, 0}), askew({0, 1, 0}));
    for (const Float3& found : mesh.normals) CHECK(degrees_between(found, n) < 1e-3);
  });
}

TEST_CASE("an edge that runs out and back along itself is no whole turn") {
  // At the tip, which a wall shares, the spur takes no angle: the normal is the wall's. On its way back the spur has a
  // vertex that lies on the way out but for the rounding of its coordinates.
  for_all(100, [](Random& random) {
    const double tip = random.uniform(1.2, 3), back = random.uniform(1.05, 1.15);
    const std::string points = vertex(askew({0, 0, 0})) + vertex(askew({1, 0, 0})) + vertex(askew({1, 1, 0})) +
                               vertex(askew({0, 1, 0})) + vertex(askew({tip, 1, 0})) + vertex(askew({tip, 1, 1})) +
                               vertex(askew({tip + 1, 1, 0})) + vertex(askew({back, 1, 0}));
    for (const char* const spur : {"f 1 2 3 5 3 4\n", "f 1 2 3 5 8 4\n"}) {
      const Mesh mesh = mesh_of(points + "s 1\n" + spur + "f 5 6 7\n");
      const Double3 wall = cross(askew({0, 0, 1}), askew({1, 0, 0}));
      CHECK(degrees_between(normal_at(mesh, mesh.triangles.size() - 1, 0), wall) < 1e-3);
    }
  });
}

TEST_CASE("with neither vn nor s, a cube has six normals along the axes, and a prism of seven sides flat ones") {
  const Mesh cube = mesh_of(cube_vertices(1, as_it_is) + cube_faces);
  CHECK(cube.positions.size() == 24);
  const std::set<Key> axes = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::set<Key> found;
  for (const Float3& n : cube.normals) found.insert(key(n));
  CHECK(found == axes);
  for (const auto& [place, list] : normals_at(mesh_of(prism(7))))
    CHECK(list.size() == (std::get<2>(place) == 0 ? 2 : 3));
  // 360 / 8 = 45 degrees: the side is round, the lid sharp.
  for (const auto& [place, list] : normals_at(mesh_of(prism(8)))) {
    const auto [x, y, z] = place;
    CHECK(list.size() == (z == 0 ? 1 : 2));
    for (const auto& [nx, ny, nz] : list)
      CHECK(degrees_between({nx, ny, nz}, nz > 0.5f ? Double3(0, 0, 1) : Double3(Float3(x, y, 0))) < 1e-4);
  }
}

TEST_CASE("a crease of 90 degrees rounds every edge of a cube, wherever it stands, and one of 89.999 none") {
  for (const auto place : {as_it_is, askew}) {
    const std::string cube = cube_vertices(0.7, place) + cube_faces;
    CHECK(mesh_of(cube, crease(90.001)).positions.size() == 8);
    CHECK(mesh_of(cube, crease(89.999)).positions.size() == 24);
    CHECK(mesh_of(cube, crease(0)).positions.size() == 24);
    CHECK(mesh_of(cube, crease(180)).positions.size() == 8);
  }
  // Where floats hold it exactly, the angle is 90 degrees, whatever double makes of the normals' sevenths.
  for (const auto place : {as_it_is, on_sevenths})
    CHECK(mesh_of(cube_vertices(1, place) + cube_faces, crease(90)).positions.size() == 8);
}

TEST_CASE("faces belong together through others between them, and not where one of those is missing") {
  const std::string tent = "v 0 0 1\nv 1 0 0\nv 0.3 0.95 0\nv -0.8 0.58 0\nv -0.8 -0.58 0\nv 0.3 -0.95 0\n";
  const std::string round = "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 6\nf 1 6 2\n", gap = "f 1 2 3\nf 1 4 5\nf 1 5 6\n";
  // Neighbouring sides of the tent enclose 54.4 degrees, others 95.4.
  CHECK(normals_at(mesh_of(tent + round, crease(55)))[Key(0, 0, 1)].size() == 1);
  CHECK(normals_at(mesh_of(tent + round, crease(54)))[Key(0, 0, 1)].size() == 5);
  CHECK(normals_at(mesh_of(tent + gap, crease(80)))[Key(0, 0, 1)].size() == 2);
  // The same angle without an edge between: at the tip of two sides that only touch there, nothing belongs together.
  CHECK(normals_at(mesh_of(tent + gap, crease(180)))[Key(0, 0, 1)].size() == 2);
  CHECK(normals_at(mesh_of(tent + gap, smooth))[Key(0, 0, 1)].size() == 1);
}

TEST_CASE("a face without area is of no group, and its neighbours are none through it") {
  // Two planes whose normals enclose 120 degrees; between them a triangle on a line, with an edge of each.
  const std::string text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0.5 -0.8660254\nv 2 0.5 -0.8660254\nv 1 0 0\n"
                           "f 1 2 3 4\nf 1 7 2\nf 1 5 7\nf 5 6 7\nf 7 6 2\n";
  const Mesh mesh = mesh_of(text, crease(100));
  CHECK(normal_at(mesh, 0, 0) == Float3(0, 0, 1));
  CHECK(normal_at(mesh, 2, 0) == Float3(0, 0, 0));
  CHECK(degrees_between(normal_at(mesh, 3, 0), {0, -0.8660254, -0.5}) < 1e-4);
}

TEST_CASE("in a file with any s, faces before the first one are flat, and groups decide") {
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 1 -0.1\nv 0 1 -0.1\nv 1 -1 -0.1\nv 0 -1 -0.1\n"; // 11 degrees
  const std::string faces = "f 1 2 3 4\nf 1 6 5 2\n";
  CHECK(mesh_of(roof + faces).positions.size() == 6);
  for (const std::string& flat_text :
       std::vector<std::string>{faces + "s 1\n", faces + "s off\n", "s off\n" + faces, "s\n" + faces, "s 0\n" + faces,
                                "f 1 2 3 4\ns 1\nf 1 6 5 2\n", "s 1\nf 1 2 3 4\ns -1\nf 1 6 5 2\n",
                                "s -1\nf 1 2 3 4\ns 18446744073709551615\nf 1 6 5 2\n"})
    CHECK(mesh_of(roof + flat_text).positions.size() == 8);
  CHECK(mesh_of(roof + "s 4294967295\nf 1 2 3 4\ns off\ns 4294967295\nf 1 6 5 2\n").positions.size() == 6);
}

TEST_CASE("corners with vn keep it, and the faces of others belong together by their angle") {
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 1 -0.1\nv 0 1 -0.1\nv 1 -1 -0.1\nv 0 -1 -0.1\nvn 1 2 3\n";
  const Mesh mesh = mesh_of(roof + "f 1//1 2 3 4\nf 1 6 5 2\n");
  CHECK(normal_at(mesh, 0, 0) == Float3(1, 2, 3));
  CHECK(normal_at(mesh, 0, 1) == Float3(0, 0, 1));                   // of both faces
  CHECK(degrees_between(normal_at(mesh, 2, 0), {0, -0.1, 1}) < 0.1); // of the one that lacks it there
}

TEST_CASE("other normals than the file's are computed, whatever vn and s say") {
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 1 -0.1\nv 0 1 -0.1\nv 1 -1 -0.1\nv 0 -1 -0.1\nvn 1 0 0\nvn 1 1 0\n";
  const std::string text = roof + "s 1\nf 1//1 2//1 3//1 4//1\ns off\nf 1//2 6//2 5//2 2//2\n";
  const Mesh file = mesh_of(text);
  for (const Float3& n : file.normals) CHECK(n.x == 1);
  CHECK(file.positions.size() == 8);
  CHECK(mesh_of(text, smooth).positions.size() == 6);
  CHECK(mesh_of(text, crease(12)).positions.size() == 6);
  CHECK(mesh_of(text, crease(11)).positions.size() == 8);
  const Mesh edges = mesh_of(text, flat);
  CHECK(edges.positions.size() == 8);
  for (std::size_t t = 0; t < 4; ++t) {
    const Double3 expected = normalize(Double3(0, t < 2 ? 0.1f : -0.1f, 1));
    for (std::size_t k = 0; k < 3; ++k) CHECK(degrees_between(normal_at(edges, t, k), expected) < 1e-5);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("an edge that many thousand faces share is smoothed, and one that would take hours is refused") {
    const auto pages = [](int count) {
      std::string text = "v 0 0 0\nv 0 0 1\n", faces;
      for (int i = 0; i < count; ++i) {
        const double angle = 6 * (i % 2 == 0 ? i : count - i) / static_cast<double>(count); // not sorted
        text += vertex({std::cos(angle), std::sin(angle), 0});
        faces += "f 1 2 " + std::to_string(i + 3) + "\n";
      }
      return text + faces;
    };
    CHECK(normals_at(mesh_of(pages(20000), crease(0.1)))[Key(0, 0, 1)].size() == 1);
    // Faces that are there often, or have no area, cost nothing.
    std::string often = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\n";
    for (int i = 0; i < 200000; ++i) often += "f 1 2 3\nf 3 2 1\nf 1 2 4\n";
    CHECK(normals_at(mesh_of(often))[Key(0, 0, 0)].size() == 3);
    CHECK_THROWS_WITH_AS(mesh_of(pages(200000), crease(0)),
                         doctest::Contains("found edges that so many faces share that smoothing takes too long"),
                         InputError);
  }
}

} // namespace refraster::test
