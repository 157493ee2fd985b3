// Colours of an OBJ file's vertices: `v x y z r g b`.

#include "io/mesh/obj_file.h"
#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

namespace refraster::test {
namespace {

struct Read {
  Mesh mesh;
  std::string notes;
};

Read read(const std::string& text, VertexColours colours = VertexColours::linear) {
  NoteList notes;
  Read result{mesh_of_obj("m.obj", text, {.notes = &notes, .colours = colours}), ""};
  for (const Note& note : notes.notes()) result.notes += note.text() + "\n";
  return result;
}

const std::string face = "f 1 2 3\n";

} // namespace

TEST_SUITE("obj colours") {
  TEST_CASE("each vertex of the mesh has the colour of its v, once for each normal and texture coordinate") {
    const Read two = read("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 1 1 0 0 0 0.25\nv 0 1 0 0.125 0.5 1\n"
                          "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n");
    CHECK(two.notes.empty());
    REQUIRE(two.mesh.colours.size() == two.mesh.positions.size());
    REQUIRE(two.mesh.colours.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) {
      const Float3& p = two.mesh.positions[i];
      const Float3 expected = p == Float3(0, 0, 0)   ? Float3(1, 0, 0)
                              : p == Float3(1, 0, 0) ? Float3(0, 0.5, 0)
                              : p == Float3(1, 1, 0) ? Float3(0, 0, 0.25)
                                                     : Float3(0.125, 0.5, 1);
      CHECK(two.mesh.colours[i] == expected);
    }
  }

  TEST_CASE("a file without any has none, and so it is where they are ignored") {
    CHECK(read("v 0 0 0\nv 1 0 0 0.5\nv 1 1 0\n" + face).mesh.colours.empty());
    CHECK(read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\n" + face, VertexColours::ignored).mesh.colours.empty());
  }

  TEST_CASE("where some vertices have one the others are white; a weight may stand before it") {
    const Read some = read("v 0 0 0\nv 1 0 0 7 0.25 0.5 0.75\nv 1 1 0 9\n" + face);
    REQUIRE(some.mesh.colours.size() == 3);
    CHECK(some.mesh.colours[0] == Float3(1));
    CHECK(some.mesh.colours[1] == Float3(0.25, 0.5, 0.75));
    CHECK(some.mesh.colours[2] == Float3(1));
    CHECK(some.notes.empty());
  }

  TEST_CASE("where one exceeds 1 all are from 0 to 255, and a note says so") {
    const Read bytes = read("v 0 0 0 255 0 51\nv 1 0 0 1 1 1\nv 1 1 0 0 0 0\n" + face);
    REQUIRE(bytes.mesh.colours.size() == 3);
    CHECK(bytes.mesh.colours[0] == Float3(1, 0, static_cast<float>(51.0 / 255)));
    CHECK(bytes.mesh.colours[1] == Float3(static_cast<float>(1.0 / 255)));
    CHECK(bytes.notes == "m.obj: found vertex colours above 1, all are taken as from 0 to 255\n");
  }

  TEST_CASE("what is no colour is white, and nothing is below 0, with a note") {
    const Read odd = read("v 0 0 0 nan 0 0\nv 1 0 0 -0.5 0.5 1\nv 1 1 0 0 1e99 0\n" + face);
    REQUIRE(odd.mesh.colours.size() == 3);
    CHECK(odd.mesh.colours[0] == Float3(1));
    CHECK(odd.mesh.colours[1] == Float3(0, 0.5, 1));
    CHECK(odd.mesh.colours[2] == Float3(1));
    CHECK(odd.notes == "m.obj: found 2 vertex colours with a number that is not finite, taken as white\n"
                       "m.obj: found 1 vertex colour below 0, taken as 0 there\n");
  }

  TEST_CASE("sRGB is decoded before anything is interpolated") {
    const Read decoded = read("v 0 0 0 0.5 0 1\nv 1 0 0 0.04045 0.5 0.5\nv 1 1 0 0 0 0\n" + face, VertexColours::srgb);
    REQUIRE(decoded.mesh.colours.size() == 3);
    // IEC 61966-2-1, by the C library's power.
    CHECK(decoded.mesh.colours[0] == Float3(static_cast<float>(std::pow((0.5 + 0.055) / 1.055, 2.4)), 0, 1));
    CHECK(decoded.mesh.colours[1].x == static_cast<float>(static_cast<double>(0.04045f) / 12.92));
  }

  TEST_CASE("what is written is read again, bit for bit") {
    const TemporaryFolder folder;
    const std::string path = folder / "m.obj";
    Mesh mesh = cube_mesh();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      mesh.colours.emplace_back(static_cast<float>(i) / 23, 1 / static_cast<float>(i + 3), i % 2 == 0 ? 0.1f : 0.7f);
    write_obj(path, mesh);
    const Mesh again = read_obj(path);
    REQUIRE(again.triangles.size() == mesh.triangles.size());
    REQUIRE(again.colours.size() == mesh.colours.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(again.colours[again.triangles[t][k]] == mesh.colours[mesh.triangles[t][k]]);
  }
}

} // namespace refraster::test
