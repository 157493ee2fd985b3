// refraster verify, as a person calls it.

#include <refraster/files.h>

#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

using namespace refraster;

namespace {

/// Arguments at blanks.
Finished run(const std::string& command) {
  std::istringstream words(command);
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  return run_program(std::filesystem::temp_directory_path(), arguments);
}

const std::string scene = REFRASTER_SOURCE_DIR "/scenes/hello.json";

/// A small image of the scene that refraster itself has made; `arguments` are further ones of render.
std::string rendered(const TemporaryFolder& folder, const std::string& name, const std::string& arguments = "") {
  const std::string path = (folder.path / name).string();
  REQUIRE(run("render " + scene + " -o " + path + " --size 96x54 " + arguments).exit_code == 0);
  return path;
}

/// With one pixel changed.
std::string spoiled(const TemporaryFolder& folder, const std::string& from) {
  const ImageFile file = read_image(from);
  Image<std::uint8_t> image(file.values.width, file.values.height, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<std::uint8_t>(file.values.values[i]);
  image.at(48, 30)[0] = static_cast<std::uint8_t>(255 - image.at(48, 30)[0]);
  const std::string path = (folder.path / "spoiled.png").string();
  write_image(path, image);
  return path;
}

} // namespace

TEST_CASE("verify passes the reference, in 8 bits, in floats, with the sRGB curve and with several samples") {
  const TemporaryFolder folder;
  const auto exit_code = [&](const std::string& image, const std::string& arguments) {
    return run("verify " + scene + " " + image + " " + arguments).exit_code;
  };
  CHECK(exit_code(rendered(folder, "a.png"), "") == 0);
  CHECK(exit_code(rendered(folder, "a.pfm"), "") == 0);
  CHECK(exit_code(rendered(folder, "a.exr"), "") == 0);
  CHECK(exit_code(rendered(folder, "s.png", "--srgb"), "--srgb") == 0);
  CHECK(exit_code(rendered(folder, "s.png", "--srgb"), "") == 1);
  CHECK(exit_code(rendered(folder, "m.png", "--samples 4"), "--samples 4") == 0);
  CHECK(exit_code(rendered(folder, "m.png", "--samples 4"), "") == 1);
}

TEST_CASE("verify says where an image is wrong, and ends with 1") {
  const TemporaryFolder folder;
  const std::string image = spoiled(folder, rendered(folder, "a.png"));
  const Finished found = run("verify " + scene + " " + image + " --json " + (folder.path / "v.json").string() +
                             " --html " + (folder.path / "v.html").string());
  CHECK(found.exit_code == 1);
  CHECK(found.out.starts_with("unexplained: 1 of 5184 pixels"));
  CHECK(found.out.find("worst at (48, 30)") != std::string::npos);
  const std::string json = text_of(folder.path / "v.json");
  CHECK(json.find("\"unexplained\": 1") != std::string::npos);
  CHECK(json.find("\"x\": 48") != std::string::npos);
  CHECK(text_of(folder.path / "v.html").find("<!doctype html>") != std::string::npos);
  const Finished quiet = run("verify " + scene + " " + image + " -q");
  CHECK(quiet.exit_code == 1);
  CHECK(quiet.out.empty());
}

TEST_CASE("--fail-on changes what is too many") {
  const TemporaryFolder folder;
  const std::string image = spoiled(folder, rendered(folder, "a.png"));
  const auto exit_code = [&](const std::string& limit) {
    return run("verify " + scene + " " + image + " --fail-on " + limit + " -q").exit_code;
  };
  CHECK(exit_code("unexplained:1") == 0);
  CHECK(exit_code("unexplained") == 1);
  CHECK(exit_code("edge:3") == 1);
  CHECK(exit_code("unexplained:1,depth:9") == 0);
  for (const char* const wrong : {"exact", "edges", "edge:", "edge:-1", "edge:x", ":3", "edge,,depth"}) {
    CAPTURE(wrong);
    CHECK(exit_code(wrong) == 2);
  }
}

TEST_CASE("an image whose first row is the lowest is turned, and judged as it stands without being told") {
  const TemporaryFolder folder;
  const ImageFile file = read_image(rendered(folder, "a.png"));
  Image<std::uint8_t> image(file.values.width, file.values.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(file.values.at(x, image.height - 1 - y)[c]);
  const std::string path = (folder.path / "turned.png").string();
  write_image(path, image);
  CHECK(run("verify " + scene + " " + path + " --flip-y -q").exit_code == 0);
  const Finished unturned = run("verify " + scene + " " + path);
  CHECK(unturned.exit_code == 1);
  CHECK(unturned.out.find("turned upside down") != std::string::npos); // the cause has a name
}

TEST_CASE("colours over a background are judged as --premultiplied says that they are stored") {
  const TemporaryFolder folder;
  Image<float> image = read_image(rendered(folder, "a.exr")).values;
  Image<float> glass(image.width, image.height, 4, 0.5f);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.at(x, y), 3, glass.at(x, y));
  const std::string path = (folder.path / "glass.exr").string();
  write_image(path, glass);
  const auto exit_code = [&](const std::string& more) {
    return run("verify " + scene + " " + path + " -q " + more).exit_code;
  };
  CHECK(exit_code("") == 3);
  CHECK(exit_code("--alpha over:0,0,0") == 0); // EXR: stored multiplied by alpha
  CHECK(exit_code("--alpha over:0,0,0 --premultiplied yes") == 0);
  CHECK(exit_code("--alpha over:0,0,0 --premultiplied no") == 1); // half as bright
  CHECK(exit_code("--alpha ignore --premultiplied no") == 0);
}

TEST_CASE("what is wrong with a call or a file is one line") {
  const TemporaryFolder folder;
  const std::string image = rendered(folder, "a.png");
  const auto check = [&](const std::string& arguments, int exit_code, const std::string& said) {
    CAPTURE(arguments);
    const Finished found = run("verify " + arguments);
    CHECK(found.exit_code == exit_code);
    CHECK(found.err.find(said) != std::string::npos);
    CHECK(std::count(found.err.begin(), found.err.end(), '\n') <= 2);
  };
  check(scene, 2, "--gl");
  check(scene + " " + image + " --gl", 2, "expected one of them");
  check(scene + " " + image + " --renderer llvmpipe", 2, "--gl");
  check(scene + " " + image + " --size 96x54", 2, "--gl");
  check(scene + " --gl --ids " + image, 2, "--ids");
  check(scene + " " + image + " --device llvmpip", 3, "llvmpipe");
  check(scene + " " + image + " --ids " + image, 3, "8 bits");
  check(scene + " " + (folder.path / "none.png").string(), 3, "none.png");
  check(scene + " " + image + " --json " + (folder.path / "no/such/folder.json").string(), 4, "folder");
  save_text(folder.path / "empty.png", "");
  check(scene + " " + (folder.path / "empty.png").string(), 3, "empty.png");
}
