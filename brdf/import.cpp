#include "brdf/import.h"

#include "brdf/facts.h"
#include "brdf/push_pull.h"
#include "io/file/text.h"
#include "math/elementary.h"
#include "shading/merl_lookup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace refraster {
namespace {

/// A row that can be used.
struct MeasuredRow {
  DirectionPair pair;
  Rgb<double> f;
  int line;
};

std::vector<MeasuredRow> usable_rows(const NumberTable& table, NoteList& notes) {
  const std::vector<DirectionPair> pairs = pairs_of(table);
  const std::array<std::size_t, 3> columns = rgb_columns(table);
  std::vector<MeasuredRow> rows;
  const auto leave_out = [&](std::size_t row, const char* found, const char* consequence) {
    notes.add({table.file, table.lines[row], found, consequence, 1});
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Rgb<double> f(table.at(row, columns[0]), table.at(row, columns[1]), table.at(row, columns[2]));
    if (!std::isfinite(f.x) || !std::isfinite(f.y) || !std::isfinite(f.z))
      leave_out(row, "a value that is not finite", "the row is left out: not finite");
    else if (std::min({f.x, f.y, f.z}) < 0) leave_out(row, "a negative value", "the row is left out: negative");
    else if (!(pairs[row].i.z > 0 && pairs[row].o.z > 0))
      leave_out(row, "light or eye not above the surface", "the row is left out: not above the surface");
    else rows.push_back({pairs[row], f, table.lines[row]});
  }
  return rows;
}

/// A pair to single precision: theta_in, theta_out, dphi.
using PairKey = std::tuple<float, float, float>;

void note_reciprocity(const NumberTable& table, const std::vector<MeasuredRow>& rows, NoteList& notes) {
  // Both angles and values are taken to single precision; a few of its roundings are no difference.
  constexpr double roundings = 0x1p-21;
  std::map<PairKey, const MeasuredRow*> known;
  std::vector<PairKey> keys;
  for (const MeasuredRow& row : rows) {
    const InOutAngles angles = in_out_angles(row.pair);
    keys.emplace_back(static_cast<float>(angles.theta_in), static_cast<float>(angles.theta_out),
                      static_cast<float>(angles.dphi));
    known.emplace(keys.back(), &row);
  }
  double worst = 0;
  std::uint64_t broken = 0;
  int line = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto [in, out, dphi] = keys[k];
    if (!(in < out)) continue; // each pair of rows once
    const auto other = known.find({out, in, dphi});
    if (other == known.end()) continue;
    double difference = 0;
    for (int c = 0; c < 3; ++c) {
      const double a = rows[k].f[c], b = other->second->f[c], larger = std::max(a, b);
      if (larger > 0) difference = std::max(difference, std::abs(a - b) / larger);
    }
    if (!(difference > roundings)) continue;
    ++broken;
    if (difference > worst) worst = difference, line = rows[k].line;
  }
  if (broken > 0)
    notes.add(
        {table.file, line,
         counted(broken, "pair") + format(" of rows that differ by up to %.3g with light and eye exchanged", worst),
         "their mean is taken: no surface does that", 1});
}

struct Bin {
  int h, d, p;
};

Bin bin_of(const DirectionPair& pair) {
  const MerlPoint<double> at = merl_point(half_difference(MerlAngles::closed, Double3(0, 0, 1), pair.i, pair.o));
  const auto index = [](double x, int count) { return std::min(static_cast<int>(x), count - 1); };
  return {index(at.u, MerlTable::theta_h_bins), index(at.v, MerlTable::theta_d_bins),
          index(at.w, MerlTable::phi_d_bins)};
}

std::size_t sample_of(const Bin& bin) {
  return static_cast<std::size_t>(MerlTable::offset(bin.h, bin.d, bin.p) / 3);
}

/// Interpolated like a table's logarithms: a highlight is thousands of times brighter than what is beside it.
double to_logarithm(double f) {
  return log2(1 + f / MerlTable::log_epsilon);
}
double from_logarithm(double g) {
  return MerlTable::log_epsilon * std::max(exp2(g) - 1, 0.0);
}

/// Means of the rows, with weight 1 where there are any.
GapGrid binned(const std::vector<MeasuredRow>& rows) {
  GapGrid grid{{MerlTable::theta_h_bins, MerlTable::theta_d_bins, MerlTable::phi_d_bins}, {}, {}};
  grid.values.assign(3 * MerlTable::samples, 0);
  grid.weights.assign(MerlTable::samples, 0);
  for (const MeasuredRow& row : rows) {
    const std::size_t k = sample_of(bin_of(row.pair));
    for (std::size_t c = 0; c < 3; ++c) grid.values[3 * k + c] += row.f[static_cast<int>(c)];
    ++grid.weights[k];
  }
  for (std::size_t k = 0; k < MerlTable::samples; ++k) {
    if (grid.weights[k] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) grid.values[3 * k + c] /= grid.weights[k];
    grid.weights[k] = 1;
  }
  return grid;
}

template <class Use>
void for_each_bin(const Use& use) {
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 0; d < MerlTable::theta_d_bins; ++d)
      for (int p = 0; p < MerlTable::phi_d_bins; ++p) use(Bin{h, d, p});
}

void add_mirror_images(GapGrid& grid) {
  const std::vector<double> own = grid.weights;
  for_each_bin([&](const Bin& bin) {
    const std::size_t to = sample_of(bin), from = sample_of({bin.h, bin.d, MerlTable::phi_d_bins - 1 - bin.p});
    if (own[to] != 0 || own[from] == 0) return;
    std::copy_n(&grid.values[3 * from], 3, &grid.values[3 * to]);
    grid.weights[to] = 1;
  });
}

} // namespace

ImportedTable import_table(const NumberTable& table, BinFill fill, NoteList& notes) {
  const std::vector<MeasuredRow> rows = usable_rows(table, notes);
  if (rows.empty())
    throw InputError(InputFault{table.file, 0, 0, "", "no row that can be used", "values at some pairs of directions"});
  note_reciprocity(table, rows, notes);
  ImportedTable result{.table = nullptr, .rows = rows.size()};
  GapGrid grid = binned(rows);
  result.bins_with_rows = static_cast<std::size_t>(std::count(grid.weights.begin(), grid.weights.end(), 1.0));
  add_mirror_images(grid);
  const std::vector<double> known = grid.weights, measured = grid.values;
  if (fill == BinFill::interpolated) {
    for (double& value : grid.values) value = to_logarithm(value);
    fill_gaps(grid);
  }
  PaddedVector<double> rgb(3 * MerlTable::samples, -1.0);
  for_each_bin([&](const Bin& bin) {
    const auto [i, o] = directions_at_centre(bin.h, bin.d, bin.p);
    const std::size_t k = sample_of(bin);
    if (std::min(i.z, o.z) < -rim_sine && known[k] == 0) return;
    ++result.bins;
    for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
      if (known[k] == 1) rgb[c] = measured[c];
      else if (fill == BinFill::interpolated) rgb[c] = from_logarithm(grid.values[c]);
  });
  result.table = std::make_shared<const MerlTable>(std::move(rgb));
  Merl merl;
  merl.table = result.table;
  for (const std::string& sentence : impossibilities(brdf_facts({table.file, merl})))
    notes.add({table.file, 0, "", "the table " + sentence, 1});
  return result;
}

} // namespace refraster
