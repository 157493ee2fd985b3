#pragma once
// How far two reflectances are apart.

#include "brdf/brdf.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Pairs of directions that fail in their own ways. A pair may be in several.
enum class BrdfRegion { all, highlight, retro, grazing, rest };

/// The limits of the regions, degrees.
inline constexpr double highlight_theta_h = 10, retro_theta_d = 10, grazing_theta = 75;

struct RegionWords {
  BrdfRegion region;
  std::string_view name, meaning;
};
inline constexpr RegionWords brdf_regions[] = {
    {BrdfRegion::all, "all", "every pair above the surface"},
    {BrdfRegion::highlight, "highlight", "half vector within 10 degrees of the normal"},
    {BrdfRegion::retro, "retro", "light and eye within 20 degrees of each other: theta_d below 10"},
    {BrdfRegion::grazing, "grazing", "light or eye more than 75 degrees from the normal"},
    {BrdfRegion::rest, "rest", "none of these"}};

/// Root mean squares over pairs of directions, by solid angle of both, and over red, green and blue. c is the cosine of
/// the light's angle, f in 1/sr.
struct BrdfErrors {
  std::uint64_t pairs = 0;    // bins of a table that both know
  double fraction = 0;        // of all pairs of directions, by solid angle
  double rms = 0;             // of b - a
  double relative_rms = 0;    // that, by the root mean square of a
  double cosine_rms = 0;      // of c (b - a): Ngan, Durand, Matusik 2005, section 3
  double log_rms = 0;         // of ln(1 + c b) - ln(1 + c a): Löw, Kronander, Ynnerman, Unger 2012, section 5
  double cube_root_rms = 0;   // of (c b)^(1/3) - (c a)^(1/3): Fores, Ferwerda, Gu 2012
  double mean_difference = 0; // of c (b - a): whether b is brighter
};

/// A pair where the two are far apart.
struct WorstPair {
  HalfDifferenceAngles half_difference;
  InOutAngles in_out;
  Rgb<double> a{0}, b{0};
  double log_error = 0; // |ln(1 + c b) - ln(1 + c a)|, of the worst channel
};

struct BrdfComparison {
  std::array<BrdfErrors, std::size(brdf_regions)> regions; // in the order of brdf_regions
  std::uint64_t unknown = 0;                               // bins above the surface that one of the two has not
  bool equal = true;                                       // every value
  std::vector<WorstPair> worst; // at most ten, one of each 10 x 10 degrees of theta_h and theta_d, the worst first

  const BrdfErrors& of(BrdfRegion region) const { return regions[static_cast<std::size_t>(region)]; }
};

/// Compares at the centres of all bins of a MERL table, each weighted by the pairs of directions that it stands for
/// (grid.h). A second or two; the same bits for any number of threads.
BrdfComparison compare_brdfs(const Brdf& a, const Brdf& b);

/// What may differ: of all pairs.
struct BrdfLimits {
  std::optional<double> max_rms, max_cosine_rms, max_log_rms, max_cube_root_rms;
};

/// Within all limits; without any, equal.
bool is_within(const BrdfLimits& limits, const BrdfComparison& found);

struct BrdfComparisonReport {
  const Brdf &a, &b;
  BrdfLimits limits;
  BrdfComparison found;
};

/// For people.
std::string comparison_text(const BrdfComparisonReport& report);
/// docs/reports.md.
std::string comparison_json(const BrdfComparisonReport& report);

} // namespace refraster
