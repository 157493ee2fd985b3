// What the text of an OBJ file says beside its shape: materials of faces, colours of vertices.

#include "io/mesh/obj_text.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster::test {
namespace {

ObjText parsed(const std::string& text) {
  NoteList notes;
  return parse_obj("m.obj", text, notes);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// Of each face, the line on which its material was named first; 0 if it has none.
std::vector<int> material_lines(const ObjText& obj) {
  std::vector<int> lines(obj.faces.count());
  for (const MaterialRun& run : obj.material_runs)
    for (std::size_t f = run.face; f < lines.size(); ++f)
      lines[f] = run.name < 0 ? -1 : obj.material_names[static_cast<std::size_t>(run.name)].line;
  return lines;
}

} // namespace

TEST_CASE("a face has the material of the last usemtl before it") {
  const ObjText obj = parsed(square + "f 1 2 3\nusemtl red\nf 1 2 3\nf 1 3 4\n\nusemtl light blue\nusemtl  green \n" +
                             "f 2 3 4\nusemtl red\nf 1 2 3 4\nusemtl\nf 1 2 3\nusemtl last\n");
  CHECK(material_lines(obj) == std::vector{0, 6, 6, 11, 6, -1});
  REQUIRE(obj.material_names.size() == 4);
  CHECK(obj.material_names[0].text == "red");
  CHECK(obj.material_names[1].text == "light blue");
  CHECK(obj.material_names[2].text == "green");
  CHECK(obj.material_names[3].text == "last");
  // No two runs begin at one face: "light blue" has none.
  std::vector<std::uint32_t> begin;
  for (const MaterialRun& run : obj.material_runs) begin.push_back(run.face);
  CHECK(begin == std::vector<std::uint32_t>{1, 3, 4, 5, 6});
}

TEST_CASE("names of materials and libraries stand as in the file, each with its line") {
  const ObjText obj = parsed("mtllib a.mtl b.mtl\r\nv 0 0 0\\\n\nv 1 0 0\nv 1 1 0\n\tmtllib  my file.mtl # mine \r\n"
                             "usemtl Material #25\nf 1 2 3\n");
  REQUIRE(obj.material_libraries.size() == 2);
  CHECK(obj.material_libraries[0].text == "a.mtl b.mtl");
  CHECK(obj.material_libraries[0].line == 1);
  CHECK(obj.material_libraries[1].text == "my file.mtl # mine");
  CHECK(obj.material_libraries[1].line == 6);
  REQUIRE(obj.material_names.size() == 1);
  CHECK(obj.material_names[0].text == "Material #25");
  CHECK(obj.material_names[0].line == 7);
}

TEST_CASE("a colour is the last three of six or seven numbers of a v, and -1 of a v without") {
  CHECK(parsed(square + "f 1 2 3\n").colours.empty());
  const ObjText obj =
      parsed("v 0 0 0\nv 1 0 0 1 0.5 0\nv 1 1 0 2\nv 0 1 0 1 255 128 0\nv 0 0 1 nan 1 1e99\nv 0 0 0\nf 1 2 3\n");
  REQUIRE(obj.colours.size() == 6);
  for (const std::size_t none : {0u, 2u, 5u}) CHECK(obj.colours[none] == Float3(-1.0f));
  CHECK(obj.colours[1] == Float3(1, 0.5f, 0));
  CHECK(obj.colours[3] == Float3(255, 128, 0));
  CHECK(std::isnan(obj.colours[4].x));
  CHECK(obj.colours[4].y == 1);
  CHECK(std::isnan(obj.colours[4].z));
}

} // namespace refraster::test
