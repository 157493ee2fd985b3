// refraster assemble PART… -o OUT

#include "app/command.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/parts/frame_parts.h"
#include "app/parts/image_parts.h"
#include "app/progress_line.h"
#include "app/turntable/film.h"
#include "app/usage_error.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct AssembleArguments {
  std::vector<std::string> parts;
  std::string output;
  int rate = 24, threads = 0;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

void print(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) std::cout << path << "\n";
}

ExitCode join_image(const AssembleArguments& a, const MemoryBudget& memory) {
  const auto line = progress_line(a.diagnostics, "joining " + a.output);
  WholeImage whole = read_parts(a.parts);
  check_whole_output(whole, a.output);
  std::vector<std::string> outputs = aov_paths(whole.files, a.output);
  outputs.push_back(a.output);
  check_different(outputs, a.parts);
  for (const std::string& path : outputs) check_writable(path);
  print(write_whole(std::move(whole), a.output, a.threads, memory));
  return ExitCode::ok;
}

ExitCode join_frames(const AssembleArguments& a) {
  WholeTurn turn = read_turn(a.parts);
  if (!is_film(a.output)) {
    print(collect_frames(std::move(turn), a.output, a.diagnostics));
    return ExitCode::ok;
  }
  if (!film_frames(std::move(turn), a.output, a.rate, a.diagnostics)) return ExitCode::interrupted;
  print({a.output});
  return ExitCode::ok;
}

ExitCode run(const AssembleArguments& a) {
  const MemoryBudget memory = set_memory_limit(a.max_memory, a.threads);
  // One that is not what the others are is said to be none.
  return std::any_of(a.parts.begin(), a.parts.end(), is_image_part) ? join_image(a, memory) : join_frames(a);
}

} // namespace

Command assemble_command() {
  const auto arguments = std::make_shared<AssembleArguments>();
  AssembleArguments& a = *arguments;
  return {
      .name = "assemble",
      .meaning = "Join what shards of render or of turntable have made",
      .groups = {{"Parts",
                  {refraster::arguments("PART", a.parts,
                                        "all parts that `render --shard` has written; or all reports of `turntable "
                                        "--shard`, beside their frames"),
                   file_option("-o,--output", "FILE", a.output,
                               "image to write, with its AOVs beside it; of frames a name with # for their numbers, or "
                               "a film, as out.mp4")
                       .required(),
                   number_option("--rate", a.rate, Range{1, 240}, "frames a second of a film")}},
                 {"Run",
                  {number_option("--threads", a.threads, Range{0, double(limit::threads.value)},
                                 "threads; 0: as many as this machine has"),
                   memory_option(a.max_memory), quiet_option(a.diagnostics)}}},
      .notes =
          {"What is written is, byte for byte, what one run without --shard writes. Where a part is missing, there "
           "twice, or of another scene, size or option, that is said, and nothing is written. docs/scale.md"},
      .finish = [arguments]() -> Action {
        if (arguments->parts.empty()) throw UsageError("assemble", "nothing", "parts");
        return [arguments] { return run(*arguments); };
      }};
}

} // namespace refraster
