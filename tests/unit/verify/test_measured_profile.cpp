// The margins between what probes find and what a profile says, on facts that are made up.

#include "gl/probe/probe_device.h"
#include "verify/device/measured_profile.h"
#include "verify/device/read_profile.h"
#include "verify/device/write_profile.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

constexpr double u = 0x1p-24;

/// A device that rounds to the nearest 1/256 pixel, sets up from exact positions and starts planes at a corner.
DeviceFacts some_facts() {
  DeviceFacts facts;
  facts.driver = {"a vendor", "a renderer", "4.6", "4.60"};
  for (const int viewport : {1024, 4096, 8192}) facts.snap_grids.push_back({viewport, 0x1p-8, 0x1p-9, 0x1p-14});
  facts.ties = {TieRule::top_left, true};
  facts.planes.varyings = {3, 2, 500, 100};
  facts.planes.depth = {4, 2, 400, 90};
  facts.functions = {1, 1, 1.4, 1, 2.3, 2, 3.5, 4, 0.01, 100};
  facts.planes.constant = 1;
  facts.subpixel_bits = 8;
  facts.habits = {true, false, false, -126, true, true};
  facts.texture_reads = {0.01, 0x1p-13, 0.002, 0.001, 0.003, 0.001, 257};
  facts.detail = {0.1, 0.2};
  facts.output = {0.5, 0.6, true};
  return facts;
}

DeviceProfile profile_of(auto&& change) {
  DeviceFacts facts = some_facts();
  change(facts);
  return measured_profile(facts, "made-up");
}

} // namespace

TEST_CASE("numbers that were measured get the margins that their sources state") {
  const DeviceProfile profile = profile_of([](DeviceFacts&) {});
  CHECK(profile.raster.lattice == 0x1p-8);
  CHECK(profile.raster.snap_steps == 0.5);
  CHECK(profile.raster.setup_positions == SetupPositions::exact);
  CHECK(profile.raster.fill_rule == FillRule::top_left);
  CHECK(profile.interpolation.anchor == InterpolationAnchor::triangle);
  CHECK(profile.interpolation.units == 8); // twice the 4 of depth
  const OperationErrors& e = profile.operations;
  CHECK(e.relative == u);
  CHECK(e.quotient_relative == 2 * u); // whole roundings
  CHECK(e.root_relative == 3 * u);
  CHECK(e.absolute == 0x1p-126);
  CHECK(e.cut_off == -126);
  CHECK(e.log2_units == 1); // of 2 / 2^24
  CHECK(e.log2_absolute == 4.5 * u);
  CHECK(e.exp2_units == 2.5);
  CHECK(e.exp2_units_by_exponent == 0); // 20 times that is less than the rounding more
  CHECK(e.atan2_units == 50.5);
  CHECK(profile.texture.filter_error == doctest::Approx(1.02 * 0.001));
  CHECK(profile.texture.place_error == doctest::Approx(1.02 * 0.002));
  CHECK(profile.texture.nearest_error == 0.01 + 0x1p-13);
  CHECK(profile.texture.detail_below == 0.1 + 0x1p-8);
  CHECK(profile.texture.detail_above == 0.2 + 0x1p-8);
  CHECK(profile.output.unorm_levels == 0.5 + 0x1p-8);
  CHECK(profile.output.srgb_levels == 0.6 + 0x1p-8);
}

TEST_CASE("where a probe does not decide, the profile allows both") {
  const auto plain = [](const DeviceFacts&) {};
  CHECK(profile_of(plain).raster.fill_rule == FillRule::top_left);
  CHECK(profile_of([](DeviceFacts& f) { f.ties.shared_edges_drawn_once = false; }).raster.fill_rule ==
        FillRule::either);
  CHECK(profile_of([](DeviceFacts& f) { f.ties.rule = TieRule::top_right; }).raster.fill_rule == FillRule::either);
  const DeviceProfile vague = profile_of([](DeviceFacts& f) { f.planes.varyings = {3, 2, 6, 5}; });
  CHECK(vague.raster.setup_positions == SetupPositions::either);
  CHECK(vague.interpolation.units == 800); // of depth, by the positions that fit worse
  const auto from_snapped = profile_of([](DeviceFacts& f) { f.planes.varyings = {500, 100, 3, 2}; });
  CHECK(from_snapped.raster.setup_positions == SetupPositions::snapped);
  CHECK(profile_of([](DeviceFacts& f) {
          f.planes.varyings = {900, 2, 9000, 300};
        }).interpolation.anchor == InterpolationAnchor::origin);
}

TEST_CASE("the coarsest lattice of all viewports counts, and one that cuts off moves corners by a whole step") {
  const DeviceProfile profile = profile_of([](DeviceFacts& facts) {
    facts.snap_grids = {
        {1024, 0x1p-12, 0x1p-13, 0x1p-14}, {4096, 0x1p-10, 0x1p-11, 0x1p-12}, {8192, 0x1p-8, 0.0038, 0x1p-11}};
  });
  CHECK(profile.raster.lattice == 0x1p-8);
  CHECK(profile.raster.snap_steps == 1);
  const DeviceProfile none = profile_of([](DeviceFacts& facts) {
    for (SnapGrid& grid : facts.snap_grids) grid.step = 0, grid.moved = 0;
  });
  CHECK(none.raster.lattice == 0x1p-9);
  CHECK(none.raster.snap_steps == 0.5);
  CHECK(none.raster.setup_positions == SetupPositions::exact);
}

TEST_CASE("denormals that are kept and powers that grow worse are part of a measured profile") {
  const DeviceProfile profile = profile_of([](DeviceFacts& facts) {
    facts.habits.keeps_denormals = facts.habits.reads_denormals = true;
    facts.habits.min_exp2 = -149;
    facts.functions.exp2_by_exponent = 0.5;
    facts.texture_reads.value_anywhere = facts.texture_reads.value; // which hides what weights do
  });
  CHECK(profile.operations.absolute == 0x1p-150);
  CHECK(profile.operations.cut_off == -149);
  CHECK(profile.operations.exp2_units_by_exponent == 0.25);
  CHECK(profile.texture.place_error == 0);
}

TEST_CASE("a measured profile is valid, reads back, and has what no probe measures from gl-generic") {
  const DeviceProfile profile = profile_of([](DeviceFacts&) {}), generic = device_profile("gl-generic");
  const std::string written = device_profile_json(profile);
  CHECK(device_profile_json(parse_device_profile("measured.json", written)) == written);
  CHECK(profile.measured ==
        MeasuredDevice{"a vendor", "a renderer", "4.6", "4.60", profile.measured->habits, probe_version});
  CHECK(profile.measured->habits ==
        "SUBPIXEL_BITS is 8; a * b + c is rounded once; denormals are read as 0; min and max of NaN and a number give "
        "the "
        "number; whole levels are stored exactly; a varying of 1/3 at all corners is off by 5.96e-08 of it");
  CHECK(is_measured(profile, "raster/lattice"));
  CHECK_FALSE(is_measured(profile, "raster/guard_band"));
  CHECK_FALSE(is_measured(generic, "texture/place_error"));
  CHECK(profile.texture.mip_error == generic.texture.mip_error);
  CHECK(profile.depth.format == generic.depth.format);
}
