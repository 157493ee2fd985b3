#include "app/diagnostics.h"

#include <iostream>

namespace refraster {

void print_note(std::string_view text, const Diagnostics& diagnostics) {
  if (diagnostics.verbosity == Verbosity::normal) std::cerr << "note: " << text << "\n";
}

void print_file_notes(const NoteList& notes, const Diagnostics& diagnostics) {
  if (diagnostics.file_notes == FileNotes::refused) notes.throw_if_any();
  for (const Note& note : notes.notes()) print_note(note.text(), diagnostics);
}

} // namespace refraster
