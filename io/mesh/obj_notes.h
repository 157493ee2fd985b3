#pragma once
// What is unusual in an OBJ file, but has one meaning, or is left out: each kind is counted, and told once.

#include <refraster/notes.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace refraster {

/// Kinds of remarks, in the order of the specification's chapters (Wavefront, Advanced Visualizer, appendix B1). What
/// is done about each, in words, is in obj_notes.cpp.
enum class ObjRemark : std::uint8_t {
  position_not_finite, // of a v that no face uses
  normal_not_finite,
  uv_not_finite,
  empty_slot,    // `1/`, `1//`, `1/2/`
  mixed_corners, // some corners of a face have a vt or vn, others none
  face_outline,  // `fo`
  points_and_lines,
  free_form,
  smoothing_bare,
  smoothing_on,
  smoothing_number, // negative, or beyond 31 bits
  materials,
  other_files,
  unknown,
  count_
};

/// The remarks on one file.
class ObjNotes {
public:
  /// One more of a kind. `first()` is called for the first one only: gives a part of the text, and what was found.
  struct First {
    std::string_view where;
    std::string found;
  };
  template <class MakeFirst>
  void add(ObjRemark kind, MakeFirst&& first) {
    Kind& of = kinds_[static_cast<std::size_t>(kind)];
    if (of.count++ == 0) of.first = first();
  }

  /// Those of what follows in the file.
  void add(const ObjNotes& later);

  /// Appends one note a kind, in the order of their first lines. `line_of`: of a part of the text.
  void append_to(NoteList& notes, const std::string& file, const std::function<int(std::string_view)>& line_of) const;

private:
  struct Kind {
    std::uint64_t count = 0;
    First first;
  };
  std::array<Kind, static_cast<std::size_t>(ObjRemark::count_)> kinds_;
};

/// Whether a keyword is one of the format, and what it does that is not read. `shape`: v, vt, vn, f, s, which are read.
enum class ObjKeyword { shape, harmless, points_and_lines, free_form, materials, other_files, unknown };
ObjKeyword obj_keyword(std::string_view word);

} // namespace refraster
