#include <refraster/files.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>

#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace refraster::test {
namespace {

Mesh obj(const std::string& text) {
  const TemporaryFolder folder;
  write_files(folder.path, {{"m.obj", text}});
  return read_obj(folder / "m.obj");
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Corners of all triangles, by position.
std::vector<Float3> corners(const Mesh& mesh) {
  std::vector<Float3> result;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t i : triangle) result.push_back(mesh.positions[i]);
  return result;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
// Two squares that meet at a right angle along the edge 1 2: the floor faces +y, the wall faces +z.
const std::string corner = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\n";
const std::string floor_face = "f 1 5 6 2\n", wall_face = "f 1 2 3 4\n";

} // namespace

TEST_CASE("the lecture's quad becomes two triangles of the same winding, with its normal and uv") {
  const Mesh mesh = obj("v 2.000000 -2.000000 0.0\nv -2.000000 -2.000000 0.0\nv -2.000000 2.000000 0.0\n"
                        "v 2.000000 2.000000 0.0\nvn 0.0000 0.0000 1.0000\nvt 0.999999 0.000000\nvt 0.000000 0.000000\n"
                        "vt 0.000000 0.999999\nvt 0.999999 0.999999\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
  CHECK(mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.positions[0] == Float3(2, -2, 0));
  CHECK(mesh.normals == std::vector<Float3>(4, Float3(0, 0, 1)));
  CHECK(mesh.uvs[2] == Float2(0.0f, 0.999999f));
}

TEST_CASE("a negative index counts back from the last one given at that line") {
  const Mesh mesh = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 9 9 9\nf -4 -3 -1\n");
  CHECK(corners(mesh) == std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {9, 9, 9}});
}

TEST_CASE("a positive index may name what comes later in the file") {
  CHECK(corners(obj("f 1 2 3\n" + square)) == std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
}

TEST_CASE("a vertex is one for each different (v, vt, vn), numbered as they appear") {
  const Mesh mesh = obj(square + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 0 2\n"
                                 "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\nf 1/2/1 3/1/2 4/1/1\n");
  CHECK(mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 3}});
  CHECK(mesh.positions.size() == 6);
}

TEST_CASE("a face without vt at all its corners has no uvs, and vertices with uvs come first") {
  const std::string vt = "vt 0.5 0.25\nvt 1 0\nvn 0 0 1\n";
  for (const char* const without : {"f 1//1 2//1 3//1\n", "f 1/1/1 2//1 3/2/1\n", "f 1//1 2//1 3/2/1\n"}) {
    const Mesh mesh = obj(square + vt + without + "f 1/1/1 3/1/1 4/2/1\n" + without);
    CHECK(mesh.uvs == std::vector<Float2>{{0.5f, 0.25f}, {0.5f, 0.25f}, {1, 0}});
    CHECK(mesh.positions.size() == 6);
    CHECK(mesh.triangles == Triangles{{3, 4, 5}, {0, 1, 2}, {3, 4, 5}});
    CHECK_FALSE(has_uvs(mesh, mesh.triangles[0]));
    CHECK(has_uvs(mesh, mesh.triangles[1]));
    CHECK(corners(mesh) ==
          std::vector<Float3>{
              {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  }
  CHECK(obj(square + "f 1 2 3\n").uvs.empty());
  CHECK(obj(square + "vt 0 0\nf 1 2 3\n").uvs.empty());
}

TEST_CASE("vt may have one to three numbers, v a weight or a colour") {
  const Mesh mesh =
      obj("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0 1 0.5 0.5 0.5\nvt 0.5\nvt 0.25 0.75 0\nf 1/1 2/2 3/1\n");
  CHECK(mesh.positions[1] == Float3(1, 0, 0));
  CHECK(mesh.uvs[0] == Float2(0.5f, 0.0f));
  CHECK(mesh.uvs[1] == Float2(0.25f, 0.75f));
}

TEST_CASE("several shapes, groups and materials are one mesh, in the order of the file") {
  const Mesh mesh =
      obj("mtllib none.mtl\no first\n" + square + "g a b\nusemtl red\nf 1 2 3\no second\ng c\ns off\nf 1 3 4\n");
  CHECK(corners(mesh) == std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}});
}

TEST_CASE("comments, blank lines, tabs, carriage returns and continued lines change nothing") {
  const Mesh plain = obj(square + "f 1 2 3 4\n");
  for (const std::string& text : {"# f 1 2 \\\n\n" + square + "  f\t1 2   3 4 # the square\n", square + "f 1 2 \\\n3 4",
                                  square + "f 1 2 \\\r\n 3\\\r\n 4\r\n", "\xef\xbb\xbf" + square + "f 1 2 3 4\n"})
    CHECK(corners(obj(text)) == corners(plain));
  std::string old_mac = square + "f 1 2 3 4\n";
  for (char& c : old_mac)
    if (c == '\n') c = '\r';
  CHECK(corners(obj(old_mac)) == corners(plain));
}

TEST_CASE("a line may be continued as often as one likes, but not behind a comment") {
  // Each line once looked at its whole beginning: a file of this size took minutes.
  std::string joints;
  for (int i = 0; i < 300000; ++i) joints += "\\\n";
  CHECK(obj("f 1 2 " + joints + "3\n" + square).triangles == Triangles{{0, 1, 2}});
  CHECK(obj(square + "f 1 2 3 # \\\n4\n#\\\nf 1 2 3\n").triangles == Triangles{{0, 1, 2}, {0, 1, 2}});
  CHECK(obj(square + "# one\nf 1 2 \\\r\n3 \\\n4 # \\\n5\n").triangles.size() == 2);
}

TEST_CASE("a coordinate is the float nearest to its digits, rounded once") {
  // 1 + 2^-24 lies in the middle between two floats and goes to 1, the even one; the digits after it lie just above the
  // middle, but vanish when they are rounded to double first.
  const Mesh mesh = obj("v 1.000000059604644775390625 1.00000005960464477539062500000001 +.5\n"
                        "v 1e-60 -1e-60 16777217\nv 3.4028235e38 1e-45 0.1\nf 1 2 3\n");
  CHECK(mesh.positions[0] == Float3(1.0f, std::nextafter(1.0f, 2.0f), 0.5f));
  CHECK(mesh.positions[1] == Float3(0.0f, -0.0f, 16777216.0f));
  CHECK(std::signbit(mesh.positions[1].y));
  CHECK(mesh.positions[2] == Float3(std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min(), 0.1f));
}

TEST_CASE("in a smoothing group, faces around a vertex share its normal") {
  const Mesh mesh = obj(corner + "s 1\n" + floor_face + wall_face);
  CHECK(mesh.positions.size() == 6);
  // Both angles at vertex 1 are right ones: (0, 1, 0) + (0, 0, 1), normalised, each within half an ulp of float.
  CHECK(mesh.normals[0].x == 0.0f);
  CHECK(mesh.normals[0].y == static_cast<float>(std::sqrt(0.5)));
  CHECK(mesh.normals[0].z == static_cast<float>(std::sqrt(0.5)));
  CHECK(mesh.normals[1] == Float3(0, 1, 0)); // vertex 5 belongs to the floor alone
}

TEST_CASE("s off and s 0 make faces flat, different groups separate, equal ones join across the file") {
  for (const char* const flat : {"s off\n", "s 0\n"}) {
    const Mesh mesh = obj(corner + flat + floor_face + wall_face);
    CHECK(mesh.positions.size() == 8);
    CHECK(mesh.normals[0] == Float3(0, 1, 0));
    CHECK(mesh.normals[4] == Float3(0, 0, 1));
  }
  CHECK(obj(corner + "s 1\n" + floor_face + "s 2\n" + wall_face).positions.size() == 8);
  CHECK(obj(corner + "s 7\n" + floor_face + "s off\ns 7\n" + wall_face).positions.size() == 6);
}

TEST_CASE("a normal is weighted by angle: how a flat face is cut changes nothing") {
  // The wall as one quad, and as two triangles that both meet vertex 1: by area or by count it would weigh twice.
  const std::string begin = corner + "s 1\n" + floor_face;
  const Mesh quad = obj(begin + wall_face), cut = obj(begin + "f 1 2 3\nf 1 3 4\n");
  CHECK(quad.normals[0].y == doctest::Approx(static_cast<double>(cut.normals[0].y))
                                 .epsilon(static_cast<double>(std::numeric_limits<float>::epsilon())));
  CHECK(quad.normals[0].z == doctest::Approx(static_cast<double>(cut.normals[0].z))
                                 .epsilon(static_cast<double>(std::numeric_limits<float>::epsilon())));
}

TEST_CASE("a corner that is concave weighs with its angle beyond half a circle") {
  // An L in the xz plane round the origin, where it takes three quarters of a circle, as one polygon and cut in two;
  // and a wall on the x axis that takes one quarter.
  const std::string points = "s 1\nv 0 0 0\nv 1 0 0\nv 1 0 -1\nv -1 0 -1\nv -1 0 1\nv 0 0 1\nv 1 1 0\nv 0 1 0\n",
                    wall = "f 1 2 7 8\n";
  const Float3 whole = obj(points + "f 1 2 3 4 5 6\n" + wall).normals[0];
  const Float3 cut = obj(points + "f 1 2 3 4\nf 1 4 5 6\n" + wall).normals[0];
  CHECK(whole.y ==
        doctest::Approx(3 / std::sqrt(10.0)).epsilon(static_cast<double>(std::numeric_limits<float>::epsilon())));
  CHECK(
      whole.y ==
      doctest::Approx(static_cast<double>(cut.y)).epsilon(static_cast<double>(std::numeric_limits<float>::epsilon())));
}

TEST_CASE("normals that the file gives are kept as they are, also beside missing ones") {
  const Mesh mesh = obj(square + "vn 0 3 4\nf 1//1 2//1 3\n");
  CHECK(mesh.normals[0] == Float3(0, 3, 4));
  CHECK(mesh.normals[2] == Float3(0, 0, 1));
}

TEST_CASE("a vertex whose faces have no area has the normal 0") {
  CHECK(obj("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n").normals[0] == Float3(0, 0, 0));
}

TEST_CASE("a polygon with a thousand corners is read whole") {
  std::ostringstream text, face;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 1000;
    text << "v " << std::cos(angle) << " " << std::sin(angle) << " 0\n";
    face << " " << i + 1;
  }
  CHECK(obj(text.str() + "f" + face.str() + "\n").triangles.size() == 998);
}

TEST_CASE("what write_obj writes, read_obj reads back bit for bit") {
  const TemporaryFolder folder;
  for (const Mesh& mesh : {sphere_mesh(16, 8), cube_mesh(), torus_mesh(5, 3, 0.3), plane_mesh(2)}) {
    write_obj(folder / "m.obj", mesh);
    const Mesh read = read_obj(folder / "m.obj");
    REQUIRE(read.triangles.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = mesh.triangles[t][c], b = read.triangles[t][c];
        CHECK(mesh.positions[a] == read.positions[b]);
        CHECK(mesh.normals[a] == read.normals[b]);
        CHECK(mesh.uvs[a] == read.uvs[b]);
      }
  }
}

TEST_SUITE("slow") {
  TEST_CASE("a face that would take hours to cut is refused") {
    std::string text = "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf";
    for (int i = 0; i < 300000; ++i) text += " 1 2";
    CHECK_THROWS_WITH_AS(obj(text + "\n"),
                         doctest::Contains("face 2: found a polygon of 600000 corners that takes too long to cut"),
                         InputError);
  }
}

} // namespace refraster::test
