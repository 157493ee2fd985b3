#include <refraster/notes.h>

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include "io/csv/number_table.h"

namespace refraster::fuzz {

void read_csv_bytes(Bytes bytes) {
  const std::string path = file_of("t.csv", bytes);
  const PeakMemory peak;
  try {
    const NumberTable table = read_number_table(path);
    require(!table.columns.empty(), "an accepted table has columns");
    require(table.values.size() == table.rows() * table.columns.size(), "every row has every cell");
    for (const std::string& name : table.columns)
      require(table.column(name).has_value(), "every column is found by its name");
  } catch (const InputError& error) {
    require(!error.faults().empty() && error.faults().size() <= 101, "a refusal has faults, not too many");
  }
  // A row of one digit: its number and its line, in lists that double.
  require_memory(peak, bytes.size(), 1 << 17, 32);
}

} // namespace refraster::fuzz
