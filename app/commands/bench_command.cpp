// refraster bench [SCENE…]

#include <refraster/files.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/diagnostics.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "bench/measure/command_runs.h"
#include "bench/measure/precision_errors.h"
#include "bench/measure/scene_bench.h"
#include "bench/page/page.h"
#include "bench/report/begun_run.h"
#include "bench/report/report_csv.h"
#include "bench/report/report_json.h"
#include "bench/report/report_text.h"
#include "bench/workloads/built_in.h"
#include "gl/render_gl.h"
#include "io/file/nearest.h"
#include "io/scene/scene_source.h"

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
enum class WholeCommand { measured, left_out };

/// A curve that is asked for, and how far it goes.
struct GrowthRequest {
  Growth growth;
  double most;
};

/// What --scaling knows: the curves, and all of them.
std::vector<std::string> scaling_words() {
  std::vector<std::string> words;
  for (const auto& [growth, name] : growth_names) words.emplace_back(name);
  words.emplace_back("all");
  return words;
}

/// Adds what one of "triangles,pixels:1e6,all:100" asks for.
std::optional<ValueFault> add_scaling(std::string_view word, std::vector<GrowthRequest>& requests) {
  const std::string_view kind = word.substr(0, word.find(':'));
  double most = std::numeric_limits<double>::infinity();
  if (kind.size() < word.size()) {
    const std::optional<double> limit = distance_from(word.substr(kind.size() + 1));
    if (!limit || *limit < 1) return ValueFault{"a number >= 1 behind the colon, as :1e6", std::string(word)};
    most = *limit;
  }
  const std::size_t before = requests.size();
  for (const auto& [growth, name] : growth_names)
    if (kind == name || kind == "all") requests.push_back({growth, most});
  if (requests.size() > before) return std::nullopt;
  const std::vector<std::string> words = scaling_words();
  return ValueFault{one_of({words.begin(), words.end()}, kind), std::string(kind)};
}

Option scaling_option(std::vector<GrowthRequest>& requests) {
  const auto read = [&requests](const std::string& text) -> std::optional<ValueFault> {
    for (const std::string_view word : split(text, ','))
      if (const auto fault = add_scaling(word, requests)) return fault;
    return std::nullopt;
  };
  Option option =
      value_option("--scaling", "KIND[:MOST],…",
                   "how cost grows with the number of triangles (up to 1e7), pixels (16384^2), lights (256), overdraw "
                   "(64), threads (CPUs), or all of them; MOST is where to stop",
                   read);
  option.completes = Completes::words;
  option.words = scaling_words();
  return option;
}

constexpr const char* default_gl = "llvmpipe";
constexpr int max_least_commands = 3; // as many as have quartiles

struct BenchArguments {
  std::vector<std::string> scenes, precisions;
  SceneOptions reading;
  SceneChanges changes;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
  std::vector<int> threads;
  std::vector<GrowthRequest> scaling;
  std::vector<Size> sizes = {Size{}};
  int samples = 1, frames = 9;
  double seconds = 3;
  std::optional<std::string> gl; // named by the user, who then does not want to do without
  std::string json, html, csv;
  Marginals marginals = Marginals::measured;
  Errors errors = Errors::measured;
  WholeCommand whole_command = WholeCommand::measured;
  std::vector<std::string> scene_words; // those of the command line that say how scenes are read
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

/// The same options, of which what was given is kept: for a process that is to read scenes likewise.
std::vector<Option> remembered(std::vector<Option> options, std::vector<std::string>& words) {
  for (Option& option : options) {
    if (option.is_argument()) continue;
    option.read = [read = option.read, name = option.name, takes = option.takes, &words](const std::string& text) {
      words.push_back(name);
      if (takes != Takes::nothing) words.push_back(text);
      return read(text);
    };
  }
  return options;
}

std::optional<GlRenderer> renderer_named(const std::string& name) {
  for (const auto& [value, listed] : EnumNames<GlRenderer>::names)
    if (listed == name) return value;
  return std::nullopt;
}

/// The scenes, read one at a time, each once it is its turn.
class Bench {
public:
  explicit Bench(const BenchArguments& arguments)
      : a_(arguments), opengl_(renderer_named(arguments.gl.value_or(default_gl))) {
    repetitions_.least = a_.frames, repetitions_.seconds = a_.seconds;
    repetitions_.stop = &interrupted();
    run_ = begun_run(command_line(), repetitions_, a_.threads);
    if (a_.samples > 1 && opengl_) {
      run_.notes.emplace_back("OpenGL is left out: it is drawn with one sample a pixel");
      opengl_.reset();
    }
  }

  /// path: of the file that the scene is read from; empty: there is none.
  void add(const std::string& name, const SceneSource& source, const std::string& path) {
    for (const Size& size : a_.sizes)
      if (!interrupted()) add(name, source, path, size);
  }

  void add(const std::string& name, const SceneSource& source, const std::string& path, const Size& size) {
    const Scene scene = SceneSource(source).placed(size.width, size.height);
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
    if (!path.empty() && a_.whole_command == WholeCommand::measured) result.commands = commands(task, path);
    if (interrupted()) return;
    if (a_.errors == Errors::measured)
      result.errors = precision_errors(task, static_cast<int>(run_.machine.usable_cpus.size()));
    add_scene(run_, task, std::move(result));
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
    end_run(run_);
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
      if (a_.gl) throw;
      run_.notes.push_back(std::string("without OpenGL beside: ") + error.what());
      opengl_.reset();
      task.opengl.reset();
    }
    return bench_scene(task, repetitions_, thread_pool);
  }

  std::vector<CommandResult> commands(const SceneTask& task, const std::string& path) {
    const auto line = progress_line(a_.diagnostics, "measuring the whole command on " + task.name);
    show_progress(line.get());
    CommandTask whole{{std::filesystem::read_symlink("/proc/self/exe")},
                      a_.scene_words,
                      task.width,
                      task.height,
                      task.samples,
                      task.precisions,
                      task.threads};
    whole.words.push_back(path);
    // Each reads the scene anew: for a large model that takes longer than all of its frames.
    Repetitions few = repetitions_;
    few.least = std::min(few.least, max_least_commands);
    std::string failure;
    std::vector<CommandResult> results = measure_commands(whole, few, failure);
    if (!failure.empty() && !interrupted())
      run_.notes.push_back("the whole command is not measured on " + task.name + ": " + failure);
    return results;
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

SceneSource scene_of(const std::string& path, const BenchArguments& a, Remarks remarks) {
  NoteList notes;
  SceneOptions reading = a.reading;
  reading.notes = &notes;
  reading.threads = *std::max_element(a.threads.begin(), a.threads.end());
  SceneSource source = read_scene_source(path, reading, a.changes.edits());
  if (a.diagnostics.file_notes == FileNotes::refused || remarks == Remarks::printed)
    print_file_notes(notes, a.diagnostics);
  return source;
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
    if (a.scenes.empty() && a.scaling.empty()) bench.add(built_in_name, {built_in_scene(), {}, {}}, "");
    for (const std::string& path : a.scenes) {
      bench.add(path, scene_of(path, a, Remarks::printed), path);
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

Command bench_command() {
  const auto arguments = std::make_shared<BenchArguments>();
  BenchArguments& a = *arguments;
  const std::vector<std::string> precisions = lane_precision_names();
  const auto set_precisions = [&a, precisions](const std::vector<std::size_t>& indices) {
    for (const std::size_t i : indices) a.precisions.push_back(precisions[i]);
  };
  const OptionGroup view = scene_change_options(a.changes);
  std::string listed;
  for (const std::string& name : precisions) listed += (listed.empty() ? "" : ",") + name;
  return {
      .name = "bench",
      .meaning = "Measure what a pixel costs, and what accuracy it buys",
      .groups =
          {{"Scenes",
            remembered({refraster::arguments("SCENE", a.scenes,
                                             "scene files or OBJ models; without one, a sphere that fills the image"),
                        outside_option(a.reading.outside), cache_option(a.reading.mesh_cache)},
                       a.scene_words)},
           {view.heading, remembered(view.options, a.scene_words)},
           {"What is measured",
            {parsed_option("--size", "WxH,…", a.sizes, sizes_from,
                           "WIDTHxHEIGHT, each 1 to " + std::to_string(largest_side) +
                               ", separated by commas, each once",
                           "pixels of the image, or several sizes")
                 .by_default("1280x720"),
             word_list_option("--precisions", "NAME,…", precisions, set_precisions, "number types of shading")
                 .by_default(listed),
             parsed_option("--threads", "N,…", a.threads, thread_counts_from,
                           "numbers from 1 to 1024 separated by commas, each once", "numbers of threads")
                 .by_default("1 and all CPUs"),
             number_choice_option("--samples", a.samples, {1, 2, 4, 8, 16}, "samples a pixel"),
             choice_option("--gl", a.gl, {"llvmpipe", "softpipe", "default", "none"},
                           "OpenGL to draw the same frames in between; left out where there is none, unless it is "
                           "named here")
                 .by_default(default_gl),
             scaling_option(a.scaling),
             flag(
                 "--no-marginal", [&a] { a.marginals = Marginals::left_out; },
                 "only the scene as it is: no further light, texture, samples"),
             flag(
                 "--no-command", [&a] { a.whole_command = WholeCommand::left_out; },
                 "do not measure whole commands: render, to a PNG, in a process of its own"),
             flag(
                 "--no-error", [&a] { a.errors = Errors::left_out; },
                 "do not measure how far images are from the right ones")}},
           {"How often",
            {number_option("--frames", a.frames, Range{1, 1000000},
                           "repetitions at least; each draws a frame of everything"),
             number_option("--seconds", a.seconds, Range{0, 86400},
                           "and more repetitions until so much time has passed, for each scene")}},
           {"Report",
            {file_option("--json", "FILE", a.json, "write the report as JSON; - is standard output"),
             file_option("--html", "FILE", a.html,
                         "write the report as one HTML page with pictures; - is standard output"),
             folder_option("--csv", a.csv, "folder to write a .csv file for each table to; made if need be"),
             memory_option(a.max_memory), strict_option(a.diagnostics), quiet_option(a.diagnostics)}}},
      .notes = {"How it measures: docs/bench.md. The JSON: docs/reports.md."},
      .finish = [arguments]() -> Action {
        fill_defaults(*arguments);
        for (const Size& size : arguments->sizes) check_frame_samples(size.width, size.height, arguments->samples);
        return [arguments] {
          arguments->reading.memory = set_memory_limit(
              arguments->max_memory, *std::max_element(arguments->threads.begin(), arguments->threads.end()));
          return run(*arguments);
        };
      }};
}

} // namespace refraster
