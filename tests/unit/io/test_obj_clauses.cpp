// The clauses of the OBJ specification (Wavefront, Advanced Visualizer manual, appendix B1), one input after the other,
// and what becomes of each.

#include <refraster/notes.h>

#include "io/mesh/obj_file.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace refraster::test {
namespace {

/// What is read: how many triangles and vertices, and of these how many with texture coordinates; and the notes, each
/// without the file's name. Or the lines of the refusal.
struct Clause {
  std::string clause, text, expected;
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string sound = square + "f 1 2 3 4\n";
const std::string vt = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n", vn = "vn 0 0 1\n";

const std::vector<Clause>& clauses() {
  static const std::vector<Clause> list = {
      // General statements, lines
      {"a # comment", "# by hand\n" + sound + "# end", "2 triangles, 4 vertices, 0 with uv"},
      {"blank lines, blanks before a keyword", "\n \n" + square + " \t f 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
      {"a line continued by \\", square + "f 1 2 \\\n3 4\n", "2 triangles, 4 vertices, 0 with uv"},
      {"call", sound + "call other.obj 1\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"call other.obj 1\", skipped: no other file is read, and no "
       "command "
       "run"},
      {"csh", sound + "csh -rm x\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"csh -rm x\", skipped: no other file is read, and no command "
       "run"},
      // Vertex data
      {"v x y z", sound, "2 triangles, 4 vertices, 0 with uv"},
      {"v x y z w", "v 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 2\nf 1 2 3\n", "1 triangles, 3 vertices, 0 with uv"},
      {"v x y z r g b, of other programs", "v 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0 0 1 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
      {"v x y z w r g b, of other programs", "v 0 0 0 1 1 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
      {"v x y", "v 0 0\nv 1 0\nv 1 1\nf 1 2 3\n",
       "m.obj:1:1: found 2 numbers, expected 3 to 7 numbers\nm.obj:2:1: found 2 numbers, expected 3 to 7 numbers\n"
       "m.obj:3:1: found 2 numbers, expected 3 to 7 numbers"},
      {"v with a coordinate that is no number", square + "v nan 0 0\nv 0 1.#QNAN 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv; :5: found the coordinate \"nan\", skipped: no face uses it (2 times)"},
      {"the same, used", square + "v nan 0 0\nf 1 2 5\n",
       "m.obj:5:3: found \"nan\", expected a finite number in single precision"},
      {"the same, used before it is given", "f 1 2 5\nf 1 2 5\n" + square + "v 0 0 -inf\n",
       "m.obj:7:7: found \"-inf\", expected a finite number in single precision"},
      {"vp", sound + "vp 0.1 0.2 1\n", "2 triangles, 4 vertices, 0 with uv"},
      {"vn i j k", square + vn + "f 1//1 2//1 3//1\n", "1 triangles, 3 vertices, 0 with uv"},
      {"vn that is no number, unused",
       square + "vn -nan(ind) -nan(ind) -nan(ind)\nvn -1.#IND00 0 0\n" + vn + "f 1//3 2//3 3//3\n",
       "1 triangles, 3 vertices, 0 with uv; :5: found the coordinate \"-nan(ind)\", taken as no normal (2 times)"},
      {"vn that is no number, used", square + "vn nan 0 1\nf 1//1 2//1 3//1\n",
       "1 triangles, 3 vertices, 0 with uv; :5: found the coordinate \"nan\", taken as no normal"},
      {"vn that is a word", square + "vn a b c\nf 1 2 3\n",
       "m.obj:5:4: found \"a\", expected a finite number in single precision\n"
       "m.obj:5:6: found \"b\", expected a finite number in single precision\n"
       "m.obj:5:8: found \"c\", expected a finite number in single precision"},
      {"vt u", square + "vt 0.5\nf 1/1 2/1 3/1\n", "1 triangles, 3 vertices, 3 with uv"},
      {"vt u v w", square + "vt 0.5 0.5 0\nf 1/1 2/1 3/1\n", "1 triangles, 3 vertices, 3 with uv"},
      {"vt that is no number", square + "vt inf 0\nvt 0 0\nf 1/1 2/2 3/2\nf 1/2 3/2 4/2\n",
       "2 triangles, 6 vertices, 3 with uv; :5: found the coordinate \"inf\", taken as no texture coordinate"},
      {"vt with a third that is no number and not used", square + "vt 0 0 nan\nf 1/1 2/1 3/1\n",
       "1 triangles, 3 vertices, 3 with uv"},
      // Elements
      {"p", sound + "p 1 2\np 3\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"p 1 2\", skipped: points and lines are not drawn (2 times)"},
      {"l", sound + "l 1/1 2/1 # a line\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"l 1/1 2/1\", skipped: points and lines are not drawn"},
      {"only l", square + "l 1 2 3\n",
       "m.obj: found only lines: they are not drawn, expected at least one face (a statement f)"},
      {"f v", square + "f 1 2 3\n", "1 triangles, 3 vertices, 0 with uv"},
      {"f v/vt", square + vt + "f 1/1 2/2 3/3\n", "1 triangles, 3 vertices, 3 with uv"},
      {"f v//vn", square + vn + "f 1//1 2//1 3//1\n", "1 triangles, 3 vertices, 0 with uv"},
      {"f v/vt/vn", square + vt + vn + "f 1/1/1 2/2/1 3/3/1\n", "1 triangles, 3 vertices, 3 with uv"},
      {"f v/", square + "f 1/ 2/ 3/ 4/\n",
       "2 triangles, 4 vertices, 0 with uv; :5: found the corner \"1/\", read without its empty part (4 times)"},
      {"f v//", square + "f 1// 2// 3//\n",
       "1 triangles, 3 vertices, 0 with uv; :5: found the corner \"1//\", read without its empty part (3 times)"},
      {"f v/vt/", square + vt + "f 1/1/ 2/2/ 3/3/\n",
       "1 triangles, 3 vertices, 3 with uv; :9: found the corner \"1/1/\", read without its empty part (3 times)"},
      {"f v///", square + "f 1 2 3///\n", "m.obj:5:7: found \"3///\", expected v, v/vt, v//vn or v/vt/vn"},
      {"negative references", square + "f -4 -3 -2\n", "1 triangles, 3 vertices, 0 with uv"},
      {"reference number 0", square + "f 0 1 2\n", "m.obj:5:3: found v index 0, expected 1 to 4 or -1 to -4"},
      {"a vn where none is given", square + "f 1//1 2 3\n",
       "m.obj:5:6: found vn index 1, expected no vn index, since none is given"},
      {"corners of several forms, which is illegal", square + vt + vn + "f 1/1/1 2/2/1 3//1\n",
       "1 triangles, 3 vertices, 0 with uv; :10: found a face whose corners are of several forms, read as it stands: "
       "without "
       "vt at all corners no texture, without vn a computed normal"},
      {"a minimum of three vertices", square + "f 1 2\n",
       "m.obj:5:1: found a face with 2 corners, expected at least 3 corners"},
      {"a corner twice", square + "f 1 2 3 3\n", "2 triangles, 3 vertices, 0 with uv"},
      {"a face without vt beside others with: its texture is ignored", square + vt + "f 1/1 2/2 3/3\nf 1 3 4\n",
       "2 triangles, 6 vertices, 3 with uv"},
      {"fo, of version 2", square + vt + "fo 1/1 2/2 3/3\nfo 1/1 3/3 4/4\n",
       "2 triangles, 4 vertices, 4 with uv; :9: found fo, read as f (2 times)"},
      {"fo of two corners", square + "fo 1 2\n", "m.obj:5:1: found a face with 2 corners, expected at least 3 corners"},
      // Free-form geometry
      {"curv", sound + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n",
       "2 triangles, 4 vertices, 0 with uv; :8: found \"curv 0 1 1 2 3 4\", skipped: free-form curves and surfaces are "
       "not "
       "drawn"},
      {"curv2", sound + "vp 0 0\ncurv2 1 1\nend\n",
       "2 triangles, 4 vertices, 0 with uv; :7: found \"curv2 1 1\", skipped: free-form curves and surfaces are not "
       "drawn"},
      {"surf", sound + "surf 0 1 0 1 1 2 4 3\ntrim 0 1 1\nhole 0 1 1\nscrv 0 1 1\nsp 1\nend\ncon 1 0 1 1 2 0 1 1\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"surf 0 1 0 1 1 2 4 3\", skipped: free-form curves and surfaces "
       "are "
       "not drawn"},
      {"bzp, of version 2", sound + "bzp 1 2 3 4 1 2 3 4 1 2 3 4 1 2 3 4\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"bzp 1 2 3 4 1 2 3 4 1 2 3 4 1 2 3 4\", skipped: free-form "
       "curves and "
       "surfaces are not drawn"},
      // Grouping
      {"g, o, mg", "o thing\ng a b\nmg 1 0.5\n" + sound, "2 triangles, 4 vertices, 0 with uv"},
      {"s 0 and s off", square + "s off\nf 1 2 3\ns 0\nf 1 3 4\n", "2 triangles, 6 vertices, 0 with uv"},
      {"s of a number", square + "s 1\nf 1 2 3\nf 1 3 4\n", "2 triangles, 4 vertices, 0 with uv"},
      {"s without a value", square + "s\nf 1 2 3\nf 1 3 4\n",
       "2 triangles, 6 vertices, 0 with uv; :5: found s without a value, read as \"s off\""},
      {"s on, of other programs", square + "s on\nf 1 2 3\ns 1\nf 1 3 4\n",
       "2 triangles, 4 vertices, 0 with uv; :5: found \"s on\", read as \"s 1\""},
      {"s of the bits of a word", square + "s 4294967295\nf 1 2 3\ns -2147483648\nf 1 3 4\n",
       "2 triangles, 6 vertices, 0 with uv; :5: found the smoothing group 4294967295, read as a group of its own (2 "
       "times)"},
      {"s of 64 bits", square + "s 18446744073709551615\nf 1 2 3\ns -1\nf 1 3 4\n",
       "2 triangles, 6 vertices, 0 with uv; :5: found the smoothing group 18446744073709551615, read as a group of its "
       "own "
       "(2 times)"},
      {"s of the least of 64 bits", square + "s -9223372036854775808\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv; :5: found the smoothing group -9223372036854775808, read as a group of its "
       "own"},
      {"s of a word", square + "s smooth\nf 1 2 3\n",
       "m.obj:5:3: found \"smooth\", expected off, or the number of a smoothing group"},
      {"s of a number with more behind it", square + "s 1x\nf 1 2 3\n",
       "m.obj:5:3: found \"1x\", expected off, or the number of a smoothing group"},
      // Display and render attributes
      {"bevel, c_interp, d_interp, lod, shadow_obj, trace_obj, ctech, stech",
       sound + "bevel on\nc_interp off\nd_interp off\nlod 1\nshadow_obj a.obj\ntrace_obj b.obj\nctech cparm 1\nstech "
               "cparma 1 "
               "1\n",
       "2 triangles, 4 vertices, 0 with uv"},
      {"mtllib and usemtl", "mtllib a.mtl b.mtl\n" + square + "usemtl red\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
      {"maplib and usemap", square + "usemap off\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv; :5: found \"usemap off\", skipped: textures are those of the materials"},
      // What is no statement
      {"a statement that there is not", sound + "vw 1 2 3\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"vw 1 2 3\", skipped: the format has no such statement"},
      {"a keyword in capitals", sound + "F 1 2 3\n",
       "2 triangles, 4 vertices, 0 with uv; :6: found \"F 1 2 3\", skipped: the format has no such statement"},
      // Coordinates
      {"coordinates that rounding moves by a thousandth of the mesh's size",
       "v 5000000.3 100.2 0\nv 5000012.7 100.2 0\nv 5000000.3 108.1 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv; coordinates as large as 5e+06 are rounded to single precision, which moves "
       "them "
       "by up to 0.2: more than a thousandth of the mesh's size, 12"},
      {"the same, with one at the origin that is not used",
       "v 0 0 0\nv 5000000.3 100.2 0\nv 5000012.7 100.2 0\nv 5000000.3 108.1 0\nf 2 3 4\n",
       "1 triangles, 3 vertices, 0 with uv; coordinates as large as 5e+06 are rounded to single precision, which moves "
       "them "
       "by up to 0.2: more than a thousandth of the mesh's size, 12"},
      {"a little more than a thousandth", "v 5000000.3 0 0\nv 5000150.3 0 0\nv 5000000.3 8 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv; coordinates as large as 5e+06 are rounded to single precision, which moves "
       "them "
       "by up to 0.2: more than a thousandth of the mesh's size, 150"},
      {"a little less", "v 5000000.3 0 0\nv 5000250.3 0 0\nv 5000000.3 8 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
      {"coordinates as large that are floats", "v 5000000.5 100 0\nv 5000012.5 100 0\nv 5000000.5 108 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
      {"coordinates as large of a mesh as large", "v 5000000.3 0 0\nv 4999000.3 0 0\nv 0.3 8.1 0\nf 1 2 3\n",
       "1 triangles, 3 vertices, 0 with uv"},
  };
  return list;
}

std::string outcome(const std::string& text) {
  NoteList notes;
  std::string result;
  try {
    const Mesh mesh = mesh_of_obj("m.obj", text, {{}, &notes});
    result = std::to_string(mesh.triangles.size()) + " triangles, " + std::to_string(mesh.positions.size()) +
             " vertices, " + std::to_string(mesh.uvs.size()) + " with uv";
  } catch (const InputError& error) {
    CHECK(notes.empty());
    return error.what();
  }
  for (const Note& note : notes.notes()) {
    CHECK(note.file == "m.obj");
    const std::string told = note.text();
    result += "; " + told.substr(told.starts_with("m.obj: ") ? 7 : 5);
  }
  return result;
}

} // namespace

TEST_CASE("every clause of the OBJ specification is read, noted or refused as the table says") {
  CHECK(clauses().size() >= 40);
  for (const Clause& clause : clauses()) {
    CAPTURE(clause.clause);
    CHECK(outcome(clause.text) == clause.expected);
  }
}

TEST_CASE("what is unusual is noted once a kind, in the order of the first lines") {
  CHECK(outcome("usemap a\n" + square + "s\nf 1// 2// 3//\nusemap b\ns\nf 1 3/ 4\n") ==
        "2 triangles, 6 vertices, 0 with uv; :1: found \"usemap a\", skipped: textures are those of the materials (2 "
        "times); :6: found s without a value, read as \"s off\" (2 times); :7: found the "
        "corner \"1//\", read without its empty part (4 times)");
}

TEST_CASE("a continued line's remark has the line on which it stands") {
  CHECK(outcome(square + "f 1 \\\n 2 \\\n 3/\n") ==
        "1 triangles, 3 vertices, 0 with uv; :7: found the corner \"3/\", read without its empty part");
}

} // namespace refraster::test
