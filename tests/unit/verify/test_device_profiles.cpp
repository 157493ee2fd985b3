// Profiles of devices: what may stand in a file, and what is true of those that the program has.

#include <refraster/notes.h>

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/page_part.h"
#include "verify/device/profile_markdown.h"
#include "verify/device/profile_order.h"
#include "verify/device/read_profile.h"
#include "verify/device/shipped_profiles.h"
#include "verify/device/write_profile.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

using namespace refraster;

namespace {

DeviceProfile parsed(const std::string& text) {
  return parse_device_profile("device.json", text);
}

/// What is wrong with a text, line by line.
std::string fault_in(const std::string& text) {
  try {
    parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

std::vector<DeviceProfile> all_profiles() {
  std::vector<DeviceProfile> all;
  for (const std::string_view name : device_profile_names()) all.push_back(device_profile(std::string(name)));
  return all;
}

/// Every value as text, by place: what two profiles can be compared by.
std::string values_of(const DeviceProfile& profile) {
  DeviceProfile plain = profile;
  plain.sources.clear();
  return device_profile_json(plain);
}

} // namespace

TEST_CASE("a profile that is based on a shipped one says only what differs") {
  const DeviceProfile generic = device_profile("gl-generic");
  const DeviceProfile mine = parsed(R"({
    "name": "mine", "based_on": "gl-generic",
    "raster": {"lattice": 0.00390625, "fill_rule": "bottom-left"},
    "sources": {"raster": {"lattice": "measured"}}
  })");
  CHECK(mine.name == "mine");
  CHECK(mine.version == 1);
  CHECK(mine.raster.lattice == 1.0 / 256);
  CHECK(mine.raster.fill_rule == FillRule::bottom_left);
  DeviceProfile expected = generic;
  expected.name = "mine", expected.version = 1;
  expected.raster.lattice = 1.0 / 256, expected.raster.fill_rule = FillRule::bottom_left;
  CHECK(values_of(mine) == values_of(expected));

  // A number that is no longer the base's has not the base's source either.
  CHECK(mine.sources.at("raster/lattice") == "measured");
  CHECK(mine.sources.count("raster/fill_rule") == 0);
  CHECK(mine.sources.at("raster/snap_steps") == generic.sources.at("raster/snap_steps"));
}

TEST_CASE("without a base every member of a profile is needed") {
  const std::string all = device_profile_json(device_profile("softpipe"));
  CHECK(fault_in(all) == "nothing");
  const std::size_t at = all.find("\"snap_steps\"");
  CHECK(fault_in(all.substr(0, at) + all.substr(all.find('\n', at)))
            .find("/raster/snap_steps: found nothing, expected a number from 0 to 4") != std::string::npos);
  CHECK(fault_in(R"({"name": "empty", "meaning": "nothing"})").find("/raster: found nothing, expected an object") !=
        std::string::npos);
}

TEST_CASE("what a profile of a device cannot say is told with its place, what was found and what is expected") {
  const auto based = [](const std::string& members) {
    return fault_in(R"({"name": "mine", "based_on": "gl-generic", )" + members + "}");
  };
  CHECK(based(R"("raster": {"lattice": -1})") ==
        "device.json:1:66: /raster/lattice: found -1, expected a number from 0 to 1");
  CHECK(based(R"("raster": {"latice": 1})") ==
        "device.json:1:55: /raster/latice: found an unknown key, expected one of lattice, snap_steps, setup_positions, "
        "fill_rule, guard_band; did you mean lattice?");
  CHECK(based(R"("raster": {"fill_rule": "top"})") == "device.json:1:68: /raster/fill_rule: found \"top\", expected "
                                                      "\"top-left\" or \"bottom-left\" or \"bottom-right\" "
                                                      "or \"either\"");
  // Below half a unit in the last place no float is rounded.
  CHECK(based(R"("operations": {"relative": 0})").find("/operations/relative: found 0, expected a number from") !=
        std::string::npos);
  CHECK(based(R"("environment": {"LD_PRELOAD": "x.so"})").find("expected one of GALLIVM_PERF, GALLIUM_OVERRIDE_CPU") !=
        std::string::npos);
  CHECK(based(R"("sources": {"raster": {"latice": "seen"}})").find("/sources/raster/latice: found an unknown key") !=
        std::string::npos);
  CHECK(based(R"("measured": {"vendor": "Mesa"})").find("/measured/renderer: found nothing, expected a string") !=
        std::string::npos);
  CHECK(based(R"("version": 0)") == "device.json:1:55: /version: found 0, expected a whole number from 1 to 99999");
  CHECK(fault_in(R"({"name": "mine", "based_on": "gl-generics"})").find("/based_on: found \"gl-generics\"") !=
        std::string::npos);
  CHECK(fault_in(R"({"based_on": "softpipe"})") == "device.json:1:1: /name: found nothing, expected a string");
  CHECK(fault_in("[]") == "device.json:1:1: found an array of 0 values, expected an object, the profile of a device");
}

TEST_CASE("all faults of a profile are told at once, in the order of the file") {
  CHECK(fault_in(R"({"name": 1, "based_on": "softpipe",
    "output": {"unorm_levels": 0.1}, "depth": {"format": "unorm8"}})") ==
        "device.json:1:10: /name: found 1, expected a string\n"
        "device.json:2:32: /output/unorm_levels: found 0.1, expected a number from 0.5 to 255\n"
        "device.json:2:58: /depth/format: found \"unorm8\", expected \"unorm16\" or \"unorm24\" or \"float32\"");
}

TEST_CASE("a device is named, or is a file") {
  CHECK(device_profile("llvmpipe").renderer == GlRenderer::llvmpipe);
  const test::TemporaryFolder folder;
  const std::string path = folder / "mine.json";
  std::ofstream(path) << R"({"name": "mine", "based_on": "llvmpipe"})";
  CHECK(device_profile(path).name == "mine");
  CHECK_THROWS_WITH_AS(device_profile("llvmpip"),
                       "llvmpip: found neither a file nor a device, expected one of gl-generic, llvmpipe, "
                       "llvmpipe-precise, softpipe, swiftshader; did you mean llvmpipe?; or the profile of a device in "
                       "a JSON file",
                       InputError);
  CHECK_THROWS_AS(device_profile(folder / "none.json"), InputError);
}

TEST_CASE("every shipped profile reads back as it is written") {
  for (DeviceProfile profile : all_profiles()) {
    CAPTURE(profile.name);
    const std::string written = device_profile_json(profile);
    CHECK(device_profile_json(parsed(written)) == written);
    profile.measured = MeasuredDevice{"Mesa", "llvmpipe (LLVM 15.0.6, 256 bits)", "4.5", "4.50", "habits", 1};
    CHECK(parsed(device_profile_json(profile)).measured == profile.measured);
  }
}

TEST_CASE("every member of a shipped profile is in its range, and has a source") {
  for (const DeviceProfile& profile : all_profiles()) {
    CAPTURE(profile.name);
    CHECK_FALSE(profile.meaning.empty());
    for_each_member(
        profile, [&](const std::string& place, const auto& value, const Range& range, Wider, std::string_view meaning) {
          CAPTURE(place);
          CHECK_FALSE(meaning.empty());
          if constexpr (std::is_same_v<decltype(value), const double&>) CHECK(range.contains(value));
          REQUIRE(profile.sources.count(place) == 1);
          CHECK_FALSE(profile.sources.at(place).empty());
        });
  }
}

TEST_CASE("every shipped profile is within gl-generic, member by member") {
  const std::vector<DeviceProfile> all = all_profiles();
  for (const DeviceProfile& profile : all) {
    CAPTURE(profile.name);
    CHECK(members_beyond(profile, all.front()) == std::vector<std::string>{});
  }
  CHECK(members_beyond(device_profile("llvmpipe-precise"), device_profile("llvmpipe")) == std::vector<std::string>{});
}

TEST_CASE("a profile that allows more is beyond the other one, by that member") {
  const DeviceProfile base = device_profile("softpipe");
  const auto beyond = [&](auto&& change) {
    DeviceProfile changed = base;
    change(changed);
    return members_beyond(changed, base);
  };
  using Names = std::vector<std::string>;
  CHECK(beyond([](DeviceProfile& p) { p.raster.lattice *= 2; }) == Names{"raster/lattice"});
  CHECK(beyond([](DeviceProfile& p) { p.raster.lattice /= 2; }) == Names{});
  CHECK(beyond([](DeviceProfile& p) { p.raster.setup_positions = SetupPositions::either; }) ==
        Names{"raster/setup_positions"});
  CHECK(beyond([](DeviceProfile& p) { p.raster.fill_rule = FillRule::top_left; }) == Names{"raster/fill_rule"});
  CHECK(beyond([](DeviceProfile& p) { p.interpolation.anchor = InterpolationAnchor::triangle; }) == Names{});
  CHECK(beyond([](DeviceProfile& p) { p.depth.format = DepthFormat::unorm16; }) == Names{"depth/format"});
  CHECK(beyond([](DeviceProfile& p) { p.operations.log2_units *= 2; }) == Names{"operations/log2_units"});
  // A unit is 2 relative: of twice the size, half as many are the same.
  CHECK(beyond([](DeviceProfile& p) { p.operations.relative *= 2, p.operations.log2_units /= 2; }) ==
        Names{"operations/relative", "operations/exp2_units", "operations/atan2_units"});
  CHECK(beyond([](DeviceProfile& p) { p.operations.cut_off = -100; }) == Names{"operations/cut_off"});
  CHECK(beyond([](DeviceProfile& p) { p.raster.guard_band = 1000; }) == Names{}); // fewer edges are cut
}

TEST_CASE("profiles that a renderer draws say which, and what the environment is then") {
  std::set<std::pair<GlRenderer, std::map<std::string, std::string>>> settings;
  for (const DeviceProfile& profile : all_profiles()) {
    CAPTURE(profile.name);
    const bool is_mesa = profile.name.starts_with("llvmpipe") || profile.name == "softpipe";
    CHECK((profile.renderer != GlRenderer::system_default) == is_mesa);
    if (is_mesa) CHECK(settings.emplace(profile.renderer, profile.environment).second);
  }
  CHECK(device_profile("llvmpipe-precise").environment.at("GALLIVM_PERF").find("no_aos_sampling") != std::string::npos);
}

TEST_CASE("files of shipped profiles are named as the profiles are, and all of them are compiled in") {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(REFRASTER_SOURCE_DIR "/verify/device/profiles"))
    names.insert(entry.path().stem().string());
  CHECK(names.size() == shipped_profiles().size());
  for (const ShippedProfile& shipped : shipped_profiles()) {
    CHECK(names.count(std::string(shipped.name)) == 1);
    CHECK(device_profile(std::string(shipped.name)).name == shipped.name);
  }
}

TEST_CASE("docs/devices.md has the values and sources of the shipped profiles") {
  CHECK(test::page_part("docs/devices.md", "refraster list device-values") == device_profiles_markdown());
}
