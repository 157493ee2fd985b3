#include "brdf/comparison.h"

#include "brdf/grid.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr std::size_t region_count = std::size(brdf_regions);
constexpr int cell_degrees = 10, cells = 90 / cell_degrees;

struct Sums {
  std::uint64_t pairs = 0;
  double weight = 0, squares_of_a = 0, squares = 0, cosine_squares = 0, log_squares = 0, cube_root_squares = 0,
         differences = 0;

  void add(const Sums& other) {
    pairs += other.pairs;
    weight += other.weight, squares_of_a += other.squares_of_a, squares += other.squares;
    cosine_squares += other.cosine_squares, log_squares += other.log_squares;
    cube_root_squares += other.cube_root_squares, differences += other.differences;
  }
};

/// What one theta_h adds: rows are worked out by any thread, and added up in their order.
struct Row {
  std::array<Sums, region_count> regions{};
  std::uint64_t unknown = 0;
  bool equal = true;
  std::array<WorstPair, cells> worst{}; // by theta_d
};

double squared(double x) {
  return x * x;
}

/// The mean of a function of the channels.
template <class Function>
double channel_mean(const Function& function) {
  return (function(0) + function(1) + function(2)) / 3;
}

std::array<bool, region_count> regions_of(const HalfDifferenceAngles& angles, const DirectionPair& pair) {
  static const double grazing_cosine = std::cos(grazing_theta * std::numbers::pi / 180);
  const bool highlight = angles.theta_h < highlight_theta_h, retro = angles.theta_d < retro_theta_d;
  const bool grazing = std::min(pair.i.z, pair.o.z) < grazing_cosine;
  return {true, highlight, retro, grazing, !highlight && !retro && !grazing};
}

double log_error(double a, double b, double cosine) {
  return std::log1p(cosine * b) - std::log1p(cosine * a);
}

void add(Row& row, const HalfDifferenceAngles& angles, const DirectionPair& pair, double weight, const Rgb<double>& a,
         const Rgb<double>& b) {
  const double c = pair.i.z;
  Sums one{.pairs = 1, .weight = weight};
  one.squares_of_a = weight * channel_mean([&](int k) { return squared(a[k]); });
  one.squares = weight * channel_mean([&](int k) { return squared(b[k] - a[k]); });
  one.cosine_squares = c * c * one.squares;
  one.log_squares = weight * channel_mean([&](int k) { return squared(log_error(a[k], b[k], c)); });
  one.cube_root_squares =
      weight * channel_mean([&](int k) { return squared(std::cbrt(c * b[k]) - std::cbrt(c * a[k])); });
  one.differences = weight * c * channel_mean([&](int k) { return b[k] - a[k]; });
  const std::array<bool, region_count> within = regions_of(angles, pair);
  for (std::size_t region = 0; region < region_count; ++region)
    if (within[region]) row.regions[region].add(one);
  row.equal = row.equal && a == b;
  double error = 0;
  for (int k = 0; k < 3; ++k) error = std::max(error, std::abs(log_error(a[k], b[k], c)));
  WorstPair& worst = row.worst[static_cast<std::size_t>(angles.theta_d / cell_degrees)];
  if (error > worst.log_error) worst = {angles, in_out_angles(pair), a, b, error};
}

/// The angles of a bin's centre: computed, as those of a pair, they would be off by roundings.
HalfDifferenceAngles centre_angles(int h, int d, int p) {
  const double root = (h + 0.5) / MerlTable::theta_h_bins;
  return {root * root * 90, d + 0.5, p + 0.5};
}

Row row_of(const Brdf& a, const Brdf& b, const BinWeights& weights, int h) {
  Row row;
  for (int d = 0; d < MerlTable::theta_d_bins; ++d)
    for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
      const DirectionPair pair = directions_at_centre(h, d, p);
      if (!(pair.i.z > 0 && pair.o.z > 0)) continue;
      const BrdfValue of_a = a.value(pair), of_b = b.value(pair);
      if (of_a.measured && of_b.measured) add(row, centre_angles(h, d, p), pair, weights(h, d), of_a.f, of_b.f);
      else ++row.unknown;
    }
  return row;
}

BrdfErrors errors_of(const Sums& sums, double whole_weight) {
  BrdfErrors errors{.pairs = sums.pairs};
  if (sums.pairs == 0) return errors;
  const auto root_mean = [&](double squares) { return std::sqrt(squares / sums.weight); };
  errors.fraction = sums.weight / whole_weight;
  errors.rms = root_mean(sums.squares);
  errors.relative_rms = sums.squares == 0 ? 0 : std::sqrt(sums.squares / sums.squares_of_a);
  errors.cosine_rms = root_mean(sums.cosine_squares);
  errors.log_rms = root_mean(sums.log_squares);
  errors.cube_root_rms = root_mean(sums.cube_root_squares);
  errors.mean_difference = sums.differences / sums.weight;
  return errors;
}

} // namespace

BrdfComparison compare_brdfs(const Brdf& a, const Brdf& b) {
  const BinWeights weights;
  std::vector<Row> rows(MerlTable::theta_h_bins);
#pragma omp parallel for schedule(dynamic)
  for (int h = 0; h < MerlTable::theta_h_bins; ++h) rows[static_cast<std::size_t>(h)] = row_of(a, b, weights, h);

  BrdfComparison found;
  std::array<Sums, region_count> sums{};
  std::array<std::array<WorstPair, cells>, cells> worst{};
  for (std::size_t h = 0; h < rows.size(); ++h) {
    const Row& row = rows[h];
    for (std::size_t region = 0; region < region_count; ++region) sums[region].add(row.regions[region]);
    found.unknown += row.unknown;
    found.equal = found.equal && row.equal;
    for (std::size_t d = 0; d < cells; ++d) {
      WorstPair& of_cell = worst[static_cast<std::size_t>(row.worst[d].half_difference.theta_h / cell_degrees)][d];
      if (row.worst[d].log_error > of_cell.log_error) of_cell = row.worst[d];
    }
  }
  for (std::size_t region = 0; region < region_count; ++region)
    found.regions[region] = errors_of(sums[region], sums[0].weight);
  for (const auto& row : worst)
    for (const WorstPair& pair : row)
      if (pair.log_error > 0) found.worst.push_back(pair);
  std::ranges::stable_sort(found.worst, std::greater<>(), &WorstPair::log_error);
  found.worst.resize(std::min<std::size_t>(found.worst.size(), 10));
  return found;
}

bool is_within(const BrdfLimits& limits, const BrdfComparison& found) {
  if (!limits.max_rms && !limits.max_cosine_rms && !limits.max_log_rms && !limits.max_cube_root_rms) return found.equal;
  const BrdfErrors& all = found.of(BrdfRegion::all);
  const auto within = [](const std::optional<double>& limit, double error) { return !limit || error <= *limit; };
  return within(limits.max_rms, all.rms) && within(limits.max_cosine_rms, all.cosine_rms) &&
         within(limits.max_log_rms, all.log_rms) && within(limits.max_cube_root_rms, all.cube_root_rms);
}

} // namespace refraster
