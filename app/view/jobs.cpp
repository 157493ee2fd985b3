#include "app/view/jobs.h"

#include "app/output.h"
#include "app/view/draw/aov_colours.h"
#include "raster/explain/explain_dark.h"
#include "verify/explain/explain_pixel.h"
#include "verify/explain/story_text.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <sstream>

namespace refraster {
namespace {

/// Of what the work leaves in a result, or of why it left nothing.
template <class Work>
JobResult result_of(JobResult::Kind kind, std::uint64_t revision, const Work& work) {
  JobResult result;
  result.kind = kind, result.revision = revision;
  try {
    work(result);
  } catch (const std::exception& error) {
    result.fault = error.what();
  }
  return result;
}

} // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

JobResult FrameJobs::draw(const FrameJob& job, const std::atomic<bool>& cancel) {
  fraction_done_ = 0;
  return result_of(job.kind, job.revision, [&](JobResult& result) {
    RenderOptions options = job.options;
    options.cancel = &cancel;
    options.progress = [this](double fraction) { fraction_done_.store(fraction, std::memory_order_relaxed); };
    options.want_rgb8 = !job.aov;
    if (job.aov || job.edges == TriangleEdges::shown) options.aovs = {Aov::object, Aov::triangle};
    if (job.aov) options.aovs.push_back(*job.aov);
    renderer_.render(*job.scene, options, frame_);
    result.cancelled = frame_.cancelled || cancel;
    if (result.cancelled) return;
    result.seconds = frame_.seconds;
    if (job.aov) {
      AovPicture picture = aov_picture(*job.aov, frame_.aovs[2], frame_.aovs[0]);
      result.picture = std::move(picture.rgb8), result.legend = std::move(picture.legend);
    } else {
      result.picture = frame_.rgb8;
      if (job.kind == JobResult::Kind::still)
        result.note = explain_dark_image(*job.scene, options, {frame_.rgb8, {}}, frame_.counts.shaded);
    }
    if (job.edges == TriangleEdges::shown) draw_edges(result.picture, frame_.aovs[0], frame_.aovs[1]);
  });
}

JobResult explain(const StoryJob& job) {
  return result_of(JobResult::Kind::story, job.revision, [&](JobResult& result) {
    const ExplainRequest request{job.x,
                                 job.y,
                                 job.run.size.width,
                                 job.run.size.height,
                                 job.run.samples,
                                 job.run.transfer,
                                 job.run.reading.memory};
    PixelStory story = explain_pixel(*job.scene, request);
    story.scene = job.run.scene;
    result.lines = lines_of(story_text(story));
  });
}

JobResult write_snapshot(const SnapshotJob& job, const std::atomic<bool>& cancel) {
  return result_of(JobResult::Kind::written, job.revision, [&](JobResult& result) {
    RenderOptions options = render_options(job.run, PictureFile::image);
    options.cancel = &cancel;
    if (const std::string parent = std::filesystem::path(job.files.image).parent_path(); !parent.empty())
      prepare_folder(parent);
    for (const std::string& path : {job.files.image, job.files.camera, job.files.script}) check_writable(path);
    const Frame frame = render(*job.scene, options);
    result.cancelled = frame.cancelled;
    if (frame.cancelled) return;
    const std::string folder = std::filesystem::current_path().string();
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    const Camera& camera = job.scene->camera;
    write_frame(job.run.files, job.files.image, options, frame);
    write_text(job.files.camera, camera_json(camera) + "\n");
    const std::vector<std::string> words = render_words(program, job.run, job.edits, camera);
    write_text(job.files.script, shell_script(words, folder));
    result.lines = {shell_line(words)};
    result.note = "written: " + job.files.image + ", " + job.files.camera + ", " + job.files.script;
  });
}

} // namespace refraster
