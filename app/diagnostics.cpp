#include "app/diagnostics.h"

#include <iostream>

namespace refraster {

void add_quiet_option(CLI::App& command, Diagnostics& diagnostics) {
  command.add_flag_callback(
      "-q,--quiet", [&diagnostics] { diagnostics.verbosity = Verbosity::quiet; },
      "print errors only: no progress, notes or warnings");
}

void add_strict_option(CLI::App& command, Diagnostics& diagnostics) {
  command.add_flag_callback(
      "--strict", [&diagnostics] { diagnostics.file_notes = FileNotes::refused; },
      "a note on an input file is an error: exit code 3");
}

void print_note(std::string_view text, const Diagnostics& diagnostics) {
  if (diagnostics.verbosity == Verbosity::normal) std::cerr << "note: " << text << "\n";
}

void print_file_notes(const NoteList& notes, const Diagnostics& diagnostics) {
  if (diagnostics.file_notes == FileNotes::refused) notes.throw_if_any();
  for (const Note& note : notes.notes()) print_note(note.text(), diagnostics);
}

} // namespace refraster
