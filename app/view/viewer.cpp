#include "app/view/viewer.h"

#include "app/interrupt.h"
#include "app/options/scene_options.h"
#include "app/options/wrap.h"
#include "app/view/camera_control.h"
#include "app/view/job_thread.h"
#include "app/view/jobs.h"
#include "app/view/keys.h"
#include "app/view/loaded_scene.h"
#include "app/view/pacing.h"
#include "app/view/screen.h"
#include "app/view/watch.h"
#include "app/view/window/window.h"
#include "io/file/text.h"
#include "raster/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace refraster {
namespace {

/// So long after the last change, or the last move of the mouse, the picture counts as still: longer than the mouse is
/// silent while it moves, shorter than one waits.
constexpr double settle_seconds = 0.12;
/// A still picture that takes longer than this is preceded by one as of a moving camera: a tenth of a second is about
/// what is felt as at once.
constexpr double felt_seconds = 0.1;
/// Displays show no more.
constexpr double shortest_frame_seconds = 1.0 / 60;
/// How often results are looked for while there is work: much less than a frame. An event of SDL's that another thread
/// sends would do, but of one that meets a window just closed, X11 makes the end of the program.
constexpr double result_seconds = 0.002, loading_seconds = 0.02;
/// How often files are looked at, and the interrupt.
constexpr double look_seconds = 0.2;
struct Point {
  int x = 0, y = 0;
};

class Viewer {
public:
  Viewer(Window& window, const PictureRun& run, LoadedScene first)
      : window_(window), run_(run), names_(FrameNames::of(run.output).value()),
        loaded_(std::make_shared<LoadedScene>(std::move(first))) {
    camera_.motion = loaded_->source.view.fit ? Motion::orbit : Motion::walk; // which those of models have
    settings_.precision = value_named<Precision>(run_.precision).value();
    watch_.set(loaded_->files);
  }

  ExitCode run() {
    window_.open(title(), loaded_->run.size);
    resize();
    while (!leave_) {
      if (interrupted()) return ExitCode::interrupted;
      take_results();
      look_at_files();
      begin_work();
      screen_.forget(now());
      if (is_long() && now() - shown_ > felt_seconds) screen_.changed = true; // how far it is
      if (screen_.changed) show();
      const int wait = milliseconds_to_wait();
      for (auto event = window_.wait(wait); event; event = window_.wait(0)) handle(*event);
    }
    window_.close(); // at once: what is done in the background may end later
    return ExitCode::ok;
  }

private:
  double now() const { return clock_.seconds(); }

  // ---- What the user does.

  void handle(const WindowEvent& event) {
    using Kind = WindowEvent::Kind;
    switch (event.kind) {
    case Kind::close:
      leave_ = true;
      break;
    case Kind::key_down:
      if (const auto action = action_of_key(event.key)) press(*action, event.key);
      break;
    case Kind::key_up:
      if (camera_.is_pushed()) camera_.step(now()), moved(); // also by a key that was pressed for less than a frame
      if (const auto action = action_of_key(event.key)) camera_.release(*action);
      break;
    case Kind::focus_lost:
      camera_.release_all();
      break;
    case Kind::button_down:
      camera_.press_button(event.x, event.y);
      break;
    case Kind::button_up:
      if (camera_.release_button()) click(event.x, event.y);
      break;
    case Kind::mouse:
      if (camera_.move_mouse(event.x, event.y)) moved();
      break;
    case Kind::wheel:
      if (!screen_.scroll(event.x, event.y, event.notches)) camera_.zoom(event.notches), moved();
      break;
    case Kind::resized:
      screen_.changed = true;
      if (window_.size() != size_) resize();
      break;
    }
  }

  void press(KeyAction action, const std::string& key) {
    switch (action) {
    case KeyAction::forward:
    case KeyAction::back:
    case KeyAction::left:
    case KeyAction::right:
    case KeyAction::up:
    case KeyAction::down:
      camera_.hold(action, now());
      break;
    case KeyAction::change_motion:
      camera_.motion = camera_.motion == Motion::walk ? Motion::orbit : Motion::walk;
      say(camera_.motion == Motion::walk ? "walk: the mouse turns the head" : "orbit: around what the camera looks at");
      break;
    case KeyAction::home:
      camera_.go_home();
      touch();
      break;
    case KeyAction::function:
      next_function();
      break;
    case KeyAction::picture:
      picture_wanted_ = true;
      break;
    case KeyAction::help:
      screen_.switch_help();
      break;
    case KeyAction::close:
      if (!screen_.close_last()) leave_ = true;
      break;
    case KeyAction::quit:
      leave_ = true;
      break;
    default:
      change_settings(action, key);
    }
  }

  void change_settings(KeyAction action, const std::string& key) {
    const ViewSettings before = settings_;
    if (const auto said = change(settings_, action, key, loaded_->source.scene); said && !said->empty()) say(*said);
    if (settings_ != before) touch();
  }

  void next_function() {
    const std::size_t next = tried_function_ ? *tried_function_ + 1 : 0;
    tried_function_ = next < fragment_function_names().size() ? std::optional(next) : std::nullopt;
    wanted_function_ = tried_function_;
    say("fragment function: " + function_text(wanted_function_));
    reload_wanted_ = true;
  }

  static std::string function_text(const std::optional<std::size_t>& function) {
    return function ? fragment_function_names()[*function] : "as the scene says";
  }

  void click(int x, int y) {
    if (screen_.close_at(x, y)) return;
    story_wanted_ = Point{std::clamp(x, 0, size_.width - 1), std::clamp(y, 0, size_.height - 1)};
  }

  void moved() {
    touch();
    last_motion_ = now();
  }

  void resize() {
    size_ = window_.size();
    camera_.set(loaded_, size_);
    touch();
  }

  /// The picture is another from now on.
  void touch() {
    ++revision_;
    if (last_still_seconds_ > felt_seconds) last_motion_ = now();
  }

  // ---- What is done in the background.

  bool is_moving() const { return camera_.is_pushed() || now() - last_motion_ < settle_seconds; }
  bool is_still_shown() const { return still_is_shown_ && shown_revision_ == revision_; }

  void begin_work() {
    if (reload_wanted_ && !loader_.busy()) begin_loading();
    if (frames_.busy()) {
      const bool other = running_revision_ != revision_ || story_wanted_ || picture_wanted_;
      if (running_ == JobResult::Kind::still && other) frames_.cancel();
      return;
    }
    if (story_wanted_) return begin_story();
    if (picture_wanted_) return begin_snapshot();
    if (!is_moving()) {
      if (!is_still_shown()) begin_frame(JobResult::Kind::still);
      return;
    }
    if (now() < next_frame_) return;
    if (camera_.is_pushed()) camera_.step(now()), moved();
    if (shown_revision_ != revision_) begin_frame(JobResult::Kind::moving);
  }

  std::shared_ptr<const Scene> scene() const {
    return std::make_shared<const Scene>(seen(*loaded_, camera_.moved(), settings_, size_));
  }
  PictureRun still_run() const {
    PictureRun run = loaded_->run;
    run.size = size_, run.precision = name_of(settings_.precision);
    return run;
  }

  void begin(JobResult::Kind kind, JobThread<JobResult>::Work work) {
    running_ = kind, running_revision_ = revision_;
    frames_.start(std::move(work));
  }

  void begin_frame(JobResult::Kind kind) {
    FrameJob job{kind,          revision_,      scene(), render_options(still_run(), PictureFile::film),
                 settings_.aov, settings_.edges};
    if (kind == JobResult::Kind::moving) {
      const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * pacing_.scale()))); };
      job.options.width = scaled(size_.width), job.options.height = scaled(size_.height);
      job.options.precision = Precision::float_, job.options.samples = 1;
      next_frame_ = now() + shortest_frame_seconds;
    }
    begin(kind, [this, job](const std::atomic<bool>& cancel) { return frame_jobs_.draw(job, cancel); });
    begun_ = now();
  }

  void begin_story() {
    const Point at = *std::exchange(story_wanted_, std::nullopt);
    screen_.marked = {{at.x, at.y}};
    begin(JobResult::Kind::story,
          [job = StoryJob{revision_, scene(), still_run(), at.x, at.y}](const auto&) { return explain(job); });
  }

  void begin_snapshot() {
    picture_wanted_ = false;
    SnapshotJob job{revision_, scene(), still_run(), unused_files(names_), {}};
    job.run.output = job.files.image;
    if (settings_.aov) job.run.files.aovs = {*settings_.aov};
    job.edits = scene_edits(settings_, loaded_->source.scene);
    say("writing " + job.files.image);
    begin(JobResult::Kind::written, [job](const auto& cancel) { return write_snapshot(job, cancel); });
  }

  void begin_loading() {
    reload_wanted_ = false;
    loader_.start([run = run_, function = wanted_function_](const auto&) {
      Loading loading;
      try {
        load(run, function, loading.scene);
      } catch (const std::exception& error) {
        loading.fault = error.what();
      }
      return loading;
    });
  }

  void take_results() {
    if (auto loading = loader_.take()) take(std::move(*loading));
    if (auto result = frames_.take()) take(std::move(*result));
  }

  struct Loading {
    LoadedScene scene;
    std::string fault;
  };

  void take(Loading loading) {
    std::vector<std::string> files = loading.scene.files;
    if (!loading.fault.empty()) { // what the picture shows may change, too
      files.insert(files.end(), loaded_->files.begin(), loaded_->files.end());
      watch_.set(files);
      wanted_function_ = loaded_->function; // a file that changes next is read as what is shown
      screen_.show_fault("The picture is that of before: reading again has failed.", loading.fault);
      return;
    }
    watch_.set(files);
    screen_.clear_fault();
    if (!same_own_camera(*loaded_, loading.scene)) camera_.go_home();
    loaded_ = std::make_shared<LoadedScene>(std::move(loading.scene));
    camera_.set(loaded_, size_);
    touch();
  }

  void take(JobResult result) {
    if (result.cancelled) return;
    if (!result.fault.empty()) {
      screen_.show_fault("This could not be done:", result.fault);
      if (result.kind == JobResult::Kind::still || result.kind == JobResult::Kind::moving)
        shown_revision_ = result.revision, still_is_shown_ = true; // it would fail again
      return;
    }
    switch (result.kind) {
    case JobResult::Kind::story:
      screen_.show_story(std::move(result.lines), size_.width);
      return;
    case JobResult::Kind::written:
      for (const std::string& line : result.lines) std::cout << line << std::endl; // whoever waits for it sees it
      say(result.note);
      return;
    case JobResult::Kind::moving:
      pacing_.add(result.seconds, showing_seconds_);
      break;
    case JobResult::Kind::still:
      last_still_seconds_ = now() - begun_;
      if (!result.note.empty()) screen_.say("note: " + result.note, now() + 10);
      break;
    }
    if (result.revision != shown_revision_) screen_.marked.reset();
    shown_revision_ = result.revision, still_is_shown_ = result.kind == JobResult::Kind::still;
    picture_ = std::move(result.picture);
    screen_.legend = std::move(result.legend);
    screen_.changed = true;
  }

  void look_at_files() {
    if (now() < next_look_) return;
    next_look_ = now() + look_seconds;
    if (watch_.has_changed(now())) reload_wanted_ = true;
  }

  // ---- What is seen.

  void say(const std::string& text) {
    constexpr double message_seconds = 2.5; // a line is read in less
    screen_.say(text, now() + message_seconds);
  }

  std::string title() const {
    std::string text = run_.scene + " - refraster: " + std::string(name_of(settings_.precision)) + ", " +
                       counted(static_cast<std::size_t>(loaded_->run.samples), "sample");
    if (picture_.empty()) return text;
    if (!still_is_shown_) text += format("; moving: float, %dx%d", picture_.width, picture_.height);
    else if (is_still_shown()) text += format(", %dx%d in %.3g s", size_.width, size_.height, last_still_seconds_);
    if (loaded_->function) text += ", " + function_text(loaded_->function);
    return text + " (H: help)";
  }

  /// Of a still picture that takes long: from when on that is seen.
  bool is_long() const {
    return frames_.busy() && running_ == JobResult::Kind::still && now() - begun_ > 3 * felt_seconds;
  }

  void show() {
    if (const std::string text = title(); text != shown_title_) window_.set_title(shown_title_ = text);
    const Stopwatch watch;
    window_.show(picture_, [&](const Canvas& canvas) {
      screen_.draw(canvas);
      if (is_long()) draw_progress(canvas, frame_jobs_.fraction_done());
    });
    showing_seconds_ = watch.seconds(), shown_ = now();
    screen_.changed = false;
  }

  int milliseconds_to_wait() {
    double until = look_seconds;
    if (loader_.busy()) until = loading_seconds;
    if (frames_.busy()) until = result_seconds;
    else if (is_moving()) {
      const bool next = camera_.is_pushed() || shown_revision_ != revision_;
      until = std::min(until, (next ? next_frame_ : last_motion_ + settle_seconds) - now());
    }
    until = std::min(until, screen_.next_change() - now());
    return std::max(1, static_cast<int>(std::ceil(1e3 * until)));
  }

  Window& window_;
  PictureRun run_;
  FrameNames names_;
  std::shared_ptr<const LoadedScene> loaded_;
  std::optional<std::size_t> wanted_function_,
      tried_function_; // for all objects; the second may not have been for these
  ViewSettings settings_;
  FileWatch watch_;
  Stopwatch clock_;

  CameraControl camera_;
  bool leave_ = false;

  Size size_;
  Screen screen_;
  Image<std::uint8_t> picture_;
  std::string shown_title_;
  std::uint64_t revision_ = 0, shown_revision_ = 0, running_revision_ = 0;
  bool still_is_shown_ = false, reload_wanted_ = false, picture_wanted_ = false;
  std::optional<Point> story_wanted_;
  JobResult::Kind running_ = JobResult::Kind::still;
  Pacing pacing_;
  double last_motion_ = 0, next_frame_ = 0, next_look_ = 0, begun_ = 0, shown_ = 0; // clock_'s seconds
  double showing_seconds_ = 0, last_still_seconds_ = 2 * felt_seconds;

  FrameJobs frame_jobs_;
  JobThread<JobResult> frames_; // ended before what they work on is gone
  JobThread<Loading> loader_;
};

} // namespace

ExitCode view(const PictureRun& run) {
  try {
    Window window; // before a scene is read that nobody could see
    LoadedScene first;
    load(run, std::nullopt, first);
    return Viewer(window, run, std::move(first)).run();
  } catch (const NoWindow& error) {
    std::cerr << "refraster: " << error.what()
              << "; `refraster render` makes an image, `refraster turntable` frames around a scene\n";
    return ExitCode::no_opengl;
  }
}

} // namespace refraster
