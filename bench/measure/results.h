#pragma once
// What a run of `refraster bench` finds out. docs/reports.md says what each figure means.

#include <refraster/render.h>

#include "bench/machine/machine.h"
#include "bench/measure/scaling.h"
#include "bench/measure/statistics.h"
#include "bench/workloads/variants.h"

#include <optional>
#include <string>
#include <vector>

namespace refraster::bench {

/// Where the wall time of a frame goes. The parts add up to the frame.
struct Split {
  double transform = 0, bin = 0;                               // geometry
  double visibility = 0;                                       // coverage and depth
  double attribute_setup = 0, interpolation = 0, lighting = 0; // of what is visible; lighting: fragment functions
  double resolve = 0, other = 0;
};
/// The members of Split with their names, in order.
inline constexpr std::pair<const char*, double Split::*> split_parts[] = {
    {"transform", &Split::transform},
    {"bin", &Split::bin},
    {"visibility", &Split::visibility},
    {"attribute_setup", &Split::attribute_setup},
    {"interpolation", &Split::interpolation},
    {"fragment_functions", &Split::lighting},
    {"resolve", &Split::resolve},
    {"other", &Split::other},
};

/// A fragment function of the scene, on those objects alone that it shades.
struct FunctionCost {
  FragmentFunctionVariant function;
  std::uint64_t fragments = 0;
  Spread ns; // of one thread, a fragment and light
};

enum class TextureChange { removed, added };

/// What a change adds to a frame, in ns of CPU time a shaded pixel. Nothing where the scene lets it not be changed.
struct Marginal {
  Spread light;
  std::optional<Spread> texture;
  TextureChange texture_change = TextureChange::added;
  std::optional<Spread> double_samples;
};

/// How far apart two images are, over the pixels that show a surface. Of each pixel the worst channel counts.
struct ImageError {
  std::uint64_t pixels = 0;
  struct Figures {
    double max = 0, mean = 0, p99_9 = 0; // p99_9: 999 of 1000 pixels keep to it
  };
  Figures levels;   // of values clamped to [0, 1], times 255, not rounded
  Figures relative; // |a - b| / |b|, each the greatest of the channels; without pixels that are black in b
  std::uint64_t off_by_one = 0, off_by_more = 0; // of 255, in the 8-bit images
};

/// How far chosen pixels are from the precision `exact`: the same formulas in 60 digits, from what the vertex stage
/// stores.
struct ExactError {
  std::size_t pixels = 0; // none where no surface is seen: then the others say nothing
  double max_relative = 0, mean_relative = 0, max_levels = 0;
};

struct PrecisionError {
  std::string precision;
  std::optional<ImageError> against_double; // nothing for double itself
  ExactError against_exact;
};

/// One precision with one number of threads.
struct PrecisionResult {
  std::string precision;
  int threads = 1;
  Spread frame_ms, cpu_ms;
  Split split_ns;                      // a shaded pixel
  Spread lighting_ns;                  // the differences, repetition by repetition, whose mean split_ns.lighting is
  std::vector<FunctionCost> functions; // with the first number of threads only, as is `marginal`
  std::optional<Marginal> marginal;
  std::optional<Spread> opengl_ratio; // OpenGL's wall time over ours, repetition by repetition
};

struct OpenGlResult {
  int threads = 1;
  std::string renderer, version; // in the driver's words
  Spread frame_ms, cpu_ms;
};

/// The whole command, `refraster render` from its start to its end, in milliseconds.
struct CommandResult {
  std::string precision;
  int threads = 1;
  std::size_t repetitions = 0;
  Spread whole_ms, cpu_ms;
  Spread start_ms; // the whole less what follows: the process's start and end
  Spread read_ms, frame_ms, write_ms;
};
/// The parts of CommandResult with their names, in order.
inline constexpr std::pair<const char*, Spread CommandResult::*> command_parts[] = {
    {"whole", &CommandResult::whole_ms}, {"start", &CommandResult::start_ms}, {"read", &CommandResult::read_ms},
    {"frame", &CommandResult::frame_ms}, {"write", &CommandResult::write_ms}, {"cpu", &CommandResult::cpu_ms},
};

struct SceneResult {
  std::string scene;
  int width = 0, height = 0, samples = 1;
  std::size_t lights = 0, repetitions = 0;
  FrameCounts counts;
  std::vector<PrecisionResult> precisions;
  std::vector<PrecisionError> errors;
  std::vector<OpenGlResult> opengl;
  std::vector<CommandResult> commands; // none where there is no file to name

  double shaded() const { return static_cast<double>(counts.shaded); }
};

/// All of it.
struct Run {
  std::string command, started, ended;
  Machine machine;
  std::array<double, 3> load_at_start{}, load_at_end{};
  int warm_up = 0, min_repetitions = 0;
  double seconds = 0;
  std::vector<std::string> notes; // what a reader must know: threads without a CPU of their own, no OpenGL
  std::vector<SceneResult> scenes;
  std::vector<ScalingCurve> scaling;
};

} // namespace refraster::bench
