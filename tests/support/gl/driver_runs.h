#pragma once
// Scenes through the drivers that verification is tried on, each in a process of its own.

#include "gl/render_gl.h"
#include "tests/support/gl/side_by_side.h"
#include "tests/support/scenes/seeded_scene.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace refraster {

/// A variable of the environment and its value; without a name, none.
struct Setting {
  const char *name = nullptr, *value = "";
};

/// A driver and how it is told to draw.
struct DriverRun {
  std::string_view name;
  std::string_view profile; // what is to be assumed of it: a name of driver_profiles
  GlRenderer renderer;
  std::array<Setting, 2> environment;
};

/// Mesa's documentation of these variables: docs.mesa3d.org/envvars.html. llvmpipe compiles for what the processor has;
/// told that there is no more than SSE4.1 it has neither fused nor 256-bit operations, and other rounding.
inline constexpr DriverRun driver_runs[] = {
    {"llvmpipe", "llvmpipe", GlRenderer::llvmpipe, {{{"GALLIVM_PERF", ""}}}},
    {"llvmpipe-precise",
     "llvmpipe-precise",
     GlRenderer::llvmpipe,
     {{{"GALLIVM_PERF", "no_aos_sampling,no_brilinear,no_rho_approx,no_quad_lod"}}}},
    {"llvmpipe-sse4.1",
     "llvmpipe",
     GlRenderer::llvmpipe,
     {{{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}, {"LP_NATIVE_VECTOR_WIDTH", "128"}}}},
    {"softpipe", "softpipe", GlRenderer::softpipe, {}},
};

/// Null if there is none of that name.
const DriverRun* find_driver_run(std::string_view name);

/// Sets the environment of this process. Mesa reads it when the first scene is drawn, and never again: a process can
/// enter one run only.
void enter(const DriverRun& run);

/// Everything that can be read back. The run must have been entered.
OtherImages drawn(const Scene& scene, int width, int height, const DriverRun& run);

/// Calls visit(seed, scene, images) for each of the seeds [first, end), with a SeededScene and its OtherImages.
template <class Visit>
void draw_seeds(const DriverRun& run, std::uint64_t first, std::uint64_t end, Visit&& visit) {
  enter(run);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    const test::SeededScene made = test::seeded_scene(seed);
    visit(seed, made, drawn(made.scene, made.width, made.height, run));
  }
}

} // namespace refraster
