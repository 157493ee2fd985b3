#pragma once
// The whole command that a user waits for: processes of the program itself, from their start to their end.

#include "bench/measure/repetitions.h"
#include "bench/measure/results.h"

#include <string>
#include <vector>

namespace refraster::bench {

/// A scene to be rendered to a PNG by processes of their own.
struct CommandTask {
  std::vector<std::string> program; // its path, behind the words of what runs it if the system cannot
  std::vector<std::string> words;   // of the scene: its file, and what is changed of it
  int width = 1280, height = 720, samples = 1;
  std::vector<std::string> precisions;
  std::vector<int> threads;
};

/// Runs each precision with each number of threads in turn, as interleaved() does. Empty if a process fails: `failure`
/// then says how it ended. With `repetitions.stop`, nothing that is worth reading.
std::vector<CommandResult> measure_commands(const CommandTask& task, const Repetitions& repetitions,
                                            std::string& failure);

} // namespace refraster::bench
