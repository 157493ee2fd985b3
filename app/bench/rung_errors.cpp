#include "app/bench/rung_errors.h"

#include "app/bench/image_error.h"
#include "math/rungs.h"

namespace refraster::bench {
namespace {

Frame image(const SceneTask& task, std::string_view rung, int threads) {
  RenderOptions options;
  options.width = task.width, options.height = task.height;
  options.rung = rung;
  options.threads = threads;
  options.want_radiance_double = true;
  if (rung == DoubleRung::name) options.aovs = {Aov::object, Aov::triangle};
  return render(task.scene, options);
}

} // namespace

std::vector<RungError> rung_errors(const SceneTask& task, int threads) {
  std::vector<RungError> errors;
  if (static_cast<std::uint64_t>(task.width) * static_cast<std::uint64_t>(task.height) > most_compared_pixels)
    return errors;
  const Frame reference = image(task, DoubleRung::name, threads);
  for (const std::string& rung : task.rungs) {
    RungError& error = errors.emplace_back();
    error.rung = rung;
    if (rung == DoubleRung::name) continue;
    error.against_double = image_error(image(task, rung, threads), reference);
  }
  return errors;
}

} // namespace refraster::bench
