#pragma once
// What a command says beside its results, on standard error: notes.

#include <refraster/notes.h>

#include <string_view>

namespace refraster {

enum class Verbosity { normal, quiet };
enum class FileNotes { printed, refused };

/// What is said of a run: all, or errors only; and whether notes on input files are errors.
struct Diagnostics {
  Verbosity verbosity = Verbosity::normal;
  FileNotes file_notes = FileNotes::printed;
};

/// `note: …` on standard error, unless notes are not wanted.
void print_note(std::string_view text, const Diagnostics& diagnostics);

/// Notes on input files, one line each; or, with --strict, throws InputError if there is any.
void print_file_notes(const NoteList& notes, const Diagnostics& diagnostics);

} // namespace refraster
