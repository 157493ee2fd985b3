#include <refraster/notes.h>

#include "io/file/text.h"

#include <algorithm>

namespace refraster {
namespace {

std::string times(std::uint64_t count) {
  return count > 1 ? " (" + std::to_string(count) + " times)" : std::string();
}

} // namespace

std::string Note::text() const {
  std::string result = file;
  if (line > 0) result += ":" + std::to_string(line);
  if (!result.empty()) result += ": ";
  if (!found.empty()) result += "found " + found + ", ";
  return one_line(result + consequence + times(count)); // a name may have any character
}

void NoteList::add(Note note) {
  const auto same = std::find_if(notes_.begin(), notes_.end(), [&](const Note& other) {
    return other.file == note.file && other.consequence == note.consequence;
  });
  if (same == notes_.end()) notes_.push_back(std::move(note));
  else same->count += note.count;
}

void NoteList::add(const NoteList& others) {
  for (const Note& note : others.notes_) add(note);
}

void NoteList::throw_if_any() const {
  if (empty()) return;
  std::vector<InputFault> faults;
  for (const Note& note : notes_)
    faults.push_back({note.file, note.line, 0, "",
                      (note.found.empty() ? note.consequence : note.found) + times(note.count),
                      "a file without notes (--strict)"});
  throw InputError(std::move(faults));
}

} // namespace refraster
