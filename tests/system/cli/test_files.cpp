// Which files are read: those within the scene's folder, and of them those that are files.

#include "io/image/image_formats.h"
#include "tests/support/files/png_bytes.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace refraster;
namespace fs = std::filesystem;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string red_pixel = test::png_bytes(1, 1, 3, 8, {255, 0, 0});

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') result += "\\n";
    else result += c;
  }
  return result + "\"";
}

/// A scene of one object with these keys, and these in its material.
std::string scene_of(const std::string& keys, const std::string& material = "") {
  return R"({"scene": {"camera": {"position": "0 0 5"}, "point_lights": [], "direction_lights": [], "objects": [
  {)" + keys +
         R"(, "fragment_function": "phong", "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0,
  "scale": "1 1 1", "material": {"ka": "1 1 1", "kd": "1 1 1", "ks": "0 0 0", "glossiness": 1)" +
         material + "}}]}}";
}
std::string scene_with_mesh(const std::string& path) {
  return scene_of("\"obj_file_path\": " + quoted(path));
}

Finished render(const TemporaryFolder& folder, const std::string& scene, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"render", scene, "-o", "i.png", "--size", "4x4"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(folder.path, words);
}

/// `secret/`, beside `scene/` where the scene is.
void make_house(const TemporaryFolder& folder) {
  for (const char* const name : {"scene", "secret"}) {
    fs::create_directory(folder / name);
    save_text(folder / (std::string(name) + "/m.obj"), triangle);
    save_text(folder / (std::string(name) + "/t.png"), red_pixel);
  }
  fs::create_symlink("../secret/m.obj", folder / "scene/link.obj");
  fs::create_symlink("../secret", folder / "scene/door");
  fs::create_symlink("m.obj", folder / "scene/within.obj");
  fs::create_symlink(folder / "scene/m.obj", folder / "scene/absolute.obj");
}

} // namespace

TEST_CASE("a scene names no file outside its folder, by whatever way, unless it is allowed") {
  const TemporaryFolder folder;
  make_house(folder);
  for (const std::string& path : {std::string("../secret/m.obj"), folder / "secret/m.obj", std::string("link.obj"),
                                  std::string("door/m.obj"), std::string("./../scene/../secret/m.obj")}) {
    save_text(folder / "scene/s.json", scene_with_mesh(path));
    const Finished run = render(folder, "scene/s.json");
    INFO(path);
    CHECK(run.exit_code == 3);
    CHECK(run.err.starts_with("refraster: scene/s.json:2:21: /scene/objects/0/obj_file_path: found \""));
    CHECK(run.err.ends_with(", outside the scene's folder, expected a path within it, or --allow-outside\n"));
    CHECK_FALSE(fs::exists(folder / "i.png"));
    CHECK(render(folder, "scene/s.json", {"--allow-outside"}).exit_code == 0);
    fs::remove(folder / "i.png");
  }
}

TEST_CASE("what is said of a file outside does not tell whether it is there") {
  const TemporaryFolder folder;
  make_house(folder);
  std::string said[2];
  for (const int i : {0, 1}) {
    const std::string path = i == 0 ? "../secret/m.obj" : "../secret/n.obj";
    save_text(folder / "scene/s.json", scene_with_mesh(path));
    said[i] = render(folder, "scene/s.json").err;
    said[i].erase(said[i].find(path), path.size());
  }
  CHECK(said[0] == said[1]);
}

TEST_CASE("textures, tables and shaders lie within the scene's folder too") {
  const TemporaryFolder folder;
  make_house(folder);
  const std::string cube = R"("mesh": {"cube": {}})";
  const auto refused = [&](const std::string& scene, const std::string& key) {
    save_text(folder / "scene/s.json", scene);
    const Finished run = render(folder, "scene/s.json");
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.err.find(key + ": found \"../secret/t.png\", outside the scene's folder") != std::string::npos);
  };
  refused(scene_of(cube, R"(, "texture_file_path": "../secret/t.png")"), "/scene/objects/0/material/texture_file_path");
  refused(scene_of(cube + R"(, "vertex_shader_file_path": "../secret/t.png")"),
          "/scene/objects/0/vertex_shader_file_path");
  refused(scene_of(cube + R"(, "fragment_shader_file_path": "../secret/t.png")"),
          "/scene/objects/0/fragment_shader_file_path");
  std::string measured = scene_of(cube, R"(, "brdf_file_path": "../secret/t.png")");
  measured.replace(measured.find("\"phong\""), 7, "\"merl\"");
  refused(measured, "/scene/objects/0/material/brdf_file_path");
}

TEST_CASE("within the scene's folder, any way to a file is right") {
  const TemporaryFolder folder;
  make_house(folder);
  fs::create_directory(folder / "scene/deep");
  fs::create_directory_symlink("scene", folder / "other_name");
  for (const std::string& path : {std::string("m.obj"), std::string("deep/../m.obj"), std::string("within.obj"),
                                  std::string("absolute.obj"), folder / "scene/m.obj", folder / "other_name/m.obj"})
    for (const std::string scene : {"scene/s.json", "other_name/s.json", "./scene/../scene/s.json"}) {
      save_text(folder / "scene/s.json", scene_with_mesh(path));
      INFO(path << " of " << scene);
      CHECK(render(folder, scene).exit_code == 0);
    }
  // The folder of a scene that is named by itself is the current one.
  save_text(folder / "s.json", scene_with_mesh("scene/m.obj"));
  CHECK(render(folder, "s.json").exit_code == 0);
}

TEST_CASE("the scenes of the repository are read without --allow-outside") {
  int scenes = 0;
  for (const char* const name : {"/scenes/gallery", "/bench/scenes", "/scenes/lecture"})
    for (const fs::directory_entry& entry : fs::directory_iterator(REFRASTER_SOURCE_DIR + std::string(name))) {
      if (entry.path().extension() != ".json") continue;
      ++scenes;
      INFO(entry.path());
      CHECK(text_of(entry.path()).find("\"../") == std::string::npos);
    }
  CHECK(scenes >= 20);
}

TEST_CASE("what is no file is not read, nor waited for: a pipe, a socket, a device, a folder") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_directory(folder / "folder");
  const int bound = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (folder / "socket").copy(address.sun_path, sizeof address.sun_path - 1);
  REQUIRE(bind(bound, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  const std::pair<std::string, std::string> things[] = {{"pipe", "a device or pipe"},
                                                        {"socket", "a device or pipe"},
                                                        {"/dev/zero", "a device or pipe"},
                                                        {"/dev/tty", "a device or pipe"},
                                                        {"folder", "a folder"}};
  for (const auto& thing : things) {
    const std::string &path = thing.first, &found = thing.second;
    INFO(path);
    const auto says = [&](const Finished& run, const std::string& expected) {
      CHECK(run.exit_code == 3);
      CHECK_MESSAGE(run.err.find("found " + found) != std::string::npos, run.err);
      CHECK_MESSAGE(run.err.find("expected " + expected) != std::string::npos, run.err);
    };
    says(render(folder, path), "a scene file");
    save_text(folder / "s.json", scene_with_mesh(path));
    says(render(folder, "s.json", {"--allow-outside"}), "an OBJ file");
    save_text(folder / "s.json", scene_of(R"("mesh": {"cube": {}})", ", \"texture_file_path\": " + quoted(path)));
    says(render(folder, "s.json", {"--allow-outside"}), "an image");
    says(run_program(folder.path, {"compare", path, path}), "an image");
    says(run_program(folder.path, {"brdf", "info", path}), "a MERL table");
    save_text(folder / "a.png", red_pixel);
    says(run_program(folder.path, {"compare", "a.png", "a.png", "--limits", path}), "a JSON file of limits");
  }
  close(bound);
}

TEST_CASE("a file of 5 GB with nothing in it is refused for its size or its content, and takes no memory") {
  const TemporaryFolder folder;
  for (const char* const name : {"s.json", "m.obj", "t.binary", "i.png", "i.exr", "i.pfm"}) {
    save_text(folder / name, "");
    fs::resize_file(folder / name, 5'000'000'000);
  }
  save_text(folder / "mesh.json", scene_with_mesh("m.obj"));
  const std::uint64_t idle = run_program(folder.path, {"list", "precisions"}).peak_bytes;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& said) {
    const Finished run = run_program(folder.path, words);
    CHECK(run.exit_code == 3);
    CHECK_MESSAGE(run.err.starts_with("refraster: " + said + "\n"), run.err); // advice may follow
    CHECK(run.peak_bytes < idle + 20'000'000);
  };
  refused({"render", "s.json"}, "s.json: found a binary file, expected a scene file");
  std::fstream(folder / "s.json", std::ios::in | std::ios::out | std::ios::binary) << std::string(1 << 16, ' ');
  refused({"render", "s.json"}, "s.json: found 5000000000 bytes, expected at most 16777216 bytes");
  refused({"render", "mesh.json"}, "m.obj: found 5000000000 bytes, expected at most 2147483647 bytes");
  refused({"brdf", "info", "t.binary"}, "t.binary: dimensions: found 0 x 0 x 0, expected 90 x 90 x 180");
  const std::string unknown = ": found an unknown image type, expected " + readable_formats();
  refused({"compare", "i.png", "i.png"}, "i.png" + unknown);
  refused({"compare", "i.exr", "i.exr"}, "i.exr" + unknown);
  refused({"compare", "i.pfm", "i.pfm"}, "i.pfm" + unknown);
}

TEST_CASE("names may have spaces, letters of any language and line ends; a message stays one line") {
  const TemporaryFolder folder;
  for (const std::string& name : {std::string("a b"), std::string("Kugel äöü 球"), std::string("two\nlines"),
                                  std::string(200, 'x'), std::string("-q"), std::string("$HOME;*\"'\\")}) {
    INFO(name);
    save_text(folder / (name + ".obj"), triangle);
    save_text(folder / (name + ".json"), scene_with_mesh(name + ".obj"));
    const std::string scene = "./" + name + ".json", image = "./" + name + ".png";
    const Finished run =
        run_program(folder.path, {"render", scene, "-o", image, "--size", "4x4", "--report", "r.json"});
    CHECK_MESSAGE(run.exit_code == 0, run.err);
    CHECK(run.out == image + "\n");
    CHECK(fs::file_size(folder / (name + ".png")) > 50);

    save_text(folder / (name + ".obj"), "nothing");
    const Finished bad = run_program(folder.path, {"render", scene, "-o", image, "--size", "4x4"});
    CHECK(bad.exit_code == 3);
    CHECK(std::count(bad.err.begin(), bad.err.end(), '\n') == 1);
    CHECK(run_program(folder.path, {"render", scene, "-o", "./none/" + image}).exit_code == 4);
  }
}
