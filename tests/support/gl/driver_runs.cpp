#include "tests/support/gl/driver_runs.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace refraster {

const DriverRun* find_driver_run(std::string_view name) {
  const auto* const found = std::find_if(std::begin(driver_runs), std::end(driver_runs),
                                         [&](const DriverRun& run) { return run.name == name; });
  return found == std::end(driver_runs) ? nullptr : found;
}

void enter(const DriverRun& run) {
  for (const Setting& setting : run.environment)
    if (setting.name) setenv(setting.name, setting.value, 1);
}

OtherImages drawn(const Scene& scene, int width, int height, const DriverRun& run) {
  GlOptions options;
  options.width = width, options.height = height;
  options.renderer = run.renderer;
  options.want_radiance = options.want_depth = options.want_ids = true;
  GlFrame frame = render_gl(scene, options);
  return {frame.driver.renderer + ", OpenGL " + frame.driver.version, std::move(frame.radiance), std::move(frame.ids),
          std::move(frame.rgb8), std::move(frame.depth)};
}

} // namespace refraster
