#include "app/view/loaded_scene.h"

#include "app/options/scene_options.h"
#include "io/trace/file_trace.h"
#include "math/vec.h"

#include <algorithm>

namespace refraster {

namespace {

/// Sets `files` to what is looked for while it lives, however it ends.
class FilesOf {
public:
  explicit FilesOf(std::vector<std::string>& files) : files_(files) {}
  ~FilesOf() { files_ = trace_.paths(); }
  FilesOf(const FilesOf&) = delete;
  FilesOf& operator=(const FilesOf&) = delete;

private:
  std::vector<std::string>& files_;
  FileTrace trace_;
};

} // namespace

void load(const PictureRun& run, std::optional<std::size_t> function, LoadedScene& loaded) {
  loaded.run = run, loaded.function = function;
  if (function) loaded.run.changes.values.push_back(fragment_function_edit(fragment_function_names()[*function]));
  {
    const FilesOf reading(loaded.files);
    loaded.source = read_source(loaded.run, PictureFile::image);
  }
  // What draws on a GPU reads these: here they are only named.
  for (const Object& object : loaded.source.scene.objects)
    for (const std::string& shader : {object.vertex_shader_path, object.fragment_shader_path})
      if (!shader.empty()) loaded.files.push_back(shader);
  loaded.ball = ball_around(loaded.source.scene);
}

Scene seen(const LoadedScene& loaded, const std::optional<Camera>& moved, const ViewSettings& settings, Size size) {
  Scene scene = loaded.source.scene;
  SceneView view = loaded.source.view;
  if (moved) scene.camera = *moved, view.fit.reset();
  place(scene, view, size.width, size.height);
  apply(settings, scene);
  return scene;
}

Camera movable(const LoadedScene& loaded, const Camera& placed) {
  Camera camera = placed;
  camera.up = loaded.source.scene.camera.up;
  return can_be_moved(camera) ? camera : placed;
}

void follow(const LoadedScene& loaded, Camera& moved) {
  const std::optional<CameraFit>& fit = loaded.source.view.fit;
  if (!fit) return;
  place_planes(moved, loaded.ball);
  if (fit->near) moved.near = *fit->near;
  if (fit->far) moved.far = *fit->far;
}

bool same_own_camera(const LoadedScene& a, const LoadedScene& b) {
  return same_camera(a.source.scene.camera, b.source.scene.camera) && a.source.view.fit == b.source.view.fit;
}

MotionRates rates_of(const LoadedScene& loaded, Size size) {
  const CameraHandling& handling = loaded.source.view.handling;
  MotionRates rates;
  // Two seconds to the middle of the scene, from where its own camera stands; or, from within it, not much less.
  const double way = length(loaded.source.scene.camera.position - loaded.ball.centre);
  const double speed = std::max(way, loaded.ball.radius / 4) / 2;
  rates.speed = handling.movement_speed.value_or(speed > 0 ? speed : 1);
  rates.look_degrees = handling.mouse_sensitivity.value_or(rates.look_degrees);
  rates.turn_degrees = 360.0 / size.width;
  return rates;
}

} // namespace refraster
