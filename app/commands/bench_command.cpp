// refraster bench [SCENE…]

#include "app/arguments.h"
#include "app/command.h"
#include "app/diagnostics.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "bench/measure/precision_errors.h"
#include "bench/measure/scene_bench.h"
#include "bench/page/page.h"
#include "bench/report/doubts.h"
#include "bench/report/report_csv.h"
#include "bench/report/report_json.h"
#include "bench/report/report_text.h"
#include "bench/workloads/built_in.h"
#include "gl/render_gl.h"
#include "io/scene/scene_file.h"
#include "raster/explain/explain_dark.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>

namespace refraster {
namespace {

using namespace bench;

enum class Errors { measured, left_out };

/// A curve that is asked for, and how far it goes.
struct GrowthRequest {
  Growth growth;
  double most;
};

/// "triangles,pixels:1e6", "all", "all:100".
std::optional<std::vector<GrowthRequest>> scaling_from(std::string_view text) {
  std::vector<GrowthRequest> requests;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string_view word = text.substr(start, end - start), kind = word.substr(0, word.find(':'));
    start = end + 1;
    double most = std::numeric_limits<double>::infinity();
    if (kind.size() < word.size()) {
      const std::optional<double> limit = distance_from(word.substr(kind.size() + 1));
      if (!limit || *limit < 1) return std::nullopt;
      most = *limit;
    }
    const std::size_t before = requests.size();
    for (const auto& [growth, name] : growth_names)
      if (kind == name || kind == "all") requests.push_back({growth, most});
    if (requests.size() == before) return std::nullopt;
  }
  return requests;
}

struct BenchArguments {
  std::vector<std::string> scenes, precisions;
  SceneOptions reading;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
  std::vector<int> threads;
  std::vector<GrowthRequest> scaling;
  std::vector<Size> sizes = {Size{}};
  int samples = 1, frames = 9;
  double seconds = 3;
  std::string gl = "llvmpipe", json, html, csv;
  bool gl_named = false; // by the user, who then does not want to do without
  Marginals marginals = Marginals::measured;
  Errors errors = Errors::measured;
};

/// As it was typed, words with spaces in quotes.
std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {}), line;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\0', start), text.size());
    std::string word = text.substr(start, end - start);
    if (start == 0) word = word.substr(word.rfind('/') + 1);
    if (word.find(' ') != std::string::npos) word = "'" + word + "'";
    line += (start == 0 ? "" : " ") + word;
    start = end + 1;
  }
  return line;
}

std::optional<GlRenderer> renderer_named(const std::string& name) {
  for (const auto& [value, listed] : EnumNames<GlRenderer>::names)
    if (listed == name) return value;
  return std::nullopt;
}

/// The scenes, read one at a time, each once it is its turn.
class Bench {
public:
  explicit Bench(const BenchArguments& arguments) : a_(arguments), opengl_(renderer_named(arguments.gl)) {
    run_.command = command_line();
    run_.started = utc_now();
    run_.machine = this_machine();
    run_.load_at_start = load_average();
    run_.warm_up = repetitions_.warm_up;
    run_.min_repetitions = repetitions_.least = a_.frames;
    run_.seconds = repetitions_.seconds = a_.seconds;
    repetitions_.stop = &interrupted();
    const auto usable = static_cast<int>(run_.machine.usable_cpus.size());
    for (const int threads : a_.threads)
      if (threads > usable)
        run_.notes.push_back(std::to_string(threads) + " threads share " + std::to_string(usable) + " CPUs");
    if (a_.samples > 1 && opengl_) {
      run_.notes.emplace_back("OpenGL is left out: it is drawn with one sample a pixel");
      opengl_.reset();
    }
  }

  void add(const std::string& name, const Scene& scene) {
    for (const Size& size : a_.sizes)
      if (!interrupted()) add(name, scene, size);
  }

  void add(const std::string& name, const Scene& scene, const Size& size) {
    SceneTask task{.name = name,
                   .scene = scene,
                   .width = size.width,
                   .height = size.height,
                   .samples = a_.samples,
                   .precisions = a_.precisions,
                   .threads = a_.threads,
                   .marginals = a_.marginals,
                   .opengl = opengl_};
    SceneResult result = timed(task);
    if (interrupted()) return;
    if (a_.errors == Errors::measured)
      result.errors = precision_errors(task, static_cast<int>(run_.machine.usable_cpus.size()));
    if (result.counts.shaded == 0) {
      RenderOptions options;
      options.width = size.width, options.height = size.height;
      run_.notes.push_back(name + ": " + explain_no_surface(scene, options) + "; nothing is known of a shaded pixel");
    }
    run_.scenes.push_back(std::move(result));
  }

  void add_scaling(const GrowthRequest& request) {
    ScalingTask task{.growth = request.growth,
                     .most = request.most,
                     .size = {a_.sizes.front().width, a_.sizes.front().height},
                     .threads = a_.threads.front(),
                     .precisions = a_.precisions};
    const PinnedThreadPool thread_pool;
    for (const LayerOrder order : {LayerOrder::back_to_front, LayerOrder::front_to_back}) {
      if (order != LayerOrder::back_to_front && request.growth != Growth::overdraw) continue;
      const auto line =
          progress_line(a_.diagnostics, "measuring how cost grows with " + std::string(name_of(request.growth)));
      show_progress(line.get());
      task.order = order;
      for (ScalingCurve& curve : measure_scaling(task, repetitions_, thread_pool))
        run_.scaling.push_back(std::move(curve));
    }
  }

  Run finished() {
    run_.ended = utc_now();
    run_.load_at_end = load_average();
    for (std::string& note : doubts(run_)) run_.notes.push_back(std::move(note));
    return std::move(run_);
  }

private:
  SceneResult timed(SceneTask& task) {
    const auto line = progress_line(a_.diagnostics, "measuring " + task.name);
    show_progress(line.get());
    const PinnedThreadPool thread_pool;
    try {
      return bench_scene(task, repetitions_, thread_pool);
    } catch (const NoOpenGl& error) {
      if (a_.gl_named) throw;
      run_.notes.push_back(std::string("without OpenGL beside: ") + error.what());
      opengl_.reset();
      task.opengl.reset();
    }
    return bench_scene(task, repetitions_, thread_pool);
  }

  /// On a line, if there is one.
  void show_progress(ProgressLine* line) {
    repetitions_.progress = {};
    if (line) repetitions_.progress = [line](double fraction) { line->show(fraction); };
  }

  const BenchArguments& a_;
  std::optional<GlRenderer> opengl_;
  Repetitions repetitions_;
  Run run_;
};

std::string csv_path(const BenchArguments& a, std::string_view name) {
  return (std::filesystem::path(a.csv) / name).string();
}

enum class Remarks { printed, withheld };

Scene scene_of(const std::string& path, const BenchArguments& a, Remarks remarks) {
  NoteList notes;
  SceneOptions reading = a.reading;
  reading.notes = &notes;
  Scene scene = read_scene(path, reading);
  if (a.diagnostics.file_notes == FileNotes::refused || remarks == Remarks::printed)
    print_file_notes(notes, a.diagnostics);
  return scene;
}

ExitCode run(const BenchArguments& a) {
  std::vector<std::string> outputs = {a.json, a.html};
  if (!a.csv.empty()) {
    prepare_folder(a.csv);
    for (const std::string_view name : csv_file_names) outputs.push_back(csv_path(a, name));
  }
  check_different(outputs, a.scenes);
  for (const std::string& path : outputs)
    if (!path.empty()) check_writable(path);
  prepare_cache(a.reading.mesh_cache);
  // What is wrong with any of them is reported before the first is measured.
  if (a.scenes.size() > 1)
    for (const std::string& path : a.scenes) scene_of(path, a, Remarks::withheld);
  Bench bench(a);
  try {
    if (a.scenes.empty() && a.scaling.empty()) bench.add(built_in_name, built_in_scene());
    for (const std::string& path : a.scenes) {
      bench.add(path, scene_of(path, a, Remarks::printed));
      if (interrupted()) return ExitCode::interrupted;
    }
    for (const GrowthRequest& request : a.scaling) {
      bench.add_scaling(request);
      if (interrupted()) return ExitCode::interrupted;
    }
  } catch (const NoOpenGl& error) {
    std::cerr << "refraster: " << error.what() << "\n";
    return ExitCode::no_opengl;
  }
  if (interrupted()) return ExitCode::interrupted;
  Run found = bench.finished();
  if (!a.json.empty()) write_text(a.json, run_json(found));
  if (!a.html.empty()) write_text(a.html, run_html(found));
  if (!a.csv.empty())
    for (const CsvTable& table : csv_tables(found)) write_text(csv_path(a, table.file_name), table.text);
  if (a.diagnostics.verbosity == Verbosity::quiet) found.notes.clear(); // files keep theirs
  if (a.json != standard_output && a.html != standard_output) std::cout << run_text(found);
  return ExitCode::ok;
}

/// Without an option: all precisions; one thread, and as many as there are CPUs.
void fill_defaults(BenchArguments& a) {
  if (a.precisions.empty()) a.precisions = lane_precision_names();
  if (!a.threads.empty()) return;
  a.threads = {1};
  if (const auto usable = static_cast<int>(usable_cpus().size()); usable > 1) a.threads.push_back(usable);
}

} // namespace

void add_bench(CLI::App& program, Action& chosen) {
  CLI::App& command = add_sub_command(program, "bench", "Measure what a pixel costs, and what accuracy it buys");
  const auto arguments = std::make_shared<BenchArguments>();
  BenchArguments& a = *arguments;
  command.add_option("scenes", a.scenes, "scene files; without one, a sphere that fills the image")
      ->type_name("SCENE")
      ->default_str("");
  add_parsed_option(command, "--size", a.sizes, sizes_from, "WxH,…",
                    "WIDTHxHEIGHT, each 1 to " + std::to_string(largest_side) + ", divided by commas, each once",
                    "pixels of the image, or several sizes")
      ->default_str("1280x720");
  std::string listed;
  for (const std::string& name : lane_precision_names()) listed += (listed.empty() ? "" : ",") + name;
  add_parsed_option(command, "--precisions", a.precisions, precisions_from, "NAME,…",
                    "some of " + listed + ", each once", "precisions, divided by commas")
      ->default_str(listed);
  add_parsed_option(command, "--threads", a.threads, thread_counts_from, "N,…",
                    "numbers from 1 to 1024 divided by commas, each once", "numbers of threads, divided by commas")
      ->default_str("1 and all CPUs");
  add_number_option(command, "--frames", a.frames, Range{1, 1000000},
                    "repetitions at least; each draws a frame of everything");
  add_number_option(command, "--seconds", a.seconds, Range{0, 86400},
                    "and more repetitions until so much time has passed, for each scene");
  add_choice_option(command, "--samples", a.samples, {1, 2, 4, 8, 16}, "samples a pixel");
  add_choice_option(command, "--gl", a.gl, {"llvmpipe", "softpipe", "default", "none"},
                    "OpenGL to draw the same frames in between; left out where there is none, unless it is named here");
  add_parsed_option(
      command, "--scaling", a.scaling, scaling_from, "KIND[:MOST],…",
      "some of triangles, pixels, lights, overdraw, threads, all, each with or without a number like :1e6",
      "how cost grows with the number of triangles (up to 1e7), pixels (16384^2), lights (256), overdraw "
      "(64), threads (CPUs), or all of them; MOST is where to stop");
  add_outside_option(command, a.reading.outside);
  add_memory_option(command, a.max_memory);
  add_cache_option(command, a.reading.mesh_cache);
  add_strict_option(command, a.diagnostics);
  add_quiet_option(command, a.diagnostics);
  command.add_option("--json", a.json, "write the report as JSON; - is standard output")->type_name("FILE");
  command.add_option("--html", a.html, "write the report as one HTML page with pictures; - is standard output")
      ->type_name("FILE");
  command.add_option("--csv", a.csv, "folder to write a .csv file for each table to; made if need be")
      ->type_name("DIR");
  command.add_flag_callback(
      "--no-marginal", [&a] { a.marginals = Marginals::left_out; },
      "only the scene as it is: no further light, texture, samples");
  command.add_flag_callback(
      "--no-error", [&a] { a.errors = Errors::left_out; }, "do not measure how far images are from the right ones");
  command.footer("How it measures: docs/bench.md. The JSON: docs/reports.md.");
  command.final_callback([&chosen, &command, arguments] {
    arguments->gl_named = command.count("--gl") > 0;
    fill_defaults(*arguments);
    for (const Size& size : arguments->sizes) check_frame_samples(size.width, size.height, arguments->samples);
    chosen = [arguments] {
      arguments->reading.memory = set_memory_limit(
          arguments->max_memory, *std::max_element(arguments->threads.begin(), arguments->threads.end()));
      return run(*arguments);
    };
  });
}

} // namespace refraster
