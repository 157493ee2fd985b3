// OBJ files as real programs write them: what is said of them, and what is seen.

#include <refraster/files.h>

#include "tests/support/files/png_bytes.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;

namespace {

/// Looks along -z at [-1, 1]^2 of the plane z = 0, lit by its ambient term alone.
std::string scene_of(const std::string& keys, const std::string& material = "") {
  return R"({"scene": {"camera": {"position": "0 0 1", "fov_y": 90}, "point_lights": [], "direction_lights": [],
  "objects": [{"obj_file_path": "m.obj", "fragment_function": "phong", "position": "0 0 0", "rotate_x": 0, "rotate_y": 0,
  "rotate_z": 0, "scale": "1 1 1")" +
         keys + R"(, "material": {"ka": "1 1 1", "kd": "0 0 0", "ks": "0 0 0", "glossiness": 1)" + material + "}}]}}";
}

const std::string quad = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

/// A folder with a scene of m.obj and a texture of one red texel.
struct ObjFolder : TemporaryFolder {
  ObjFolder(const std::string& obj, const std::string& keys = "", const std::string& material = "") {
    save_text(*this / "m.obj", obj);
    save_text(*this / "s.json", scene_of(keys, material));
    save_text(*this / "red.png", test::png_bytes(1, 1, 3, 8, {255, 0, 0}));
  }
  Finished render(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"render", "s.json", "-o", "i.pfm", "--size", "4x4"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(path, words);
  }
};

const std::string unusual = "usemtl red\n" + quad + "s\nf 1// 2// 3//\nf 1// 3// 4//\n";
const std::string notes = "note: m.obj:6: found s without a value, read as \"s off\"\n"
                          "note: m.obj:7: found the corner \"1//\", read without its empty part (6 times)\n"
                          "note: m.obj: found 1 material of its own, not used: the scene's `material` is\n";

} // namespace

TEST_CASE("what is unusual in an OBJ file is noted on standard error, once a kind, and the image is made") {
  const ObjFolder folder(unusual);
  const Finished run = folder.render();
  CHECK(run.exit_code == 0);
  CHECK(run.out == "i.pfm\n");
  CHECK(run.err == notes);
  CHECK(folder.render({"-q"}).err.empty());
}

TEST_CASE("with --strict notes on an OBJ file are errors, and no image is made") {
  const ObjFolder folder(unusual);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--strict"}, {"--strict", "-q"}}) {
    const Finished run = folder.render(words);
    CHECK(run.exit_code == 3);
    CHECK(run.err == "refraster: m.obj:6: found s without a value, expected a file without notes (--strict)\n"
                     "m.obj:7: found the corner \"1//\" (6 times), expected a file without notes (--strict)\n"
                     "m.obj: found 1 material of its own, expected a file without notes (--strict)\n");
    CHECK(files_in(folder) == std::vector<std::string>{"m.obj", "red.png", "s.json"});
  }
  CHECK(ObjFolder(quad + "f 1 2 3 4\n").render({"--strict"}).exit_code == 0);
}

TEST_CASE("a mesh out of the cache has the notes of its file, also with --strict") {
  const ObjFolder folder(unusual + std::string(1 << 20, '\n'));
  for (int i = 0; i < 2; ++i) CHECK(folder.render({"--cache", "kept"}).err == notes);
  CHECK(folder.render({"--cache", "kept", "--strict"}).exit_code == 3);
}

TEST_CASE("faces without vt are white, whatever the texture is") {
  const ObjFolder folder(quad + "vt 0.5 0.5\nf 1/1 2/1 3/1\nf 1 3 4\n", "", R"(, "texture_file_path": "red.png")");
  for (const char* const precision : {"double", "float", "fast"}) {
    const Finished run = folder.render({"--precision", precision});
    CHECK(run.exit_code == 0);
    CHECK(run.err == "note: m.obj: found 1 triangle without vt, on which the texture is not shown\n");
    const Image<float> image = read_image(folder / "i.pfm").values;
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        if (x + y != 3) CHECK(image.at(x, y)[1] == (x + y > 3 ? 0 : 1)); // on the diagonal, the top-left rule decides
  }
}

TEST_CASE("of 500 faults 100 are listed, and the last line counts the other 400") {
  std::string faces;
  for (int i = 0; i < 500; ++i) faces += "f 1 2 9\n";
  const Finished run = ObjFolder(quad + faces).render();
  CHECK(run.exit_code == 3);
  CHECK(run.err.ends_with("\nm.obj: found 400 more faults\n"));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 101);
}
