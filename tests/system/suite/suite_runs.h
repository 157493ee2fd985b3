#pragma once
// A folder of small scenes with references, and runs of `refraster suite` in it.

#include "suite/results/journal.h"
#include "tests/support/program/program.h"

#include <map>
#include <string>
#include <vector>

namespace refraster::test {

/// s0.json, s1.json, …: balls that differ, on the command line of every run, with refs and results beside them.
class SuiteFolder : public TemporaryFolder {
public:
  explicit SuiteFolder(int scenes, const std::string& size = "40x30");

  std::vector<std::string> words(const std::string& command, std::vector<std::string> more = {}) const;
  Finished update(const std::vector<std::string>& more = {}) const;
  Finished run(const std::vector<std::string>& more = {}) const;

  /// Of the last run, by entry: its state.
  std::map<std::string, std::string> states(const std::string& results = "results") const;
  /// Replaces a text of a scene, which must be there once at least.
  void change(const std::string& scene, const std::string& from, const std::string& to) const;

private:
  std::string size_;
};

/// How many entries the last run has not done again: "(3 known from before)" on standard output.
int known_from_before(const Finished& run);

} // namespace refraster::test
