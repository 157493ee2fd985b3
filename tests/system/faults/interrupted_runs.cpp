// Ctrl-C in the middle of everything that can take long.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/system/faults/fault_runs.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

namespace refraster {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

struct LongWork {
  std::string name;
  Words words; // writes out/FILE
  std::string output;
  std::vector<double> moments_seconds; // after its start
};

std::string many_lights() {
  std::string lights;
  for (int i = 0; i < 20000; ++i)
    lights += std::string(i == 0 ? "" : ",") +
              R"({"position": [2, 3, 4], "radiance": [1, 1, 1], "constant": 1, "linear": 0, "quadratic": 0.2})";
  std::string scene = ball_scene;
  const std::size_t begin = scene.find("\"point_lights\": [") + 17, end = scene.find("],\n", begin);
  return scene.replace(begin, end - begin, lights);
}

/// One signal in one piece of work.
void interrupt(const std::string& folder, const LongWork& work, double moment, int signal, FaultRow& row) {
  const fs::path out = fs::path(folder) / "out";
  fs::remove_all(out);
  fs::create_directory(out);
  save_text(out / work.output, "old");
  Running run(folder, work.words);
  std::this_thread::sleep_for(std::chrono::duration<double>(moment));
  const auto sent = std::chrono::steady_clock::now();
  run.send(signal);
  const Finished end = run.wait();
  row.slowest_end_seconds =
      std::max(row.slowest_end_seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - sent).count());
  ++row.runs;
  const std::string what = "exit code " + std::to_string(end.exit_code) + ", \"" + end.err + "\"";
  if (end.exit_code == 0) ++row.done; // it was over
  else if (end.exit_code == 130) ++row.refused;
  else row.wrong.push_back(what);
  const std::string text = text_of(out / work.output);
  if (text == "old") {
    ++row.old_files;
  } else if (end.exit_code == 0) {
    ++row.new_files;
  } else { // it was written before the end: then it is what it would be without a signal
    run_program(folder, work.words);
    if (text_of(out / work.output) == text) ++row.new_files;
    else row.wrong.push_back("the output is neither old nor new: " + what);
  }
  if (std::distance(fs::directory_iterator(out), fs::directory_iterator()) != 1) {
    ++row.left_over;
    row.wrong.push_back("something is left: " + what);
  }
}

} // namespace

std::vector<FaultRow> interrupted_runs(Effort effort) {
  const test::TemporaryFolder folder;
  save_text(folder / "s.json", ball_scene);
  save_text(folder / "lights.json", many_lights());
  save_text(folder / "mesh.json", ball_from_file());
  const auto render = [](const char* scene, const char* size, const char* output) {
    return Words{"render", scene, "--size", size, "--samples", "8", "--tile-size", "128", "-o", output};
  };
  std::vector<LongWork> work = {
      {"a frame of 16384 x 16384", render("s.json", "16384x16384", "out/o.png"), "o.png", {0.1, 0.7}},
      {"a frame with 20000 lights", render("lights.json", "1280x720", "out/o.png"), "o.png", {0.5, 1}},
  };
  run_program(folder.path, {"mesh", "plane", "--segments", "1200", "-o", "m.obj"});
  run_program(folder.path, {"render", "s.json", "--size", "3000x3000", "-o", "a.png"});
  run_program(folder.path, {"render", "s.json", "--size", "3000x3000", "--precision", "fast", "-o", "b.png"});
  work.push_back({"reading an OBJ file of 2.9 million triangles",
                  render("mesh.json", "64x64", "out/o.png"),
                  "o.png",
                  {0.05, 0.2, 0.4, 0.8}});
  for (const char* const output : {"o.png", "o.exr", "o.pfm", "o.hdr"})
    work.push_back({std::string("drawing and writing ") + output + " of 6000 x 4000",
                    {"render", "s.json", "--size", "6000x4000", "-o", std::string("out/") + output},
                    output,
                    {0.3, 0.6, 0.9, 1.2, 1.5, 2, 2.5}});
  work.push_back({"making and writing a mesh of 8 million triangles",
                  {"mesh", "torus", "--segments", "2000", "--rings", "2000", "-o", "out/m.obj"},
                  "m.obj",
                  {0.1, 0.4, 1, 2}});
  work.push_back({"comparing images of 3000 x 3000",
                  {"compare", "a.png", "b.png", "--flip", "--diff", "out/d.png"},
                  "d.png",
                  {0.1, 0.3, 0.6, 1.2}});
  work.push_back({"measuring",
                  {"bench", "s.json", "--seconds", "100", "--gl", "none", "--json", "out/b.json"},
                  "b.json",
                  {0.1, 1}});
  work.push_back({"measuring with OpenGL beside",
                  {"bench", "s.json", "--seconds", "100", "--json", "out/b.json"},
                  "b.json",
                  {0.1, 1, 2}});
  work.push_back(
      {"drawing with OpenGL", {"gl", "s.json", "--frames", "1000000", "-o", "out/g.png"}, "g.png", {0.1, 0.5, 1}});
  if (effort != Effort::thorough) // one in the middle
    for (LongWork& each : work) each.moments_seconds = {each.moments_seconds[(each.moments_seconds.size() - 1) / 2]};
  std::vector<FaultRow> rows;
  const std::array<int, 2> signals = {SIGINT, SIGTERM};
  std::size_t next_signal = 0;
  for (const LongWork& each : work) {
    FaultRow row;
    row.fault = "SIGINT or SIGTERM, " + each.name;
    for (const double moment : each.moments_seconds)
      for (const int signal : signals)
        if (effort == Effort::thorough || signal == signals[next_signal])
          interrupt(folder.path, each, moment, signal, row);
    next_signal = 1 - next_signal; // else each by turns
    row.fault += ": all ended within " + std::to_string(row.slowest_end_seconds).substr(0, 4) + " s";
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace refraster
