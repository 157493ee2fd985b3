// What a scene says of the OBJ files that it names, and what is said of them.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/png_bytes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

namespace refraster::test {
namespace {

const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 1 -0.2\nv 0 1 -0.2\nv 1 -1 -0.2\nv 0 -1 -0.2\nf 1 2 3 4\nf 1 6 5 2\n";

/// One object that names its mesh with these keys, and these keys in its material.
std::string object_of(const std::string& keys, const std::string& material = "") {
  return "{" + keys +
         R"(, "fragment_function": "phong", "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0,
      "scale": "1 1 1", "material": {"ka": "1 1 1", "kd": "1 1 1", "ks": "0 0 0", "glossiness": 1)" +
         material + "}}\n";
}

/// A folder with a scene s.json of these objects, a mesh m.obj, and the same in models/m.obj.
struct SceneFolder : TemporaryFolder {
  NoteList notes;
  SceneOptions options;

  explicit SceneFolder(const std::string& objects, const std::string& mesh = roof) {
    write_files(path, {{"s.json", "{\"scene\": {\"camera\": {\"position\": \"0 0 6\"}, \"point_lights\": [],\n"
                                  "\"direction_lights\": [], \"objects\": [\n" +
                                      objects + "]}}"},
                       {"m.obj", mesh},
                       {"t.png", png_bytes(1, 1, 3, 8, {255, 0, 0})},
                       {"models/", ""},
                       {"models/m.obj", mesh}});
    options.notes = &notes;
  }
  std::vector<Object> objects() { return read_scene(*this / "s.json", options).objects; }
  /// Of what was read: without this folder's name.
  std::vector<std::string> reported() const {
    std::vector<std::string> texts;
    for (const Note& note : notes.notes()) texts.push_back(note.text().substr(path.string().size() + 1));
    return texts;
  }
};

using Texts = std::vector<std::string>;

} // namespace

TEST_CASE("the key normals says where a mesh's normals come from; without it they come from the file") {
  const auto vertices = [](const std::string& normals) {
    return SceneFolder(object_of("\"obj_file_path\": \"m.obj\"" + normals)).objects()[0].mesh->positions.size();
  };
  // 22.6 degrees between the two sides, which are smooth where they share the two vertices of the ridge.
  CHECK(vertices("") == 6);
  CHECK(vertices(", \"normals\": \"file\"") == 6);
  CHECK(vertices(", \"normals\": \"smooth\"") == 6);
  CHECK(vertices(", \"normals\": \"flat\"") == 8);
  CHECK(vertices(", \"normals\": {\"crease_degrees\": 23}") == 6);
  CHECK(vertices(", \"normals\": {\"crease_degrees\": 22}") == 8);
  CHECK(vertices(", \"normals\": {\"crease_degrees\": 0}") == 8);
}

TEST_CASE("objects share a mesh if they want the same normals of it") {
  const std::string file = "\"obj_file_path\": \"m.obj\"";
  const std::vector<Object> objects =
      SceneFolder(object_of(file) + "," + object_of(file + ", \"normals\": \"flat\"") + "," +
                  object_of(file + ", \"normals\": {\"crease_degrees\": 30}") + "," +
                  object_of(file + ", \"normals\": {\"crease_degrees\": 20}") + "," +
                  object_of("\"obj_file_path\": \"./m.obj\", \"normals\": \"flat\"") + "," +
                  object_of(file + ", \"normals\": {\"crease_degrees\": 3e1}") + "," +
                  object_of(file + ", \"normals\": \"file\""))
          .objects();
  CHECK(objects[0].mesh == objects[6].mesh);
  CHECK(objects[1].mesh == objects[4].mesh);
  CHECK(objects[2].mesh == objects[5].mesh);
  for (const int i : {1, 2, 3})
    for (int j = 0; j < i; ++j)
      CHECK(objects[static_cast<std::size_t>(i)].mesh != objects[static_cast<std::size_t>(j)].mesh);
}

TEST_CASE("what there is to note of a mesh is noted once, however many normals are wanted of it, cached or not") {
  const std::string file = "\"obj_file_path\": \"m.obj\"";
  const std::string three = object_of(file) + "," + object_of(file + ", \"normals\": \"flat\"") + "," + object_of(file);
  SceneFolder folder(three, "usemap red\nusemtl red\n" + roof + "usemap blue\n");
  const Texts expected = {"m.obj:1: found \"usemap red\", skipped: textures are those of the materials (2 times)",
                          "m.obj: found 1 material of its own, not used: the scene's `material` is"};
  folder.objects();
  CHECK(folder.reported() == expected);
  folder.notes = {};
  folder.options.mesh_cache = folder / "cache"; // of large files only: this one is not
  std::filesystem::create_directory(folder.options.mesh_cache);
  folder.objects();
  CHECK(folder.reported() == expected);
}

TEST_CASE("a fault of a mesh is reported once, however many normals are wanted of it") {
  const std::string file = "\"obj_file_path\": \"m.obj\"";
  const std::string three = object_of(file) + "," + object_of(file + ", \"normals\": \"flat\"") + "," + object_of(file);
  SceneFolder folder(three, "v 0 0 0\nf 1 1 2\n");
  try {
    folder.objects();
    FAIL("no fault");
  } catch (const InputError& error) {
    CHECK(error.faults().size() == 1);
  }
}

TEST_CASE("a path with backslashes names the file that it names with slashes, if there is no other") {
  const std::string windows = object_of("\"obj_file_path\": \"models\\\\m.obj\"");
  SceneFolder folder(
      windows + "," +
      object_of("\"obj_file_path\": \".\\\\models\\\\m.obj\"", ", \"texture_file_path\": \".\\\\t.png\""));
  const std::vector<Object> objects = folder.objects();
  CHECK(objects[0].mesh == objects[1].mesh);
  CHECK(objects[1].material.diffuse_map.texture);
  const Texts reported = folder.reported();
  CHECK(std::find(reported.begin(), reported.end(),
                  "s.json:3: found \"models\\m.obj\", read with / for \\ (3 times)") != reported.end());

  // A file of that very name is meant.
  SceneFolder other(windows);
  write_files(other.path, {{"models\\m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"}});
  CHECK(other.objects()[0].mesh->triangles.size() == 1);
  CHECK(other.notes.empty());
}

TEST_CASE("a path with backslashes that names nothing is reported as it stands, one that leads outside as such") {
  const auto refusal = [](const std::string& path) -> std::string {
    SceneFolder folder(object_of("\"obj_file_path\": \"" + path + "\""));
    try {
      folder.objects();
    } catch (const InputError& error) {
      CHECK(folder.notes.empty());
      return error.faults().at(0).found;
    }
    return "no fault";
  };
  CHECK(refusal("models\\\\n.obj").ends_with("models\\n.obj"));
  CHECK(refusal("models\\\\n.obj").starts_with("no such file, "));
  // Whether there is such a file is not reported.
  for (const char* const outside :
       {"..\\\\m.obj", "..\\\\..\\\\..\\\\..\\\\etc\\\\passwd", "models\\\\..\\\\..\\\\m.obj"})
    CHECK(refusal(outside).ends_with(", outside the scene's folder"));
}

TEST_CASE("a texture on triangles without vt is noted once a mesh") {
  const std::string file = "\"obj_file_path\": \"m.obj\"", texture = ", \"texture_file_path\": \"t.png\"";
  SceneFolder folder(object_of(file, texture) + "," + object_of(file, texture), roof + "vt 0 0\nf 1/1 2/1 3/1\n");
  folder.objects();
  CHECK(folder.reported() == Texts{"m.obj: found 4 triangles without vt, on which the texture is not shown"});
  SceneFolder plain(object_of(file), roof);
  plain.objects();
  CHECK(plain.notes.empty());
}

TEST_CASE("faults of several files beyond the first hundred are all counted") {
  std::string faces;
  for (int i = 0; i < 250; ++i) faces += "f 1 2 9\n";
  SceneFolder folder(object_of("\"obj_file_path\": \"m.obj\"") + "," + object_of("\"obj_file_path\": \"models/m.obj\""),
                     roof + faces);
  try {
    folder.objects();
    FAIL("no fault");
  } catch (const InputError& error) {
    CHECK(error.faults().size() == 101);
    CHECK(error.faults().back().found == "400 more faults");
    CHECK(error.unlisted() == 400);
  }
}

} // namespace refraster::test
