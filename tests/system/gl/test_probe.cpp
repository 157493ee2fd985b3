// refraster gl --probe, on drivers whose profiles are shipped.

#include "tests/support/gl/profile_relation.h"
#include "tests/support/program/program.h"
#include "verify/device/read_profile.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

/// What the probes make of the driver of a shipped profile, in a process of its own: Mesa reads its settings once.
DeviceProfile probed(const std::string& name) {
  const TemporaryFolder folder;
  const Finished run = run_program(folder.path, {"gl", "--probe", "--device", name, "-o", "probed.json"});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("| `operations/exp2_units` |") != std::string::npos);
  return read_device_profile(folder / "probed.json");
}

} // namespace

TEST_CASE("probes find what the shipped profiles say: no more of any member, and at least half of it") {
  for (const char* const name : {"llvmpipe", "llvmpipe-precise", "softpipe"}) {
    CAPTURE(std::string(name));
    const DeviceProfile shipped = device_profile(name), measured = probed(name);
    REQUIRE(measured.measured);
    CHECK(measured.measured->renderer.find(name_of(shipped.renderer)) != std::string::npos);
    CHECK(measured.measured->probe_version >= 1);
    CHECK(measured.name == "probed");
    CHECK(relation_faults(measured, shipped) == std::vector<std::string>{});
  }
}

TEST_CASE("a profile that is wider than twice what is measured, or tighter, is told by the relation") {
  const DeviceProfile measured = probed("softpipe");
  DeviceProfile other = device_profile("softpipe");
  other.operations.exp2_units *= 3;
  other.texture.detail_below = 0.5;
  other.raster.fill_rule = FillRule::either;
  CHECK(relation_faults(measured, other) ==
        std::vector<std::string>{"raster/fill_rule is another",
                                 "operations/exp2_units is less than half of what the profile says",
                                 "texture/detail_below is more than the profile says"});
}

TEST_CASE("llvmpipe's paths for older processors are within its profile, and its shortcuts are not") {
  const TemporaryFolder folder;
  save_text(folder / "sse41.json",
            R"({"name": "sse41", "based_on": "llvmpipe", "environment": {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1"}})");
  save_text(
      folder / "shortcuts.json",
      R"({"name": "shortcuts", "based_on": "llvmpipe", "environment": {"GALLIVM_PERF": "brilinear,rho_approx"}})");
  const Finished sse41 = run_program(folder.path, {"gl", "--probe", "--device", "sse41.json", "-o", "probed.json"});
  CHECK(sse41.exit_code == 0);
  CHECK(read_device_profile(folder / "probed.json").measured->renderer.find("128 bits") != std::string::npos);
  const Finished shortcuts = run_program(folder.path, {"gl", "--probe", "--device", "shortcuts.json"});
  CHECK(shortcuts.exit_code == 1);
  CHECK(shortcuts.err == "refraster: texture/detail_below was measured to be more than shortcuts.json allows\n"
                         "refraster: texture/detail_above was measured to be more than shortcuts.json allows\n");
}

TEST_CASE("a device that does more than a profile allows is told by the members, with exit code 1") {
  const TemporaryFolder folder;
  save_text(folder / "tight.json", R"({"name": "tight", "based_on": "llvmpipe",
    "raster": {"fill_rule": "top-left"}, "operations": {"atan2_units": 2}, "texture": {"mip_error": 0}})");
  const Finished run = run_program(folder.path, {"gl", "--probe", "--device", "tight.json"});
  CHECK(run.exit_code == 1);
  CHECK(run.err == "refraster: raster/fill_rule was measured to be more than tight.json allows\n"
                   "refraster: operations/atan2_units was measured to be more than tight.json allows\n");
  CHECK(run.out.find("| `raster/fill_rule` | top-left | bottom-left |") != std::string::npos);
  CHECK(files_in(folder) == std::vector<std::string>{"tight.json"});
}

TEST_CASE("--probe needs no scene, and takes none; without a file the profile goes to standard output") {
  const TemporaryFolder folder;
  const Finished plain = run_program(folder.path, {"gl", "--probe", "--renderer", "llvmpipe"});
  CHECK(plain.exit_code == 0);
  CHECK(parse_device_profile("standard output", plain.out).name == "measured");

  const auto usage = [&](const std::vector<std::string>& words) {
    const Finished run = run_program(folder.path, words);
    CHECK(run.exit_code == 2);
    return run.err;
  };
  CHECK(usage({"gl", "--probe", "scene.json"}).find("SCENE beside --probe") != std::string::npos);
  CHECK(usage({"gl", "--probe", "--depth", "d.pfm"}).find("--depth beside --probe") != std::string::npos);
  CHECK(usage({"gl", "--device", "llvmpipe", "scene.json"}).find("--device without --probe") != std::string::npos);
  CHECK(usage({"gl"}).find("SCENE (scene file or OBJ model; docs/scene-format.md), or --probe") != std::string::npos);
}
