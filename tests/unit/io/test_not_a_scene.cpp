// Files that are given for a scene: what they are called, and that the advice works when it is copied.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/scene/example_scene.h"
#include "io/scene/not_a_scene.h"
#include "io/scene/scene_source.h"
#include "raster/explain/explain_dark.h"
#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

using namespace refraster;
using namespace refraster::test;
using namespace std::string_literals;

namespace {

/// What is found where a scene is expected, and the advice; "" if nothing is wrong.
struct Said {
  std::string found, advice;
};
Said said_of(const TemporaryFolder& folder, const std::string& name) {
  try {
    read_scene(folder / name);
  } catch (const InputError& error) {
    return {error.faults()[0].found, error.advice()};
  }
  return {};
}

Said said_of_content(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  write_files(folder.path, {{name, content}});
  return said_of(folder, name);
}

/// The scene in an advice: from its first bracket to its last.
std::string scene_in(const std::string& advice) {
  const std::size_t begin = advice.find("{\"scene\""), end = advice.rfind("}}");
  REQUIRE_MESSAGE(begin != std::string::npos, advice);
  return advice.substr(begin, end + 2 - begin) + "\n";
}

/// Whether the scene shows a surface, and none that is nearly black.
bool shows_something(const std::string& path) {
  RenderOptions options;
  options.width = 120, options.height = 90;
  const Scene scene = read_scene_source(path, {}).placed(options.width, options.height);
  const Frame frame = render(scene, options);
  return frame.counts.shaded > 500 &&
         explain_dark_image(scene, options, {frame.rgb8, frame.radiance}, frame.counts.shaded).empty();
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

} // namespace

TEST_CASE("meshes are known by their content, whatever their name is") {
  const std::string binary_stl = std::string(80, 'h') + bytes_of(std::uint32_t{2}) + std::string(100, '\1');
  const std::vector<std::pair<std::string, std::string>> contents = {
      {"# exported\n\n  v 0 0 0\n", "an OBJ file"},
      {"mtllib a.mtl\n", "an OBJ file"},
      {"o box\n", "an OBJ file"},
      {"newmtl red\n", "the materials of an OBJ file"},
      {"solid box\nfacet normal 0 0 1\n", "an STL file"},
      {binary_stl, "an STL file"},
      {"ply\nformat ascii 1.0\n", "a PLY file"},
      {"ply\r\nformat ascii 1.0\r\n", "a PLY file"},
      {"glTF\2\0\0\0"s, "a glTF file"},
      {"{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0}", "a glTF file"},
      {"Kaydara FBX Binary  \0\x1a\0"s, "an FBX file"},
      {"; FBX 7.3.0 project file\n", "an FBX file"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>\n", "a COLLADA file"},
      {"BLENDER-v300", "a Blender file"},
      {"#usda 1.0\n", "a USD file"},
      {"PXR-USDC\0\0"s, "a USD file"}};
  for (const auto& one : contents) {
    const std::string &content = one.first, &found = one.second;
    CAPTURE(content);
    for (const char* const name : {"a.json", "a", "a.txt"}) CHECK(said_of_content(name, content).found == found);
  }
}

TEST_CASE("meshes are known by their name, where their content says nothing") {
  const std::vector<std::pair<std::string, std::string>> names = {
      {"a.stl", "an STL file"}, {"a.ply", "a PLY file"},     {"a.glb", "a glTF file"},
      {"a.fbx", "an FBX file"}, {"a.dae", "a COLLADA file"}, {"A.3DS", "a 3DS file"}};
  for (const auto& one : names) {
    const std::string &name = one.first, &found = one.second;
    CAPTURE(name);
    CHECK(said_of_content(name, "what is this?\n").found == found);
    CHECK(said_of_content(name, "\3\0\5"s).found == found);
  }
}

TEST_CASE("what else is given for a scene") {
  const std::vector<std::pair<std::string, std::string>> contents = {
      {"\x89PNG\r\n\x1a\n", "an image"},
      {"\xff\xd8\xff\xe0", "an image"},
      {"#?RADIANCE\n", "an image"},
      {"v/1\1\2\0\0\0"s, "an image"},
      {"PF\n2 2\n", "an image"},
      {bytes_of(90) + bytes_of(90) + bytes_of(180), "a MERL table"},
      {"#version 330 core\nvoid main() {}\n", "GLSL"},
      {"\xff\xfe{\0"s, "UTF-16 text"},
      {"\xff\xfe\0\0{\0\0\0"s, "UTF-32 text"},
      {"\3\0\5"s, "a binary file"},
      {"", "an empty file"}};
  for (const auto& one : contents) {
    const std::string &content = one.first, &found = one.second;
    CAPTURE(content);
    const Said said = said_of_content("a", content);
    CHECK(said.found == found);
    const TemporaryFolder folder;
    write_files(folder.path, {{"copied.json", scene_in(said.advice)}});
    CHECK(shows_something(folder / "copied.json"));
  }
}

TEST_CASE("text that may be JSON is judged as JSON") {
  CHECK(said_of_content("a.obj", "{\"scene\": ").advice.empty());
  CHECK(said_of_content("a.json", "// v 0 0 0\n{}").advice.empty());
  CHECK(said_of_content("a.json", " \n/* o */ {\"asset\": 1}").found == "nothing"); // no key scene
  CHECK(said_of_content("a.json", "hello\n").advice.empty());
}

TEST_CASE("a scene in an OBJ file's clothes is a scene") {
  const TemporaryFolder folder;
  write_files(folder.path, {{"s.obj", scene_with("0.5 0.5 0.5", "0.4 0.4 0.4")}});
  CHECK_NOTHROW(read_scene(folder / "s.obj"));
}

TEST_CASE("a folder: which scenes are in it") {
  const TemporaryFolder folder;
  write_files(folder.path, {{"f/", ""}, {"f/b.json", "{}"}, {"f/a.json", "{}"}, {"f/c.txt", ""}, {"none/", ""}});
  CHECK(said_of(folder, "f").found == "a folder");
  CHECK(said_of(folder, "f").advice == "In it there is " + (folder / "f/a.json") + ", " + (folder / "f/b.json") + "\n");
  CHECK(scene_in(said_of(folder, "none").advice) == example_scene());
}

TEST_CASE("an OBJ file of another name: the scene that is advised shows it") {
  const TemporaryFolder folder;
  write_files(folder.path, {{"a \"mesh\".txt", triangle}});
  const Said said = said_of(folder, "a \"mesh\".txt");
  CHECK(said.found == "an OBJ file");
  CHECK(said.advice.find("save it as " + (folder / "a \"mesh\".json")) != std::string::npos);
  write_files(folder.path, {{"a \"mesh\".json", scene_in(said.advice)}});
  CHECK(shows_something(folder / "a \"mesh\".json"));
  // The name that is advised is not one of a file that is there.
  CHECK(said_of(folder, "a \"mesh\".txt").advice.find("save it as " + (folder / "a \"mesh\".scene.json")) !=
        std::string::npos);
}

TEST_CASE("a file that is named for nothing is noted, with its line") {
  const auto notes_of = [](const std::string& from, const std::string& to) {
    const TemporaryFolder folder;
    write_files(folder.path, {{"s.json", scene_with(from, to)}});
    NoteList notes;
    SceneOptions options;
    options.notes = &notes;
    read_scene(folder / "s.json", options);
    std::string text;
    for (const Note& note : notes.notes()) text += note.text().substr(folder.path.string().size() + 1) + "\n";
    return text;
  };
  const std::string kd = R"("kd": "0.5 0.5 0.5")";
  CHECK(notes_of(kd, kd) == "");
  CHECK(notes_of(kd, kd + ",\n\"brdf_file_path\": \"not there.binary\"")
            .find(": found brdf_file_path \"not there.binary\", not read: the fragment function phong uses no measured "
                  "table\n") != std::string::npos);
}
