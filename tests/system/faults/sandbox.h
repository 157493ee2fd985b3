#pragma once
// A command of the program in a folder of its own, run again and again, and what it leaves of its outputs.

#include "tests/support/program/program.h"
#include "tests/system/faults/fault_runs.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// Variables of the environment of the processes that are started while it lives.
class Environment {
public:
  explicit Environment(std::vector<std::pair<std::string, std::string>> variables);
  ~Environment();
  Environment(const Environment&) = delete;

private:
  std::vector<std::pair<std::string, std::string>> variables_;
};

/// Outputs are in the folder out/, beside the inputs.
struct WritingCommand {
  std::string name;
  std::vector<std::string> words;
  std::vector<std::string> outputs; // without out/
};

/// Whether the outputs were there before.
enum class Before { old_files, nothing };

class Sandbox {
public:
  /// Runs the command once without a fault: what it writes then is what it should write.
  explicit Sandbox(WritingCommand command);

  const WritingCommand& command() const { return command_; }
  std::string folder() const { return folder_.path; }
  std::string out() const { return folder_ / "out"; }

  void prepare(Before before);
  /// Runs the command with one fault; false if it was never reached, and then nothing is entered into the row.
  bool run_with_fault(const std::string& fault, Before before, FaultRow& row);
  /// Enters what a run left, and what is wrong about it.
  void judge(const Finished& run, Before before, FaultRow& row);
  /// The command as if nothing had happened before; it must not be harmed by what is there.
  void run_again(FaultRow& row);

private:
  void judge_outputs(Before before, const std::string& what, FaultRow& row);
  bool is_whole(const std::string& name, const std::string& text) const;

  WritingCommand command_;
  test::TemporaryFolder folder_;
  std::map<std::string, std::string> right_; // contents of the outputs
};

/// Every command that writes, and every format. `refraster gl` only with OpenGL.
std::vector<WritingCommand> commands_that_write(Effort effort);

} // namespace refraster
