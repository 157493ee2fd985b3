#pragma once
// What is not wrong, but may not be what a user expects: a note. Faults are io/file/input_error.h.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace refraster {

/// One kind of remark on one file. As text: `file:line: found X, read as Y (12 times)`; parts that do not apply are
/// left out.
struct Note {
  std::string file;
  int line = 0;            // of the first occurrence, counted from 1; 0: not known
  std::string found;       // what is unusual: `the corner "1/"`; may be empty
  std::string consequence; // what is done about it: `read as "1"`; a whole sentence where `found` is empty
  std::uint64_t count = 1; // occurrences

  std::string text() const;
};

/// The notes of one run, one for each kind and file, in the order in which they were first met.
class NoteList {
public:
  /// Two notes are of one kind if file and consequence are the same: the first one's line and `found` are shown, and
  /// the others counted.
  void add(Note note);
  void add(const NoteList& others);

  bool empty() const { return notes_.empty(); }
  std::span<const Note> notes() const { return notes_; }

  /// For those who take notes on files as errors: throws InputError with one fault a note, if there is any.
  void throw_if_any() const;

private:
  std::vector<Note> notes_;
};

} // namespace refraster
