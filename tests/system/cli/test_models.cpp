// Models in the place of scenes, and options that change a scene, as a user gives them.

#include <refraster/files.h>

#include "tests/support/files/png_bytes.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using namespace refraster;

namespace {

/// A house with a red roof and a textured wall, of materials with blanks in their names.
struct ModelFolder : TemporaryFolder {
  ModelFolder() {
    save_text(
        *this / "my house.obj",
        "mtllib house.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nv 0 2 0\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl the wall\nf 4/1 3/2 7/3 8/4\nf 3/1 2/2 6/3 7/4\nf 2/1 1/2 5/3 6/4\nf "
        "1/1 4/2 8/3 5/4\n"
        "usemtl the roof\nf 8 7 9\nf 7 6 9\nf 6 5 9\nf 5 8 9\n");
    save_text(*this / "house.mtl",
              "newmtl the wall\nKd 1 1 1\nmap_Kd t.png\nnewmtl the roof\nKd 0.8 0.1 0.05\nKs 0.2 0.2 "
              "0.2\nNs 20\n");
    save_text(*this / "t.png", test::png_bytes(2, 2, 1, 8, {255, 128, 128, 255}));
  }
  Finished run(std::vector<std::string> words, const std::vector<std::string>& more = {}) const {
    words.insert(words.end(), more.begin(), more.end());
    return run_program(path, words);
  }
  Finished render(const std::vector<std::string>& more = {}) const {
    return run({"render", "my house.obj", "--size", "96x72", "-o", "i.png"}, more);
  }
  std::string image(const std::vector<std::string>& more = {}) const {
    const Finished run = render(more);
    CHECK_MESSAGE(run.exit_code == 0, run.err);
    return text_of(*this / "i.png");
  }
};

/// How many pixels differ from the one in the corner.
int pixels_of_model(const std::string& path) {
  const Image<float> image = read_image(path).values;
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += !std::equal(image.at(x, y), image.at(x, y) + 3, image.at(0, 0));
  return count;
}

} // namespace

TEST_CASE("a model is rendered by its name alone, within the margins, without a note") {
  const ModelFolder folder;
  const Finished run = folder.run({"render", "my house.obj"});
  CHECK(run.exit_code == 0);
  CHECK(run.out == "my house.png\n");
  CHECK(run.err.empty());
  const Image<float> image = read_image(folder / "my house.png").values;
  CHECK(image.width == 1280);
  CHECK(image.height == 720);
  // Of the rows, 5 % stay free above and below; the model touches both margins, or those at the sides.
  const auto shows = [&](int x, int y) { return !std::equal(image.at(x, y), image.at(x, y) + 3, image.at(0, 0)); };
  int top = 720, bottom = -1, left = 1280, right = -1;
  for (int y = 0; y < 720; ++y)
    for (int x = 0; x < 1280; ++x)
      if (shows(x, y))
        top = std::min(top, y), bottom = std::max(bottom, y), left = std::min(left, x), right = std::max(right, x);
  CHECK(top >= 35);
  CHECK(top <= 37);
  CHECK(bottom >= 682);
  CHECK(bottom <= 684);
  CHECK(std::abs(left - (1279 - right)) <= 2);
}

TEST_CASE("what the scene says of the picture holds where no option does") {
  const ModelFolder folder;
  const std::string as_it_is = folder.image();
  CHECK(folder.image({"--samples", "8", "--srgb"}) == as_it_is);
  CHECK(folder.image({"--linear"}) != as_it_is);
  CHECK(folder.image({"--samples", "1"}) != as_it_is);
  CHECK(folder.image({"--set", "/scene/picture/samples=1"}) == folder.image({"--samples", "1"}));
  CHECK(folder.render({"--crop", "90,0,10,10"}).exit_code == 2);
  CHECK(folder.run({"render", "my house.obj", "-o", "i.png", "--crop", "1280,0,1,1"}).exit_code == 2);
  // Floats are linear, whatever the picture says; to ask for the curve is wrong usage.
  CHECK(folder.run({"render", "my house.obj", "--size", "8x8", "-o", "i.pfm"}).exit_code == 0);
  CHECK(folder.run({"render", "my house.obj", "--size", "8x8", "-o", "i.pfm", "--srgb"}).exit_code == 2);
}

TEST_CASE("each option that changes a scene changes the image, for models and for scenes") {
  const ModelFolder folder;
  const std::vector<std::vector<std::string>> changes = {
      {"--camera", "-150,-20"},
      {"--camera", "30,20,9"},
      {"--look-at", "-1,0.5,1e-1"},
      {"--fov", "60"},
      {"--up", "0,0,1"},
      {"--background", "0.5,0,0"},
      {"--background", "#3c6e71"},
      {"--fragment-function", "phong"},
      {"--set", "/scene/objects/0/rotate_y=10"},
      {"--set", "/scene/direction_lights/*/radiance=[0.1, 0.2, 0.3]"}};
  const std::string as_it_is = folder.image();
  for (const std::vector<std::string>& change : changes) {
    CAPTURE(change[0]);
    CAPTURE(change[1]);
    CHECK(folder.image(change) != as_it_is);
    CHECK(pixels_of_model(folder / "i.png") > 300);
  }
  // A camera that stands somewhere is moved.
  save_text(folder / "s.json", R"({"scene": {"camera": {"position": "0 0 40", "target": "0 0 30", "near": 39},
    "point_lights": [], "direction_lights": [{"direction": "0 0 -1", "radiance": "1 1 1"}],
    "objects": [{"mesh": {"sphere": {}}, "fragment_function": "phong", "position": "7 8 9", "rotate_x": 0, "rotate_y": 0,
    "rotate_z": 0, "scale": "1 1 1", "material": {"ka": "1 1 1", "kd": "1 1 1", "ks": "0 0 0", "glossiness": 1}}]}})");
  CHECK(folder.run({"render", "s.json", "--size", "100x100", "-o", "s.png", "--camera", "200,10"}).exit_code == 0);
  CHECK(pixels_of_model(folder / "s.png") > 0.25 * 3.14 * 85 * 85);
  CHECK(
      folder.run({"render", "s.json", "--size", "100x100", "-o", "s.png", "--fragment-function", "merl"}).err ==
      "refraster: s.json:4:50: /scene/objects/0/material/brdf_file_path: found nothing, expected the path of a file\n");
}

TEST_CASE("what a changed scene says is what the option says") {
  const ModelFolder folder;
  CHECK(folder.image({"--fov", "50"}) == folder.image({"--set", "/scene/camera/fov_y=50"}));
  CHECK(folder.image({"--background", "0.5,0.25,0"}) == folder.image({"--set", "/scene/background=\"0.5 0.25 0\""}));
  CHECK(folder.image({"--set", "/scene/camera/fov_y=1", "--set", "/scene/camera/fov_y=50"}) ==
        folder.image({"--fov", "50"}));
  // White is the level 255, and half of it decoded.
  folder.image({"--background", "#ff8000"});
  const Image<float> image = read_image(folder / "i.png").values;
  CHECK(image.at(0, 0)[0] == 255);
  CHECK(image.at(0, 0)[1] == 128);
  CHECK(image.at(0, 0)[2] == 0);
}

TEST_CASE("a wrong value of an option that changes a scene: one line") {
  const ModelFolder folder;
  const auto refused = [&](int exit_code, const std::vector<std::string>& words, const std::string& line) {
    const Finished run = folder.render(words);
    CHECK(run.exit_code == exit_code);
    CHECK_MESSAGE(run.err.starts_with("refraster: " + line), run.err); // of usage, hints follow
  };
  const std::string camera =
      "azimuth,elevation or azimuth,elevation,distance: degrees, the second from -90 to 90, and a "
      "distance > 0";
  for (const std::string value : {"30", "a,b", "0,91", "0,0,0", "0,0,1,1", "nan,0", ""})
    refused(2, {"--camera", value}, "--camera: found \"" + value + "\", expected " + camera);
  refused(2, {"--look-at", "1,2"}, "--look-at: found \"1,2\", expected x,y,z: three numbers");
  refused(2, {"--up", "1,2,inf"}, "--up: found \"1,2,inf\", expected x,y,z: three numbers");
  refused(2, {"--fov", "180"}, "--fov: found \"180\", expected degrees > 0 and < 180");
  refused(2, {"--background", "red"},
          "--background: found \"red\", expected R,G,B (numbers >= 0; 1 is white) or #rrggbb");
  refused(2, {"--background", "#12345g"},
          "--background: found \"#12345g\", expected R,G,B (numbers >= 0; 1 is white) or #rrggbb");
  refused(2, {"--set", "/scene/camera/fov_y"},
          "--set: found \"/scene/camera/fov_y\", expected /POINTER=VALUE, a JSON pointer and JSON, as "
          "/scene/camera/fov_y=30");
  refused(3, {"--up", "0,0,0"}, "--up: /scene/camera/up: found a vector of length 0, expected a direction");
  refused(3, {"--set", "/scene/camera/fov_y=200"},
          "--set: /scene/camera/fov_y: found 200, expected a number > 0 and < 180");
  refused(3, {"--set", "/scene/camera/fov_y=wide"}, "--set:1:1: found \"wide\", expected a JSON value");
  refused(3, {"--set", "/scene/objects/1/name=\"a\""},
          "--set: /scene/objects/1/name: found \"1\" at /scene/objects, expected 0 to 0, or * for all");
  const Finished run = folder.render({"--set", "/scene/camera/fovy=30"});
  CHECK(run.exit_code == 3);
  CHECK_MESSAGE(run.err.ends_with("; did you mean fov_y?\n"), run.err);
  refused(3, {"--fragment-function", "merl"},
          "--fragment-function: /scene/objects/0/fragment_function: found a function that files describe no materials "
          "for, expected phong, blinn_phong or microfacet, or no material \"from_file\"");
}

TEST_CASE("a model is explained, compared with and measured as it is rendered") {
  const ModelFolder folder;
  folder.image();
  const Finished explained =
      folder.run({"explain", "my house.obj", "48", "36", "--size", "96x72", "--actual", "i.png"});
  CHECK_MESSAGE(explained.exit_code == 0, explained.err);
  CHECK(explained.out.find("my house") != std::string::npos);
  CHECK(folder.run({"compare", "i.png", "i.png", "--scene", "my house.obj"}).exit_code == 0);
  const Finished measured = folder.run({"bench", "my house.obj", "--size", "32x32", "--frames", "1", "--seconds", "0",
                                        "--gl", "none", "--no-marginal", "--no-command", "--no-error"});
  CHECK_MESSAGE(measured.exit_code == 0, measured.err);
  CHECK(measured.out.find("nothing is known of a shaded pixel") == std::string::npos);
  CHECK(folder.run({"verify", "my house.obj", "i.png"}).exit_code == 0);
}

TEST_CASE("a model's scene, written out, gives the same image, also from another folder") {
  const ModelFolder folder;
  const std::string direct = folder.image({"--camera", "70,5"});
  const Finished written = folder.run({"scene", "my house.obj", "--camera", "70,5"});
  CHECK_MESSAGE(written.exit_code == 0, written.err);
  CHECK(written.out == "my house.json\n");
  CHECK(written.err.empty());
  const std::string text = text_of(folder / "my house.json");
  CHECK(text.find("\"the wall\": {") != std::string::npos);
  CHECK(text.find("from_file") == std::string::npos);
  const auto image_of = [&](const std::string& scene, const std::vector<std::string>& more = {}) {
    const Finished run = folder.run({"render", scene, "--size", "96x72", "-o", "again.png"}, more);
    CHECK_MESSAGE(run.exit_code == 0, run.err);
    return text_of(folder / "again.png");
  };
  CHECK(image_of("my house.json") == direct);
  // Once more, of the scene.
  CHECK(folder.run({"scene", "my house.json", "-o", "second.json"}).exit_code == 0);
  CHECK(text_of(folder / "second.json") == text);

  std::filesystem::create_directory(folder.path / "other");
  const Finished elsewhere = folder.run({"scene", "my house.obj", "--camera", "70,5", "-o", "other/s.json"});
  CHECK(elsewhere.exit_code == 0);
  CHECK(elsewhere.err == "note: other/s.json names files outside its folder: reading it needs --allow-outside\n");
  CHECK(text_of(folder / "other/s.json").find("\"../t.png\"") != std::string::npos);
  CHECK(folder.run({"render", "other/s.json"}).exit_code == 3);
  CHECK(image_of("other/s.json", {"--allow-outside"}) == direct);

  CHECK(folder.run({"scene", "my house.obj", "-o", "my house.obj"}).exit_code == 2);
  CHECK(folder.run({"scene", "my house.obj", "-o", "none/s.json"}).exit_code == 4);
  CHECK(folder.run({"scene", "none.obj"}).err == "refraster: none.obj: found no such file, expected an OBJ file\n");
}

TEST_CASE("a model whose map_d cuts out shows what is behind, and so does its scene, written out") {
  const ModelFolder folder;
  const std::string whole = folder.image();
  save_text(folder / "mask.png",
            test::png_bytes(2, 2, 4, 8, {255, 255, 255, 0, 0, 0, 0, 255, 0, 0, 0, 255, 255, 0, 0, 0}));
  const auto with = [&](const std::string& options) {
    save_text(folder / "house.mtl", "newmtl the wall\nKd 1 1 1\nmap_Kd t.png\nmap_d " + options +
                                        "mask.png\nnewmtl the roof\nKd 0.8 0.1 0.05\nKs 0.2 0.2 0.2\nNs 20\n");
    const Finished run = folder.render();
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());
    return text_of(folder / "i.png");
  };
  const std::string by_alpha = with("");
  const std::string by_red = with("-imfchan r ");
  CHECK(by_alpha != whole);
  CHECK(by_red != whole);
  CHECK(by_red != by_alpha);
  CHECK(folder.run({"scene", "my house.obj", "-o", "s.json"}).exit_code == 0);
  CHECK(text_of(folder / "s.json").find("\"channel\": \"red\"") != std::string::npos);
  CHECK(folder.run({"render", "s.json", "--size", "96x72", "-o", "again.png"}).exit_code == 0);
  CHECK(text_of(folder / "again.png") == by_red);
  CHECK(folder.run({"mesh", "info", "my house.obj"}).out.find("textures    2 textures\n") != std::string::npos);
}

TEST_CASE("mesh info says what is in a model, and what is missing") {
  const ModelFolder folder;
  const Finished whole = folder.run({"mesh", "info", "my house.obj", "--json", "i.json"});
  CHECK_MESSAGE(whole.exit_code == 0, whole.err);
  CHECK(whole.err.empty());
  CHECK(whole.out ==
        "bounds      -1 0 -1  to  1 2 1\n"
        "size        2 2 2\n"
        "positions   9 in the file, 28 vertices of the mesh: one for each different position, normal and uv\n"
        "triangles   12 of 8 faces\n"
        "normals     none in the file: computed from the faces\n"
        "uvs         4 in the file; 4 triangles without\n"
        "colours     none\n"
        "materials   2 materials\n"
        "textures    1 texture\n");
  CHECK(text_of(folder / "i.json").find("\"library\": \"house.mtl\"") != std::string::npos);
  std::filesystem::remove(folder.path / "t.png");
  save_text(folder / "house.mtl", "newmtl the wall\nmap_Kd t.png\n");
  const Finished missing = folder.run({"mesh", "info", "my house.obj", "-q"});
  CHECK(missing.exit_code == 0);
  CHECK(missing.out.find("materials   2 materials; 1 described by no library: \"the roof\"\n"
                         "textures    1 texture; 1 missing: map_Kd \"t.png\"\n") != std::string::npos);
  CHECK(folder.run({"mesh", "info", "none.obj"}).err ==
        "refraster: none.obj: found no such file, expected an OBJ file\n");
  save_text(folder / "s.json", "{}");
  CHECK(folder.run({"mesh", "info", "s.json"}).err ==
        "refraster: s.json: found a scene, expected an OBJ file, whose name ends in .obj\n");
}
