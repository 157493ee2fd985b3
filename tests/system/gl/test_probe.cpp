// refraster gl --probe, on drivers whose profiles are shipped.

#include "tests/support/program/program.h"
#include "verify/device/measured_profile.h"
#include "verify/device/profile_order.h"
#include "verify/device/read_profile.h"

#include <doctest/doctest.h>

#include <map>
#include <variant>

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

    std::map<std::string, std::variant<double, SetupPositions, FillRule, InterpolationAnchor, DepthFormat>> says;
    for_each_member(shipped, [&](const std::string& place, const auto& value, const Range&, Wider, std::string_view) {
      says[place] = value;
    });
    int compared = 0;
    for_each_member(measured, [&]<class Value>(const std::string& place, const Value& found, const Range&, Wider,
                                               std::string_view) {
      if (!is_measured(measured, place)) return;
      CAPTURE(place);
      ++compared;
      const auto& said = std::get<Value>(says.at(place));
      if constexpr (!std::is_same_v<Value, double>) {
        CHECK(found == said);
      } else if (place == "operations/cut_off") { // an exponent
        CHECK(found == said);
      } else {
        CHECK(found <= said);
        CHECK(found >= said / 2);
      }
    });
    // All but the guard band, mip levels and the depth buffer's format.
    CHECK(compared == 24);
  }
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
  CHECK(usage({"gl"}).find("SCENE (scene file; docs/scene-format.md), or --probe") != std::string::npos);
}
