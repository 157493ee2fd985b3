// Tables from rows of measured values.

#include <refraster/notes.h>

#include "brdf/comparison.h"
#include "brdf/evaluation.h"
#include "brdf/import.h"
#include "brdf/push_pull.h"
#include "tests/support/shading/brdf_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace refraster;
using namespace refraster::test;

namespace {

/// Angles of a goniometer, every `step` degrees up to 80.
std::vector<DirectionPair> goniometer(int step) {
  std::vector<DirectionPair> pairs;
  for (int in = 0; in <= 80; in += step)
    for (int out = 0; out <= 80; out += step)
      for (int dphi = 0; dphi <= 180; dphi += step)
        pairs.push_back(directions_of(InOutAngles{double(in), double(out), double(dphi)}));
  return pairs;
}

struct Imported {
  ImportedTable table;
  std::string notes;
};

Imported import_text(const std::string& csv, BinFill fill = BinFill::interpolated) {
  NoteList notes;
  Imported imported{import_table(number_table("t.csv", csv), fill, notes), ""};
  for (const Note& note : notes.notes()) imported.notes += note.text() + "\n";
  return imported;
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("gaps of a grid are filled from what is around them; what is known stays") {
  GapGrid grid{{4, 3, 6}, std::vector<double>(3 * 72, 0), std::vector<double>(72, 0)};
  grid.weights[5] = grid.weights[40] = 1;
  for (std::size_t c = 0; c < 3; ++c) grid.values[15 + c] = 2, grid.values[120 + c] = 6;
  fill_gaps(grid);
  CHECK(grid.values[15] == 2);
  CHECK(grid.values[120] == 6);
  CHECK(std::ranges::all_of(grid.values, [](double v) { return v >= 2 && v <= 6; }));
  GapGrid nothing{{2, 2, 2}, std::vector<double>(24, 0), std::vector<double>(8, 0)};
  fill_gaps(nothing);
  CHECK(std::ranges::all_of(nothing.values, [](double v) { return v == 0; }));
}

TEST_CASE("text that is no measurement is refused") {
  const auto refusal = [](const std::string& csv) {
    try {
      import_text(csv);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(has(refusal("theta_in,theta_out,dphi\n0,0,0\n"), "expected among them r,g,b: values in 1/sr"));
  CHECK(has(refusal("r,g,b\n0,0,0\n"), "expected among them theta_in,theta_out,dphi or "));
  CHECK(has(refusal("theta_in,theta_out,dphi,r,g,b\n"), "found no row that can be used"));
  CHECK(has(refusal("theta_in,theta_out,dphi,r,g,b\n0,0,0,-1,0,0\n"), "found no row that can be used"));
}

TEST_SUITE_BEGIN("slow"); // whole tables

TEST_CASE("a few values of a Lambert surface make the table of one") {
  const Brdf lambert("lambert", {Lambert{{0.2, 0.5, 0.8}}});
  const Imported imported = import_text(evaluation_csv(lambert, goniometer(20)));
  CHECK(imported.notes == "");
  CHECK(imported.table.rows == 250);
  CHECK(imported.table.bins_with_rows > 100);
  // 2^g - 1 of g = log2(1 + f / 1e-4), near 11: a few roundings.
  CHECK(compare_brdfs(lambert, table_brdf(imported.table.table)).of(BrdfRegion::all).relative_rms < 1e-12);
}

TEST_CASE("a row for each bin makes the table that they are from, gaps and all") {
  const Brdf table = table_brdf_from(GgxDielectric{0.2, 1.5, {0.6, 0.3, 0.1}});
  std::vector<DirectionPair> pairs;
  for (int h = 0; h < 90; ++h)
    for (int d = 0; d < 90; d += 9)
      for (int p = 0; p < 180; p += 9) pairs.push_back(directions_at_centre(h, d, p));
  std::erase_if(pairs, [](const DirectionPair& pair) { return !(pair.i.z > 0 && pair.o.z > 0); });
  const Imported imported = import_text(evaluation_csv(table, pairs), BinFill::unmeasured);
  CHECK(imported.table.bins_with_rows == pairs.size());
  for (const DirectionPair& pair : pairs) {
    const Rgb<double> there = table.value(pair).f, here = table_brdf(imported.table.table).value(pair).f;
    REQUIRE(here.y == doctest::Approx(there.y).epsilon(1e-9)); // at a centre, neighbours have no weight but roundings
  }
  CHECK(imported.table.table->sample(3, 1, 1).x == -1);
}

TEST_CASE("a goniometer's rows make a table that is near the surface between them") {
  const Brdf surface("surface", {GgxDielectric{0.4, 1.5, {0.6, 0.3, 0.1}}});
  const Imported imported = import_text(evaluation_csv(surface, goniometer(5)));
  const BrdfComparison found = compare_brdfs(surface, table_brdf(imported.table.table));
  // Measured: 0.010. Rows are at most 2.5 degrees away from any place below 80 degrees.
  CHECK(found.of(BrdfRegion::rest).relative_rms < 0.03);
  CHECK(imported.notes == "");
}

TEST_CASE("what no surface does is noted") {
  Imported imported = import_text("theta_in,theta_out,dphi,r,g,b\n0,0,0,-1,0,0\n0,10,0,nan,0,0\n0,90,0,1,1,1\n"
                                  "10,20,0,.1,.1,.1\n20,10,0,.2,.1,.1\n");
  CHECK(has(imported.notes, "t.csv:2: found a negative value, the row is left out: negative"));
  CHECK(has(imported.notes, "t.csv:3: found a value that is not finite"));
  CHECK(has(imported.notes, "t.csv:4: found light or eye not above the surface"));
  CHECK(has(imported.notes, "t.csv:5: found 1 pair of rows that differ by up to 0.5 with light and eye exchanged"));
  CHECK(imported.table.rows == 2);
  imported = import_text("theta_in,theta_out,dphi,r,g,b\n0,0,0,.5,.1,.1\n");
  CHECK(has(imported.notes, "the table reflects more light than arrives: albedo 1.57"));
}

TEST_SUITE_END();
