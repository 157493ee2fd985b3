#pragma once
// The text of an OBJ file, checked line by line, and its numbers. tinyobjloader tells no lines, takes a word that is no
// number for 0 and an index out of range for none, and rounds a decimal number several times.

#include "io/file/notes.h"
#include "math/vec.h"

#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

// What `s` said last: a group, counted from 1 in the order in which they are met, or that there is none. Faces before
// the first `s` are in none.
inline constexpr std::int32_t smoothing_off = 0;

/// How far rounding to float moved a vertex.
struct MovedVertex {
  std::int32_t v; // from 0
  float by;       // the largest of its coordinates
};

struct ObjText {
  std::vector<Float3> v, vn; // a v that a face uses is finite; a vn or vt that is not stands for none
  std::vector<Float2> vt;
  std::vector<std::int32_t> smoothing; // of each face
  bool has_smoothing = false;          // whether there is any `s`
  bool has_not_finite = false;         // whether any vn or vt is not finite
  /// Those of which rounding_may_matter (obj_numbers.h) says that it may.
  std::vector<MovedVertex> moved;
  std::string text; // the file with blanks for comments, for broken lines' ends, and for all statements but
                    // v, vt, vn and f: sound, and all that tinyobjloader need see
};

/// Throws InputError with all faults of the text, each with line and column. `file` only names it in messages. What is
/// unusual but read, or not read, goes to `notes`.
ObjText check_obj(const std::string& file, std::string text, NoteList& notes);

} // namespace refraster
