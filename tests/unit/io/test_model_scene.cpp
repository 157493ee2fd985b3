// Models in the place of scenes, and changes to a scene before it is read.

#include <refraster/files.h>
#include <refraster/render.h>

#include "io/scene/model_scene.h"
#include "io/scene/scene_source.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/png_bytes.h"

#include <doctest/doctest.h>

#include <filesystem>

namespace refraster::test {
namespace {

/// A box with materials that have blanks in their names, a texture, and colours.
const std::string box =
    "mtllib my box.mtl\nv -1 -1 -1 1 0 0\nv 1 -1 -1 0 1 0\nv 1 1 -1 0 0 1\nv -1 1 -1 1 1 0\nv -1 -1 1 1 0 1\n"
    "v 1 -1 1 0 1 1\nv 1 1 1 1 1 1\nv -1 1 1 0 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl the front\nf 5/1 6/2 7/3 8/4\nusemtl the back, \"so to say\"\nf 2 1 4 3\nf 1 5 8 4\nf 6 2 3 7\nf 4 8 7 3\n";
const std::string library = "newmtl the front\nKd 1 1 1\nKs 0.5 0.5 0.5\nNs 40\nmap_Kd t.png\n"
                            "newmtl the back, \"so to say\"\nKd 0.8 0.2 0.1\n";

void write_box(const TemporaryFolder& folder, const std::string& name) {
  write_files(folder.path, {{name, box}, {"my box.mtl", library}, {"t.png", png_bytes(1, 1, 3, 8, {255, 128, 0})}});
}

Frame frame_of(const Scene& scene) {
  RenderOptions options;
  options.width = 96, options.height = 64, options.threads = 1, options.samples = 4;
  options.want_radiance = true;
  return render(scene, options);
}

std::string fault_of(const std::string& path, const std::vector<SceneEdit>& edits) {
  try {
    read_scene_source(path, {}, edits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string edited(const std::string& text, const std::vector<SceneEdit>& edits) {
  return edited_text("s.json", text, edits).text;
}

} // namespace

TEST_CASE("a model is read as the scene that shows it, with its materials, textures and colours") {
  const TemporaryFolder folder;
  for (const std::string name : {"b.obj", "my box.OBJ", "quo\"ted.Obj"}) {
    CAPTURE(name);
    write_box(folder, name);
    SceneSource source = read_scene_source(folder / name, {});
    REQUIRE(source.view.fit);
    CHECK(source.view.fit->azimuth_degrees == 30);
    CHECK(source.view.fit->elevation_degrees == 20);
    CHECK(source.view.fit->margin == 0.05);
    CHECK(source.view.picture == Picture{1280, 720, 8, Transfer::srgb});
    CHECK(source.view.moving_direction_lights.size() == source.scene.direction_lights.size());
    const Scene scene = std::move(source).placed(96, 64);
    REQUIRE(scene.objects.size() == 1);
    const Object& object = scene.objects[0];
    CHECK(object.two_sided == TwoSided::yes);
    CHECK(object.mesh->colours.size() == object.mesh->positions.size());
    REQUIRE(object.materials.size() == 2);
    CHECK(object.materials[0].name == "the front");
    CHECK(object.materials[0].texture);
    CHECK(object.materials[1].name == "the back, \"so to say\"");
    CHECK(std::holds_alternative<BlinnPhong>(object.materials[1].fragment_function));

    // The scene in its own file is the same scene.
    write_files(folder.path, {{"s.json", model_scene_text(name)}});
    const Scene again = read_scene_source(folder / "s.json", {}).placed(96, 64);
    CHECK(frame_of(again).radiance.values == frame_of(scene).radiance.values);
    // By itself a scene is placed for the image that it says.
    CHECK(read_scene(folder / name).camera.position ==
          read_scene_source(folder / name, {}).placed(1280, 720).camera.position);
  }
}

TEST_CASE("a model that the user names by a link may lie anywhere; what it names may not") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path / "here");
  std::filesystem::create_directories(folder.path / "there");
  write_files(folder.path, {{"there/m.obj", "mtllib ../there/m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"},
                            {"there/m.mtl", "newmtl a\nKd 1 0 0\n"}});
  std::filesystem::create_symlink(folder / "there/m.obj", folder / "here/m.obj");
  NoteList notes;
  SceneOptions options;
  options.notes = &notes;
  CHECK(read_scene(folder / "here/m.obj", options).objects[0].mesh->triangles.size() == 1);
  REQUIRE_FALSE(notes.notes().empty());
  CHECK(notes.notes()[0].text().find("outside the model's folder") != std::string::npos);
  write_files(folder.path, {{"here/s.json", model_scene_text("m.obj")}});
  CHECK(fault_of(folder / "here/s.json", {}).find("outside the scene's folder") != std::string::npos);
}

TEST_CASE("a model that cannot be shown: one line") {
  const TemporaryFolder folder;
  write_files(folder.path, {{"empty.obj", ""}, {"points.obj", "v 0 0 0\nv 1 1 1\n"}, {"f\xff.obj", box}});
  const auto fault = [&](const std::string& name) {
    return fault_of(folder / name, {}).substr(folder.path.string().size() + 1);
  };
  CHECK(fault("empty.obj") == "empty.obj: found an empty file, expected an OBJ file");
  CHECK(fault("points.obj") == "points.obj: found no face, only vertices, expected at least one face (a statement f)");
  CHECK(fault("none.obj") == "none.obj: found no such file, expected an OBJ file");
  CHECK(fault("f\xff.obj").ends_with(": found a file name that is no UTF-8, expected one that a scene can hold: rename "
                                     "the file"));
}

TEST_CASE("a change takes the place of a value, is added to an object, or takes a value away") {
  const std::string text = "{\"a\": {\"b\": 1, // c\n \"d\": [2, 3]}, \"e\": {}}";
  CHECK(edited(text, {{"/a/b", "[7]", "o"}}) == "{\"a\": {\"b\": [7], // c\n \"d\": [2, 3]}, \"e\": {}}");
  CHECK(edited(text, {{"/a/d/1", " 4 // no\n", "o"}}) == "{\"a\": {\"b\": 1, // c\n \"d\": [2, 4]}, \"e\": {}}");
  CHECK(edited(text, {{"/a/d/*", "0", "o"}}) == "{\"a\": {\"b\": 1, // c\n \"d\": [0, 0]}, \"e\": {}}");
  CHECK(edited(text, {{"/e/f/g~1~0", "1", "o"}}) ==
        "{\"a\": {\"b\": 1, // c\n \"d\": [2, 3]}, \"e\": {\"f\": {\"g/~\": 1}, }}");
  CHECK(edited(text, {{"/e", "", "o"}}) == "{\"a\": {\"b\": 1, // c\n \"d\": [2, 3]}}");
  CHECK(edited(text, {{"/a/b", "", "o"}, {"/a/d", "", "o"}, {"/a/x", "", "o"}}) == "{\"a\": {}, \"e\": {}}");
  CHECK(edited(text, {{"/e", "{\"f\": 1}", "o"}, {"/e/f", "2", "p"}}) ==
        "{\"a\": {\"b\": 1, // c\n \"d\": [2, 3]}, \"e\": {\"f\": 2}}");
  // What stays can be read: with commas behind the last member, too.
  for (const char* const odd : {"{\"a\": 1,}", "{\"b\": 0, \"a\": 1,}", "{/* x */ \"a\": 1 /* y */, \"b\": 0}"})
    CHECK_NOTHROW(JsonDocument("s.json", edited(odd, {{"/a", "", "o"}})));
}

TEST_CASE("a change that leads nowhere or is no JSON: one line, which names it") {
  const auto refused = [](const std::string& pointer, const std::string& value) -> std::string {
    try {
      edited("{\"a\": {\"b\": 1, \"d\": [2, 3], \"e\": []}}", {{pointer, value, "--set"}});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refused("/a/b/c", "1") == "--set: /a/b/c: found 1 at /a/b, expected an object or an array");
  CHECK(refused("/a/d/2", "1") == "--set: /a/d/2: found \"2\" at /a/d, expected 0 to 1, or * for all");
  CHECK(refused("/a/d/x", "1") == "--set: /a/d/x: found \"x\" at /a/d, expected 0 to 1, or * for all");
  CHECK(refused("/a/e/0", "1") == "--set: /a/e/0: found \"0\" at /a/e, expected nothing: the array is empty");
  CHECK(refused("a/b", "1") == "--set: a/b: found \"a/b\", expected a JSON pointer, as /scene/camera/fov_y");
  CHECK(refused("/a~2", "1") == "--set: /a~2: found ~ without 0 or 1, expected ~0 for ~, or ~1 for /");
  CHECK(refused("/a/b", "red") == "--set:1:1: found \"red\", expected a JSON value");
  CHECK(refused("/a/b", "1, \"x\": 2") == "--set:1:2: found \",\", expected the end of the file");
}

TEST_CASE("messages on a changed scene name what is wrong: the change, or the place in the file") {
  const TemporaryFolder folder;
  const std::string path = folder / "s.json";
  write_files(folder.path, {{"s.json", scene_with("\"kd\"", "\n  \"kd\"")}});
  CHECK(fault_of(path, {{"/scene/camera/fov_y", "200", "--set"}}) ==
        "--set: /scene/camera/fov_y: found 200, expected a number > 0 and < 180");
  CHECK(fault_of(path, {{"/scene/camera/fovy", "20", "--set"}})
            .starts_with("--set: /scene/camera/fovy: found an unknown key, expected one of fit, position"));
  CHECK(fault_of(path, {{"/scene/camera/fovy", "20", "--set"}}).ends_with("did you mean fov_y?"));
  // A fault behind a change, on the same line and on the next one, stands where it stood.
  write_files(folder.path, {{"s.json", scene_with("\"kd\": \"0.5 0.5 0.5\"", "\"kd\": 7,\n  \"kx\": 1")}});
  const std::string before = fault_of(path, {});
  CHECK(before.find("s.json:") != std::string::npos);
  CHECK(fault_of(path, {{"/scene/camera/fov_y", "20", "a"}, {"/scene/background", "[0, 0,\n\n 1]", "b"}}) == before);
}

TEST_CASE("a camera with a fit stands nowhere by itself") {
  const TemporaryFolder folder;
  const std::string path = folder / "s.json";
  write_files(folder.path, {{"s.json", scene_with("\"kd\"", "\"kd\"")}});
  const std::string fit = "{\"azimuth\": -90}";
  CHECK(fault_of(path, {{"/scene/camera/fit", fit, "o"}}).find("position: found both position and fit") !=
        std::string::npos);
  const std::optional<CameraFit> read =
      read_scene_source(path, {}, {{"/scene/camera", "{\"fit\": " + fit + ", \"target\": [1, 2, 3], \"near\": 2}", "o"}})
          .view.fit;
  REQUIRE(read);
  CHECK(read->azimuth_degrees == -90);
  CHECK(read->elevation_degrees == 20);
  CHECK(read->target == Double3(1, 2, 3));
  CHECK(read->near == 2);
  CHECK_FALSE(read->far);
  for (const auto& [value, expected] :
       {std::pair{"{\"elevation\": 91}", "elevation: found 91, expected a number from -90 to 90"},
        {"{\"margin\": 0.5}", "margin: found 0.5, expected a number from 0 to 0.49"},
        {"{\"distance\": 0}", "distance: found 0, expected a number > 0"},
        {"7", "fit: found 7, expected an object"}})
    CHECK(fault_of(path, {{"/scene/camera", "{\"fit\": " + std::string(value) + "}", "o"}}).find(expected) !=
          std::string::npos);
  CHECK(fault_of(path, {{"/scene/picture/samples", "3", "o"}}) ==
        "o: /scene/picture/samples: found 3, expected 1, 2, 4, 8 or 16");
}

} // namespace refraster::test
