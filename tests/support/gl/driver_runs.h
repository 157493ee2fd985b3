#pragma once
// Scenes through the drivers that verification is tried on, each in a process of its own.

#include "gl/render_gl.h"
#include "tests/support/scenes/seeded_scene.h"
#include "verify/device/device_profile.h"

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
  std::string_view name, profile;      // the second one of a shipped profile: renderer, environment, what is assumed
  std::array<Setting, 2> further = {}; // beside the profile's environment
};

/// Mesa's documentation of these variables: docs.mesa3d.org/envvars.html. llvmpipe compiles for what the processor has;
/// told that there is no more than SSE4.1 it has neither fused nor 256-bit operations, and other rounding.
inline constexpr DriverRun driver_runs[] = {
    {"llvmpipe", "llvmpipe"},
    {"llvmpipe-precise", "llvmpipe-precise"},
    {"llvmpipe-sse4.1", "llvmpipe", {{{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}, {"LP_NATIVE_VECTOR_WIDTH", "128"}}}},
    {"softpipe", "softpipe"},
};

/// Null if there is none of that name.
const DriverRun* find_driver_run(std::string_view name);

/// Sets the environment of this process, and gives the profile. Mesa reads the environment when the first scene is
/// drawn, and never again: a process can enter one run only.
DeviceProfile enter(const DriverRun& run);

/// Everything that can be read back, by the renderer of a profile whose run was entered.
GlFrame drawn(const test::SeededScene& made, const DeviceProfile& profile);

/// Calls visit(seed, scene, profile, frame) for each of the seeds [first, end), with a SeededScene and its GlFrame.
template <class Visit>
void draw_seeds(const DriverRun& run, std::uint64_t first, std::uint64_t end, Visit&& visit) {
  const DeviceProfile profile = enter(run);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    const test::SeededScene made = test::seeded_scene(seed);
    visit(seed, made, profile, drawn(made, profile));
  }
}

} // namespace refraster
