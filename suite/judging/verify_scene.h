#pragma once
// A device's image of a scene, from a file or drawn here, and what is to be said of it.

#include "gl/render_gl.h"
#include "io/scene/scene_source.h"
#include "verify/device/read_profile.h"
#include "verify/images/read_device_image.h"
#include "verify/verdict/verdict_report.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// Where the image that is judged is from.
enum class JudgedSource { memory, file, opengl_rgb8, opengl_float };

/// Whether a scene is as its file says, or was made or changed by a program.
enum class SceneOrigin { file, memory };

/// Whether the causes of what is unexplained are looked for, which takes as long as the rest.
enum class CauseSearch { done, left_out };

struct VerifyTask {
  std::string scene, actual; // files, or what a report is to call them; actual: with JudgedSource::file and memory
  SceneOrigin origin = SceneOrigin::file;
  JudgedSource source = JudgedSource::file;
  DeviceImageRequest image;               // of a file, but for its colour, transfer and memory
  DeviceImage given = {};                 // with JudgedSource::memory
  std::string device;                     // a profile; empty: by the driver, or what every device may do
  std::optional<GlRenderer> renderer;     // in place of the profile's
  std::optional<ShaderMatrices> matrices; // in place of what the vertex shader is known to do
  Picture picture;                        // to draw
  std::optional<int> asked_samples;       // those of the picture, where nobody may draw with fewer
  std::optional<Transfer> asked_transfer; // of an image file
  JudgeOptions judging = {};              // but for its samples, matrices, memory
  std::vector<ClassLimit> limits;
  CauseSearch causes = CauseSearch::done;
  MemoryBudget memory;
};

/// Told of what goes on. Each may be empty.
struct VerifySteps {
  std::function<void(const std::string& what)> begin;                 // "judging x.png"
  std::function<void(double fraction)> progress;                      // of what was begun
  std::function<void(const std::string&)> warning;                    // of OpenGL
  std::function<void(int width, int height, int samples)> check_size; // throws for an image that is too large
};

struct VerifiedScene {
  VerdictReport report;
  DeviceImage image;
};

/// Draws or reads the image, and judges it. `source`, the scene of the task, is placed for the image's size. `notes`
/// are those on its files. Throws InputError, NoOpenGl, and what judge() does.
VerifiedScene verify_scene(VerifyTask task, SceneSource& source, NoteList notes, const VerifySteps& steps = {});

/// The page of it. Throws OutOfMemory; `path` names the page there.
std::string verified_html(const VerifiedScene& verified, const Scene& scene, const std::string& path,
                          const MemoryBudget& memory);

} // namespace refraster
