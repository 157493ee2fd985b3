// What refraster verify --json writes, against docs/verify.schema.json, for every kind of run.

#include <refraster/files.h>

#include "tests/support/program/json_schema.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace refraster;

namespace {

const std::string scene = REFRASTER_SOURCE_DIR "/scenes/hello.json";

/// A folder with files, in which the program runs; arguments are parted at blanks.
struct Folder : TemporaryFolder {
  Finished run(const std::string& command) const {
    std::istringstream words(command);
    std::vector<std::string> arguments;
    for (std::string word; words >> word;) arguments.push_back(word);
    return run_program(path, arguments);
  }
  void render(const std::string& arguments) const {
    const Finished done = run("render " + scene + " --size 48x27 " + arguments);
    REQUIRE_MESSAGE(done.exit_code == 0, done.err);
  }
  /// The report of a run; it follows the schema.
  Json verify(const std::string& arguments, int exit_code) const {
    CAPTURE(arguments);
    const Finished done = run("verify " + scene + " " + arguments + " --json -");
    REQUIRE_MESSAGE(done.exit_code == exit_code, done.err);
    Json json = parsed(done.out);
    CHECK(schema_fault(json, text_of(REFRASTER_SOURCE_DIR "/docs/verify.schema.json")) == "");
    std::uint64_t classes = 0;
    for (const auto& member : std::as_const(json)["pixels"].GetObject())
      if (std::string(member.name.GetString()) != "all") classes += member.value.GetUint64();
    CHECK(classes == json["pixels"]["all"].GetUint64());
    CHECK(json["passes"].GetBool() == (exit_code == 0));
    return json;
  }
};

} // namespace

TEST_CASE("the report of a run where all is explained follows the schema") {
  const Folder folder;
  folder.render("-o a.png");
  const Json json = folder.verify("a.png", 0);
  CHECK(json["explained"].GetBool());
  CHECK(json["unexplained"].Empty());
  CHECK(json["hypotheses"].IsNull());
  CHECK(json["provenance"].HasMember("image sha256"));
  CHECK(json["size"][0].GetInt() == 48);
}

TEST_CASE("the report of a run with unexplained pixels and hypotheses follows the schema") {
  const Folder folder;
  folder.render("-o s.png --srgb");
  const Json json = folder.verify("s.png --device llvmpipe --fail-on depth:3,unexplained:2", 1);
  CHECK_FALSE(json["explained"].GetBool());
  CHECK(json["limits"].Size() == 2);
  CHECK_FALSE(json["unexplained"].Empty());
  CHECK_FALSE(json["clusters"].Empty());
  CHECK(json["hypotheses"]["named"].GetBool());
  CHECK_FALSE(json["hypotheses"]["causes"].Empty());
}

TEST_CASE("the reports of runs with depth and ids, with samples and with the sRGB curve follow the schema") {
  const Folder folder;
  folder.render("-o a.exr --aov object,triangle,depth");
  const Image<float> object = read_image((folder.path / "a.object.exr").string()).values,
                     triangle = read_image((folder.path / "a.triangle.exr").string()).values;
  Image<float> ids(object.width, object.height, 3);
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x) ids.at(x, y)[0] = *object.at(x, y), ids.at(x, y)[1] = *triangle.at(x, y);
  write_image((folder.path / "ids.pfm").string(), ids);
  CHECK(folder.verify("a.exr --ids ids.pfm --depth a.depth.exr", 0)["explained"].GetBool());
  for (float& value : ids.values) value += 1; // other surfaces than those that are there
  write_image((folder.path / "wrong.pfm").string(), ids);
  const Json wrong = folder.verify("a.exr --ids wrong.pfm --depth a.depth.exr", 1);
  CHECK(std::string(wrong["unexplained"][0]["objection"].GetString()) == "surface");

  folder.render("-o m.png --samples 4 --srgb");
  const Json several = folder.verify("m.png --samples 4 --srgb", 0);
  CHECK(several["samples"].GetInt() == 4);
  CHECK(several["srgb"].GetBool());
}

TEST_CASE("the report of what OpenGL draws follows the schema") {
  const Folder folder;
  const Finished tried = folder.run("gl " + scene + " -o a.png --renderer llvmpipe --size 48x27");
  if (tried.exit_code == 5) {
    MESSAGE("no OpenGL here: not tested");
    return;
  }
  for (const std::string more : {"--gl", "--gl-float", "--gl --samples 4"}) {
    const Json json = folder.verify(more + " --renderer llvmpipe --size 48x27", 0);
    CHECK(std::string(json["actual"].GetString()) == "drawn by OpenGL");
    CHECK(std::string(json["device"]["name"].GetString()) == "llvmpipe");
    CHECK(json["provenance"].HasMember("driver"));
  }
}
