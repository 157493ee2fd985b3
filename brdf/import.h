#pragma once
// From measured values at some pairs of directions to a MERL table.

#include <refraster/notes.h>

#include "brdf/points.h"

#include <memory>

namespace refraster {

/// What stands in bins that no row is in.
enum class BinFill {
  interpolated, // what their neighbours say, near or far: push_pull.h
  unmeasured    // nothing: -1
};

template <>
struct EnumNames<BinFill> {
  static constexpr std::pair<BinFill, std::string_view> names[] = {{BinFill::interpolated, "interpolate"},
                                                                   {BinFill::unmeasured, "none"}};
};

struct ImportedTable {
  std::shared_ptr<const MerlTable> table;   // null where no row could be used
  std::size_t rows = 0;                     // that were used
  std::size_t bins = 0, bins_with_rows = 0; // above the surface, or on the rim; those that a row is in
};

/// A bin holds the mean of its rows. A surface without a grain looks alike from both sides of the plane of incidence: a
/// row stands for its mirror image too, in a bin that has no row of its own. What lies deeper below the horizon than
/// rim_sine is marked as never measured.
/// Left out, with a note: rows with a value that is not finite or negative, and those with a direction that is not
/// above the surface. Noted too: rows that name one pair, to single precision, with light and eye exchanged, and differ
/// by more than that; and a table that reflects more than arrives.
/// Throws InputError as pairs_of and rgb_columns do, and where no row is left.
ImportedTable import_table(const NumberTable& table, BinFill fill, NoteList& notes);

} // namespace refraster
