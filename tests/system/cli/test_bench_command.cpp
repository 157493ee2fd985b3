// refraster bench, as a user runs it; and the schema of its report.

#include "tests/support/emulated.h"
#include "tests/support/program/json_schema.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

#include <csignal>
#include <thread>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

struct BallFolder : TemporaryFolder {
  BallFolder() { save_text(*this / "ball.json", ball_scene); }

  Finished bench(Words more) const {
    Words words = {"bench", "--size", "80x45", "--frames", "2", "--seconds", "0", "--gl", "none"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(path, words);
  }
};

/// Empty, or where the document is not what the schema says.
std::string fault(const Json& json) {
  return schema_fault(json, text_of(std::string(REFRASTER_SOURCE_DIR) + "/docs/bench.schema.json"));
}

} // namespace

TEST_CASE(
    "with --json - standard output is one document with a result for each scene, precision and number of threads") {
  const BallFolder folder;
  const Finished run = folder.bench({"ball.json", "--threads", "1,2", "--precisions", "float,double", "--json", "-"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  CHECK(fault(json) == "");
  const auto& results = json["results"];
  REQUIRE(results.Size() == 4);
  for (rapidjson::SizeType i = 0; i < 4; ++i) {
    CHECK(std::string(results[i]["scene"].GetString()) == "ball.json");
    CHECK(results[i]["size"][0].GetInt() == 80);
    CHECK(results[i]["size"][1].GetInt() == 45);
    CHECK(std::string(results[i]["precision"].GetString()) == (i < 2 ? "float" : "double"));
    CHECK(results[i]["threads"].GetInt() == (i % 2 == 0 ? 1 : 2));
    CHECK(results[i]["frame_ms"]["median"].GetDouble() > 0);
    CHECK(results[i]["opengl_ratio"].IsNull());
  }
  CHECK(holds(json["command"].GetString(), "refraster bench --size 80x45"));
  CHECK(files_in(folder) == Words{"ball.json"});
}

TEST_CASE("what is left out is null or empty") {
  const BallFolder folder;
  const Finished run =
      folder.bench({"ball.json", "--threads", "1", "--no-marginal", "--no-error", "--no-command", "--json", "-"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  CHECK(fault(json) == "");
  const auto& result = json["results"][0];
  CHECK(result["error"].IsNull());
  CHECK(result["marginal_cpu_ns_per_pixel"].IsNull());
  CHECK(result["fragment_functions"].Empty());
  CHECK(json["opengl"].Empty());
  CHECK(json["commands"].Empty());
  CHECK(json["scaling"].Empty());
}

TEST_CASE("the whole command is measured with what is changed of the scene, and its parts add up") {
  if (test::skipped_in_emulator("bench starts itself by its path, which this machine cannot run")) return;
  const BallFolder folder;
  std::filesystem::create_directories(folder / "other");
  std::filesystem::rename(folder / "ball.json", folder / "other/my ball.json");
  const Words words = {"other/my ball.json", "--fov=30",   "--set",        "/scene/background=[0.1, 0.2, 0.3]",
                       "--threads",          "1,2",        "--precisions", "float",
                       "--no-marginal",      "--no-error", "--json",       "-"};
  const Finished run = folder.bench(words);
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  CHECK(fault(json) == "");
  CHECK(json["notes"].Empty() == false); // of what can be said of so few repetitions
  REQUIRE(json["commands"].Size() == 2);
  for (const auto& command : json["commands"].GetArray()) {
    CHECK(std::string(command["scene"].GetString()) == "other/my ball.json");
    CHECK(command["repetitions"].GetInt() == 2);
    // Each is a median of two, and so a mean, which is linear.
    double sum = 0;
    for (const char* const part : {"start_ms", "read_ms", "frame_ms", "write_ms"})
      sum += command[part]["median"].GetDouble();
    CHECK(sum == doctest::Approx(command["whole_ms"]["median"].GetDouble()));
    CHECK(command["start_ms"]["min"].GetDouble() > 0);
    CHECK(command["cpu_ms"]["min"].GetDouble() > 0);
  }
  CHECK(files_in(folder) == Words{"other"});
}

TEST_CASE("several sizes are measured one after the other") {
  const BallFolder folder;
  const Finished run = run_program(folder.path, {"bench", "ball.json", "--size", "64x36,32x18", "--frames", "1",
                                                 "--seconds", "0", "--gl", "none", "--precisions", "float", "--threads",
                                                 "1", "--no-marginal", "--json", "a.json", "--html", "a.html"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(text_of(folder / "a.json"));
  REQUIRE(json["results"].Size() == 2);
  CHECK(json["results"][0]["size"][0].GetInt() == 64);
  CHECK(json["results"][1]["size"][0].GetInt() == 32);
  CHECK(holds(text_of(folder / "a.html"), "ball, 32 × 18"));
}

TEST_CASE("a scene that shows nothing is measured too") {
  const BallFolder folder;
  save_text(folder / "empty.json", empty_scene);
  const Finished run = folder.bench({"empty.json", "--no-command", "--json", "-"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  CHECK(fault(json) == "");
  CHECK(json["results"][0]["pixels"]["shaded"].GetInt() == 0);
  CHECK(json["results"][0]["per_shaded_pixel"]["wall_ns"].IsNull());
  CHECK(holds(json["notes"][0].GetString(),
              "empty.json: the image shows background only: the scene has no objects; nothing is known of a shaded"));
  CHECK(folder.bench({"empty.json", "--html", "empty.html"}).exit_code == 0);
}

TEST_CASE("curves of growth say whether it is linear, and stop where they are told to") {
  const BallFolder folder;
  const Finished run = folder.bench({"--scaling", "triangles:1e4,lights:8,overdraw:4,threads:2", "--precisions",
                                     "float", "--json", "-", "--html", "g.html"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  CHECK(fault(json) == "");
  CHECK(json["results"].Empty()); // no scene was named
  const auto& curves = json["scaling"];
  REQUIRE(curves.Size() == 5); // overdraw: both orders
  CHECK(std::string(curves[1]["growth"].GetString()) == "lights");
  CHECK(curves[1]["points"].Size() == 4);
  CHECK(curves[1]["no_faster_than_linear"].IsBool());
  CHECK(std::string(curves[2]["order"].GetString()) == "back to front");
  CHECK(std::string(curves[3]["order"].GetString()) == "front to back");
  CHECK(curves[3]["same_fragments"].GetBool());
  CHECK(curves[4]["no_faster_than_linear"].IsNull());
}

TEST_CASE("without --json a table is written; the page needs nothing from elsewhere") {
  const BallFolder folder;
  const Finished run = folder.bench({"ball.json", "--scaling", "lights:4", "--html", "page.html"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  for (const char* const words :
       {"ball.json: 80 x 45", "frame ms", "cycles/px", "interpolate", "one more light", "against exact"})
    CHECK_MESSAGE(holds(run.out, words), words << "\n" << run.out);
  std::string page = text_of(folder / "page.html");
  const std::string name_space = "xmlns=\"http://www.w3.org/2000/svg\""; // a name, from where nothing is fetched
  CHECK(holds(page, name_space));
  for (std::size_t at = page.find(name_space); at != std::string::npos; at = page.find(name_space))
    page.erase(at, name_space.size());
  CHECK(page.starts_with("<!doctype html>"));
  CHECK(page.ends_with("</html>\n"));
  for (const char* const words :
       {"<svg", "class=\"part5\"", "class=\"curve precision0\"", "What accuracy costs", "page.html"})
    CHECK_MESSAGE(holds(page, words), words);
  for (const char* const words :
       {"http:", "https:", "src=", "url(", "<script", "<link", "\"nan", "-nan", ">nan", "inf\"", ">inf"})
    CHECK_MESSAGE(!holds(page, words), words);
  CHECK(files_in(folder) == Words{"ball.json", "page.html"});
}

TEST_CASE("without a scene the built-in sphere is measured, whose every pixel is shaded") {
  const BallFolder folder;
  const Finished run = folder.bench({"--no-marginal", "--precisions", "float", "--threads", "1", "--json", "-"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  CHECK(std::string(json["results"][0]["scene"].GetString()) == "built-in sphere");
  CHECK(json["results"][0]["pixels"]["shaded"].GetInt() == 80 * 45);
}

TEST_CASE("more threads than CPUs are measured, and noted") {
  const BallFolder folder;
  const Finished run = folder.bench({"ball.json", "--threads", "64", "--no-marginal", "--no-error", "--json", "-"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  const Json json = parsed(run.out);
  REQUIRE(json["notes"].Size() >= 1); // there may be more, on the load of the machine
  CHECK(holds(json["notes"][0].GetString(), "64 threads share"));
}

TEST_CASE("with --csv a folder is made that holds a file for each table, and what is in it else stays") {
  const BallFolder folder;
  std::filesystem::create_directories(folder / "figures/here");
  save_text(folder / "figures/here/mine.txt", "mine");
  for (const char* const where : {"figures/here", "made/too"}) {
    const Finished run = folder.bench({"ball.json", "--precisions", "float", "--threads", "1", "--csv", where});
    REQUIRE_MESSAGE(run.exit_code == 0, run.err);
    for (const char* const name : {"frames", "split", "commands", "costs", "errors", "scaling", "machine"})
      CHECK(text_of(folder / (std::string(where) + "/" + name + ".csv")).size() > 20);
    CHECK(text_of(folder / (std::string(where) + "/frames.csv")).find("\nball.json,80,45,1,2,536,") !=
          std::string::npos);
  }
  CHECK(text_of(folder / "figures/here/mine.txt") == "mine");
  CHECK(folder.bench({"ball.json", "--csv", "ball.json"}).exit_code == 4);
  CHECK(folder.bench({"ball.json", "--csv", "made", "--json", "made/frames.csv"}).exit_code == 2);
}

TEST_CASE("-q leaves notes out of the table, and out of nothing else") {
  const BallFolder folder;
  const Words many = {"ball.json",    "--threads", "64",     "--no-marginal", "--no-error",
                      "--precisions", "float",     "--json", "a.json"};
  CHECK(holds(folder.bench(many).out, "note: 64 threads share"));
  Words quiet = many;
  quiet.emplace_back("-q");
  const Finished run = folder.bench(quiet);
  CHECK_MESSAGE(!holds(run.out, "note"), run.out);
  CHECK(holds(run.out, "ball.json: 80 x 45"));
  CHECK(run.err.empty());
  CHECK(holds(text_of(folder / "a.json"), "64 threads share"));
}

TEST_CASE("bad scenes and outputs are reported as everywhere") {
  const BallFolder folder;
  CHECK(folder.bench({"none.json"}).exit_code == 3);
  CHECK(folder.bench({"ball.json", "none.json", "--html", "page.html"}).exit_code == 3);
  CHECK(folder.bench({"ball.json", "--json", "none/a.json"}).exit_code == 4);
  CHECK(folder.bench({"ball.json", "--html", "none/a.html"}).exit_code == 4);
  CHECK(files_in(folder) == Words{"ball.json"});
}

TEST_CASE("a signal ends a benchmark with 130, and no report is written") {
  const BallFolder folder;
  Running run(folder.path, {"bench", "ball.json", "--gl", "none", "--seconds", "600", "--json", "a.json"});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  run.send(SIGINT);
  const Finished end = run.wait();
  CHECK(end.exit_code == 130);
  CHECK(end.out.empty());
  CHECK(files_in(folder) == Words{"ball.json"});
}
