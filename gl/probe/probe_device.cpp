#include "gl/probe/probe_device.h"

#include "gl/context/context.h"
#include "gl/probe/detail.h"
#include "gl/probe/functions.h"
#include "gl/probe/habits.h"
#include "gl/probe/output_levels.h"
#include "gl/probe/planes.h"
#include "gl/probe/probe_api.h"
#include "gl/probe/snap_grid.h"
#include "gl/probe/texture_reads.h"
#include "gl/probe/tie_rule.h"

#include <algorithm>

namespace refraster {

DeviceFacts probe_device(const GlApi& gl, const GlDriver& driver) {
  ProbeCanvas canvas(gl);
  DeviceFacts facts;
  facts.driver = driver;
  gl.GetIntegerv(GL_SUBPIXEL_BITS, &facts.subpixel_bits);
  facts.snap_grids = probe_snap_grid(canvas);
  facts.ties = probe_tie_rule(canvas);
  const auto same_size = std::find_if(facts.snap_grids.begin(), facts.snap_grids.end(),
                                      [](const SnapGrid& grid) { return grid.viewport == 1024; });
  facts.planes = probe_planes(canvas, same_size->step);
  facts.functions = probe_functions(canvas);
  facts.habits = probe_habits(canvas);
  facts.texture_reads = probe_texture_reads(canvas);
  facts.detail = probe_detail(canvas);
  facts.output = probe_output(canvas);
  return facts;
}

DeviceFacts probe_device(GlRenderer renderer) {
  const GlContext context(renderer);
  return probe_device(context.gl(), context.driver());
}

} // namespace refraster
