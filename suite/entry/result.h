#pragma once
// What came of an entry.

#include "suite/entry/entry.h"
#include "suite/entry/state.h"

#include <string>
#include <vector>

namespace refraster::suite {

/// A file that a result depends on.
struct InputDigest {
  std::string path;
  std::string sha256; ///< empty: it was not there
  bool operator==(const InputDigest&) const = default;
};

/// Whether this run has found it out, or an earlier one of the same inputs.
enum class ResultFrom { run, cache };

/// Where a member of a result is written.
enum class MemberOf {
  report, ///< results.json as well
  journal ///< what a later run goes by, and the page, alone
};

/// All that is known of an entry afterwards. As JSON by its fields: docs/suite.md has them as a table.
struct EntryResult {
  std::string name, scene;
  Action action = Action::compare;
  State state = State::missing;
  std::string message;              // one line
  std::vector<std::string> details; // further lines
  double severity = 0;              // how bad within its state; 0 to 1
  std::string precision, device, driver;
  std::vector<std::string> tags, objects;
  int width = 0, height = 0, samples = 1;
  double max_levels = 0, rms_levels = 0, frame_ms = 0;
  std::uint64_t pixels_over = 0;
  std::string image_sha256;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  std::string page, image, difference; // files in the folder of results
  std::string finished;                // UTC
  std::string settings;                // sha256 of what decides it beside files: entry, program, driver
  std::vector<InputDigest> inputs;     // files that decide it; none: it must be found out anew
  std::string thumbnail, reference_thumbnail, difference_thumbnail; // PNG files as base64
  ResultFrom from = ResultFrom::run;                                // of this run alone: not written

  /// field(name, value, where, meaning) for each member that is written, in order.
  static void fields(auto& self, auto&& field) {
    using enum MemberOf;
    field("name", self.name, report, "of the entry");
    field("scene", self.scene, report, "its file, as the suite names it");
    field("action", self.action, report, "what was done");
    field("state", self.state, report, "what came of it");
    field("message", self.message, report, "the same in a line, with numbers");
    field("details", self.details, report, "further lines");
    field("severity", self.severity, report, "how bad among those of its state, 0 to 1");
    field("precision", self.precision, report, "number type of shading");
    field("device", self.device, report, "profile that was judged by, or renderer; null without one");
    field("driver", self.driver, report, "of OpenGL, in its own words; null without one");
    field("tags", self.tags, report, "of the entry");
    field("objects", self.objects, report, "the scene's objects; of a difference those that show it");
    field("width", self.width, report, "pixels");
    field("height", self.height, report, "pixels");
    field("samples", self.samples, report, "a pixel");
    field("max_levels", self.max_levels, report, "largest difference, in 1/255");
    field("rms_levels", self.rms_levels, report, "root mean square difference, in 1/255");
    field("frame_ms", self.frame_ms, report, "of `bench`: median of a frame");
    field("pixels_over", self.pixels_over, report, "pixels over the limit, or unexplained");
    field("image_sha256", self.image_sha256, report,
          "of the image: of its 8-bit values, or of its floats for a digest");
    field("seconds", self.seconds, report, "that it took");
    field("peak_bytes", self.peak_bytes, report, "most memory of its process up to its end");
    field("page", self.page, report, "to look at it pixel by pixel: a file beside this one; null without one");
    field("image", self.image, report, "the image, where it was written: a file beside this one");
    field("difference", self.difference, report, "heat image of the differences: a file beside this one");
    field("finished", self.finished, report, "when, UTC");
    field("settings", self.settings, report, "sha256 of entry, program and driver");
    field("inputs", self.inputs, report, "files that it depends on, with their sha256; null: not there");
    field("thumbnail", self.thumbnail, journal, "PNG, base64");
    field("reference_thumbnail", self.reference_thumbnail, journal, "PNG, base64");
    field("difference_thumbnail", self.difference_thumbnail, journal, "PNG, base64");
  }

  Outcome outcome() const { return facts_of(state).outcome; }
  bool passes() const { return outcome() == Outcome::passed; }
};

/// Whether a needs a look before b: by state, then by severity, then by name.
bool is_worse(const EntryResult& a, const EntryResult& b);

/// The exit code of a run with these results. A disk that cannot be written to goes before inputs that cannot be read,
/// these before differences, and these before what could not be tried.
int exit_code_of(const std::vector<EntryResult>& results);

} // namespace refraster::suite
