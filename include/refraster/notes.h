#pragma once
// What is said to a user about files: faults, which are thrown, and notes, which are collected.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// One fault in one input. As text: `FILE:LINE:COLUMN: /json/path: found X, expected Y`; parts that do not apply are
/// left out.
struct InputFault {
  std::string file;     ///< its path
  int line = 0;         ///< counted from 1; 0: not known
  int column = 0;       ///< likewise
  std::string path;     ///< JSON pointer, or a name of a place in a binary file
  std::string found;    ///< what stands there
  std::string expected; ///< what may

  /// The line that is printed.
  std::string text() const;
};

/// All faults found in the input, in the order of the file. what() has one line for each. Exit code 3.
class InputError : public std::runtime_error {
public:
  /// `unlisted`: how many faults the last of the list stands for ("found 400 more faults"); 0 if it is one itself.
  explicit InputError(std::vector<InputFault> list, std::size_t unlisted = 0);
  /// A single one.
  explicit InputError(InputFault fault) : InputError(std::vector<InputFault>{std::move(fault)}) {}
  /// A single one, with advice().
  InputError(InputFault fault, std::string advice) : InputError(std::move(fault)) { advice_ = std::move(advice); }
  /// In the order of the file.
  const std::vector<InputFault>& faults() const { return faults_; }
  /// What to do about it: lines to print below what(), each with its line end. Mostly empty.
  const std::string& advice() const { return advice_; }
  /// How many faults the last one stands for; 0 if it is one itself.
  std::size_t unlisted() const { return unlisted_; }

private:
  std::string advice_;
  std::vector<InputFault> faults_;
  std::size_t unlisted_ = 0;
};

/// An output file cannot be written: full disk, missing folder, no permission. Exit code 4.
class OutputError : public std::runtime_error {
public:
  /// "FILE: REASON".
  OutputError(const std::string& file, const std::string& reason);
};

/// One kind of remark on one file. As text: `FILE:LINE: found X, read as Y (12 times)`; parts that do not apply are
/// left out.
struct Note {
  std::string file;        ///< its path
  int line = 0;            ///< of the first occurrence, counted from 1; 0: not known
  std::string found;       ///< what is unusual: `the corner "1/"`; may be empty
  std::string consequence; ///< what is done about it: `read as "1"`; a whole sentence where `found` is empty
  std::uint64_t count = 1; ///< occurrences

  /// The line that is printed.
  std::string text() const;
};

/// The notes of one run, one for each kind and file, in the order in which they were first met.
class NoteList {
public:
  /// Two notes are of one kind if file and consequence are the same: the first one's line and `found` are shown, and
  /// the others counted.
  void add(Note note);
  /// Each of them.
  void add(const NoteList& others);

  /// Whether there is none.
  bool empty() const { return notes_.empty(); }
  /// One a kind and file.
  std::span<const Note> notes() const { return notes_; }

  /// For those who take notes on files as errors: throws InputError with one fault a note, if there is any.
  void throw_if_any() const;

private:
  std::vector<Note> notes_;
};

} // namespace refraster
