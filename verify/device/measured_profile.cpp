#include "verify/device/measured_profile.h"

#include "gl/probe/probe_device.h"
#include "verify/device/read_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace refraster {
namespace {

constexpr double u = 0x1p-24;

std::string text(const char* format, auto... values) {
  std::array<char, 512> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

/// Sets members of a profile, each with its source.
class Measured {
public:
  explicit Measured(DeviceProfile& profile) : profile_(profile) {}

  template <class Value>
  void operator()(const char* place, Value& member, const Value& value, std::string source) {
    member = value;
    profile_.sources[place] = std::move(source);
  }

private:
  DeviceProfile& profile_;
};

void add_raster(const DeviceFacts& facts, DeviceProfile& profile, Measured& set) {
  double step = 0, moved = 0, resolution = 0; // of the coarsest lattice; moved and resolution in its steps
  for (const SnapGrid& grid : facts.snap_grids) step = std::max(step, grid.step);
  for (const SnapGrid& grid : facts.snap_grids)
    if (grid.step > 0)
      moved = std::max(moved, grid.moved / grid.step), resolution = std::max(resolution, grid.resolution / grid.step);
  RasterProfile& raster = profile.raster;
  if (step > 0) {
    set("raster/lattice", raster.lattice, step,
        text("P1: 1/%g pixel, the coarsest of three sizes of viewport", 1 / step));
    const double half_steps = moved <= 0.5 + resolution ? 1 : std::ceil(2 * (moved - resolution));
    set("raster/snap_steps", raster.snap_steps, half_steps / 2,
        text("P1: %.3g, up to whole halves: a lattice rounds to the nearest, or cuts off", moved));
  } else {
    double seen = 0x1p-10; // 8 / 2^24 of 2048
    for (const SnapGrid& grid : facts.snap_grids) seen = std::max(seen, grid.moved + grid.resolution);
    set("raster/lattice", raster.lattice, 2 * seen,
        "P1 saw no lattice: edges in float, where 8 / 2^24 of 2048 pixels are half of 1/512 pixel");
    set("raster/snap_steps", raster.snap_steps, 0.5, "P1: see lattice");
  }
  const FillRule rule = facts.ties.rule == TieRule::top_left       ? FillRule::top_left
                        : facts.ties.rule == TieRule::bottom_left  ? FillRule::bottom_left
                        : facts.ties.rule == TieRule::bottom_right ? FillRule::bottom_right
                                                                   : FillRule::either;
  set("raster/fill_rule", raster.fill_rule, facts.ties.shared_edges_drawn_once ? rule : FillRule::either,
      "P2: eight directions, both windings");
}

void add_interpolation(const DeviceFacts& facts, DeviceProfile& profile, Measured& set) {
  const PlaneErrors &f = facts.planes.varyings, &z = facts.planes.depth;
  // By the other positions a plane is off by far more than roundings, where there is a lattice to tell them by.
  constexpr double clearly = 4;
  const bool has_lattice =
      std::any_of(facts.snap_grids.begin(), facts.snap_grids.end(), [](const SnapGrid& grid) { return grid.step > 0; });
  const SetupPositions positions = !has_lattice || clearly * f.exact_from_origin < f.snapped_from_origin
                                       ? SetupPositions::exact
                                   : clearly * f.snapped_from_origin < f.exact_from_origin ? SetupPositions::snapped
                                                                                           : SetupPositions::either;
  set("raster/setup_positions", profile.raster.setup_positions, positions,
      text("P4: planes through exact corners are off by %.3g / 2^24, through snapped ones by %.3g / 2^24",
           f.exact_from_origin, f.snapped_from_origin));
  const auto error = [positions](const PlaneErrors& e, double PlaneErrors::*exact, double PlaneErrors::*snapped) {
    return positions == SetupPositions::exact     ? e.*exact
           : positions == SetupPositions::snapped ? e.*snapped
                                                  : std::max(e.*exact, e.*snapped);
  };
  const double from_corner = error(f, &PlaneErrors::exact_from_corner, &PlaneErrors::snapped_from_corner),
               from_origin = error(f, &PlaneErrors::exact_from_origin, &PlaneErrors::snapped_from_origin);
  const bool at_corner = from_corner < clearly * std::max(from_origin, 1.0);
  const double of_depth = at_corner ? error(z, &PlaneErrors::exact_from_corner, &PlaneErrors::snapped_from_corner)
                                    : error(z, &PlaneErrors::exact_from_origin, &PlaneErrors::snapped_from_origin);
  set("interpolation/anchor", profile.interpolation.anchor,
      at_corner ? InterpolationAnchor::triangle : InterpolationAnchor::origin,
      text("P4: errors are %.3g / 2^24 of the sums from a corner, %.3g / 2^24 of those from the origin", from_corner,
           from_origin));
  const double most = std::max(at_corner ? from_corner : from_origin, of_depth);
  set("interpolation/units", profile.interpolation.units, std::ceil(2 * most),
      text("P4, P5: %.3g of %.0f pixels, twice that, rounded up: roundings seldom all go one way, and corners of any w "
           "divide once more",
           most, facts.planes.samples));
  set("interpolation/relative", profile.interpolation.relative, 0.0, "P4: all errors are within the sums");
}

/// Roundings of an operation that makes whole ones: 1.48 / 2^24 are two.
double whole_roundings(double error) {
  return std::max(std::ceil(error), 1.0);
}

void add_operations(const DeviceFacts& facts, DeviceProfile& profile, Measured& set) {
  const FunctionErrors& e = facts.functions;
  const HabitFacts& habits = facts.habits;
  OperationErrors& operations = profile.operations;
  const auto rounded = [&](const char* place, double& member, double error) {
    set(place, member, whole_roundings(error) * u,
        text("P6: %.3g / 2^24, up to whole roundings: such an operation makes one, or a few", error));
  };
  rounded("operations/relative", operations.relative, std::max(e.sum, e.product));
  rounded("operations/quotient_relative", operations.quotient_relative, e.quotient);
  rounded("operations/root_relative", operations.root_relative, std::max(e.root, e.inverse_root));
  const bool keeps = habits.keeps_denormals && habits.reads_denormals;
  set("operations/absolute", operations.absolute, keeps ? 0x1p-150 : 0x1p-126,
      keeps ? "P7: denormals are kept" : "P7: denormals are flushed");
  set("operations/cut_off", operations.cut_off, std::max(habits.min_exp2, -149.0),
      text("P7: exp2(%g) is not 0", habits.min_exp2));

  // Of 2^23 mantissas a binade 2^16 are tried, which leaves out some of the roundings of an approximation.
  constexpr double one_rounding = 1;
  const double unit = 2 * operations.relative / u; // in 2^-24
  const char* const why = "one rounding more, since not all mantissas are tried";
  set("operations/log2_units", operations.log2_units, e.log2_relative / unit,
      text("P6: %.3g / 2^24 of the result, beside log2_absolute", e.log2_relative));
  set("operations/log2_absolute", operations.log2_absolute, (e.log2_absolute + one_rounding) * u,
      text("P6: %.3g / 2^24, and %s", e.log2_absolute, why));
  set("operations/exp2_units", operations.exp2_units, (e.exp2_relative + one_rounding) / unit,
      text("P6: %.3g / 2^24, and %s", e.exp2_relative, why));
  // What the rounding more holds up to 20, as far as the probe goes, is no growth.
  const double growth = 20 * e.exp2_by_exponent < one_rounding ? 0 : e.exp2_by_exponent;
  set("operations/exp2_units_by_exponent", operations.exp2_units_by_exponent, growth / unit,
      text("P6: %.3g / 2^24 for each 1 up to 20", e.exp2_by_exponent));
  set("operations/atan2_units", operations.atan2_units, (e.atan2_relative + one_rounding) / unit,
      text("P6: %.4g / 2^24, and %s", e.atan2_relative, why));
}

void add_texture(const DeviceFacts& facts, DeviceProfile& profile, Measured& set) {
  const TextureFacts& reads = facts.texture_reads;
  TextureProfile& texture = profile.texture;
  constexpr double reads_margin = 1.02;        // 2^18 reads of random texels come that near to the worst
  constexpr double detail_resolution = 0x1p-8; // of a weight that is read from texels of 8 bits, as most are
  // What is wrong with places shows in proportion to how texels differ; where it is lost in the filter's own rounding,
  // it is counted with that.
  const bool is_one = reads.value_anywhere <= 1.2 * reads.value || reads.value_anywhere < 0x1p-20; // floats
  const double between = std::max(reads.value_between_levels - reads.value, 0.0);
  const double value = (is_one ? reads.value_anywhere : reads.value) + between;
  set("texture/place_error", texture.place_error, is_one ? 0.0 : reads_margin * reads.weight_place,
      is_one ? std::string("P8: what weights do is within filter_error")
             : text("P8: %.3g texel, %d values of a ramp; and 1/50 more, as many reads were tried", reads.weight_place,
                    reads.weights));
  set("texture/filter_error", texture.filter_error, reads_margin * value,
      text("P8: %.3g / 255, of it %.3g / 255 between levels; and 1/50 more, as many reads were tried", 255 * value,
           255 * between));
  set("texture/nearest_error", texture.nearest_error, reads.nearest_place + reads.nearest_resolution,
      text("P8: %.3g texel, and %.3g between the places that were tried", reads.nearest_place,
           reads.nearest_resolution));
  const auto detail = [&](const char* place, double& member, double seen) {
    set(place, member, seen + detail_resolution,
        text("P9: %.3g, and 1/256 for what 8 bits of a read and the steps of the probe hide", seen));
  };
  detail("texture/detail_below", texture.detail_below, facts.detail.below);
  detail("texture/detail_above", texture.detail_above, facts.detail.above);
}

void add_output(const DeviceFacts& facts, DeviceProfile& profile, Measured& set) {
  const auto levels = [&](const char* place, double& member, double seen) {
    set(place, member, std::max(seen, 0.5) + 0x1p-8,
        text("P10: %.4g, and 1/256 between the values that were tried", seen));
  };
  levels("output/unorm_levels", profile.output.unorm_levels, facts.output.unorm);
  levels("output/srgb_levels", profile.output.srgb_levels, facts.output.srgb);
}

/// What no member of a profile says.
std::string habits_of(const DeviceFacts& facts) {
  const HabitFacts& habits = facts.habits;
  const auto either = [](bool holds, const char* yes, const char* no) { return std::string(holds ? yes : no); };
  return text("SUBPIXEL_BITS is %d; ", facts.subpixel_bits) +
         either(habits.fuses, "a * b + c is rounded once; ", "a * b + c is rounded twice; ") +
         either(habits.reads_denormals, "denormals are read; ", "denormals are read as 0; ") +
         either(habits.min_of_nan_is_number && habits.max_of_nan_is_number,
                "min and max of NaN and a number give the number; ", "min and max of NaN and a number may be NaN; ") +
         either(facts.output.whole_levels_are_exact, "whole levels are stored exactly; ",
                "whole levels are not all stored exactly; ") +
         text("a varying of 1/3 at all corners is off by %.3g of it", facts.planes.constant * u);
}

} // namespace

bool is_measured(const DeviceProfile& profile, const std::string& place) {
  const auto source = profile.sources.find(place);
  return source != profile.sources.end() && source->second.size() > 2 && source->second[0] == 'P' &&
         source->second[1] >= '0' && source->second[1] <= '9';
}

DeviceProfile measured_profile(const DeviceFacts& facts, const std::string& name) {
  DeviceProfile profile = device_profile("gl-generic");
  profile.name = name, profile.version = 1;
  profile.meaning = "Measured by refraster gl --probe on " + facts.driver.renderer + ", " + facts.driver.version + ".";
  profile.measured = MeasuredDevice{facts.driver.vendor,       facts.driver.renderer, facts.driver.version,
                                    facts.driver.glsl_version, habits_of(facts),      probe_version};
  Measured set(profile);
  add_raster(facts, profile, set);
  add_interpolation(facts, profile, set);
  add_operations(facts, profile, set);
  add_texture(facts, profile, set);
  add_output(facts, profile, set);
  return profile;
}

} // namespace refraster
