#pragma once
// What judge() found, for people and for programs.

#include <refraster/notes.h>

#include "verify/hypotheses/rank.h"
#include "verify/verdict/verdict.h"

#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// How many pixels of a class are too many.
struct ClassLimit {
  PixelClass pixel_class = PixelClass::unexplained;
  std::uint64_t most = 0; ///< pixels that may be
};

/// A verdict and what it is of.
struct VerdictReport {
  std::string scene, actual; ///< as they were given
  DeviceProfile profile;
  JudgeOptions options;
  Transfer transfer = Transfer::linear;
  std::vector<ClassLimit> limits; ///< beside that on unexplained pixels, unless it is among them
  std::vector<std::pair<std::string, std::string>> provenance; ///< label and content: hashes, the driver's words
  Verdict verdict;
  std::optional<hypotheses::Ranking> ranking = {}; ///< of what may be wrong, where that was asked for
  std::vector<std::string> cause_sentences = {};   ///< of the ranking's causes, in their order
  NoteList notes;

  /// The limits that are exceeded; that of unexplained pixels is 0 where none is given.
  std::vector<ClassLimit> exceeded() const;
  bool passes() const { return exceeded().empty(); }
};

/// Fills in the ranking, where pixels are unexplained. `scene` and `image` are those that were judged.
void rank_causes(VerdictReport& report, const Scene& scene, const DeviceImage& image);

/// The first line of verdict_text(), without a full stop.
std::string verdict_headline(const VerdictReport& report);

/// How sharp the check was, in a sentence without a full stop; empty if no pixel shows a surface.
std::string power_text(const JudgePower& power);

/// A few aligned lines; the first one is the verdict. Numbers are rounded for reading.
std::string verdict_text(const VerdictReport& report);

/// Every number in full: docs/reports.md describes it.
std::string verdict_json(const VerdictReport& report);

} // namespace refraster
