#pragma once
// What the window has done for it in the background. Each job catches what it meets, as a text.

#include <refraster/render.h>

#include "app/commands/picture_run.h"
#include "app/view/settings.h"
#include "app/view/snapshot.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// What a job left.
struct JobResult {
  enum class Kind { moving, still, story, written };
  Kind kind = Kind::still;
  std::uint64_t revision = 0; // of what the window shows, as it was when the job began
  Image<std::uint8_t> picture;
  StageSeconds seconds;
  std::string legend;             // of an AOV's colours
  std::string note;               // on a picture that shows nothing; what was written
  std::vector<std::string> lines; // a pixel's story, or the command that makes what was written
  std::string fault;              // empty: there is none
  bool cancelled = false;
};

/// A frame to be looked at.
struct FrameJob {
  JobResult::Kind kind = JobResult::Kind::still;
  std::uint64_t revision = 0;
  std::shared_ptr<const Scene> scene;
  RenderOptions options; // without images, which follow from these:
  std::optional<Aov> aov;
  TriangleEdges edges = TriangleEdges::hidden;
};

/// Renders frames one after the other, in the memory of the ones before.
class FrameJobs {
public:
  JobResult draw(const FrameJob& job, const std::atomic<bool>& cancel);
  /// Of the last one begun.
  double fraction_done() const { return fraction_done_.load(std::memory_order_relaxed); }

private:
  Renderer renderer_;
  Frame frame_;
  std::atomic<double> fraction_done_ = 0;
};

/// How a pixel comes about, as `refraster explain` has it.
struct StoryJob {
  std::uint64_t revision = 0;
  std::shared_ptr<const Scene> scene;
  PictureRun run;
  int x = 0, y = 0;
};
JobResult explain(const StoryJob& job);

/// Writes the picture as `refraster render` does, its camera and its script.
struct SnapshotJob {
  std::uint64_t revision = 0;
  std::shared_ptr<const Scene> scene;
  PictureRun run; // output: the image
  SnapshotFiles files;
  std::vector<SceneEdit> edits;
};
JobResult write_snapshot(const SnapshotJob& job, const std::atomic<bool>& cancel);

/// The lines of a text, without the ends of lines.
std::vector<std::string> lines_of(const std::string& text);

} // namespace refraster
