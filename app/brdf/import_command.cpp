// refraster brdf import CSV -o TABLE

#include <refraster/files.h>

#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "brdf/import.h"
#include "io/file/text.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct ImportArguments {
  std::string csv, output = "imported.binary";
  BinFill fill = BinFill::interpolated;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
};

ExitCode run(const ImportArguments& arguments) {
  set_memory_limit(arguments.max_memory, 0);
  check_different({arguments.output}, {arguments.csv});
  check_writable(arguments.output);
  auto progress = progress_line(arguments.diagnostics, "reading " + arguments.csv);
  NoteList notes;
  const ImportedTable imported = import_table(read_number_table(arguments.csv), arguments.fill, notes);
  progress.reset();
  print_file_notes(notes, arguments.diagnostics);
  write_merl(arguments.output, *imported.table);
  if (arguments.diagnostics.verbosity == Verbosity::quiet) return ExitCode::ok;
  std::cout << arguments.output << "\n"
            << format("%zu rows in %zu of %zu bins; the others are %s\n", imported.rows, imported.bins_with_rows,
                      imported.bins,
                      arguments.fill == BinFill::interpolated ? "interpolated" : "marked as never measured");
  return ExitCode::ok;
}

} // namespace

Command brdf_import_command() {
  const auto arguments = std::make_shared<ImportArguments>();
  ImportArguments& a = *arguments;
  return {.name = "import",
          .meaning = "Make a MERL table of measured values",
          .groups = {{"Measurement",
                      {argument("CSV", a.csv,
                                "text file whose first line names the columns: r,g,b in 1/sr without cosine, and "
                                "theta_in,theta_out,dphi or theta_h,theta_d,phi_d in degrees, or "
                                "in_x,in_y,in_z,out_x,out_y,out_z"),
                       enum_option("--fill", a.fill,
                                   "what stands in bins that no row is in: what is around them, or "
                                   "nothing")}},
                     {"Run",
                      {file_option("-o,--output", "FILE", a.output, "table to write"), strict_option(a.diagnostics),
                       memory_option(a.max_memory), quiet_option(a.diagnostics)}}},
          .notes = {"What no surface does is noted: values that are negative or not finite, f(i, o) that is not "
                    "f(o, i), more light reflected than arrives. docs/brdf.md"},
          .finish = [arguments]() -> Action { return [arguments] { return run(*arguments); }; }};
}

} // namespace refraster
