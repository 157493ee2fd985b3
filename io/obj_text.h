#pragma once
// The text of an OBJ file, checked line by line, and its numbers. tinyobjloader tells no lines, takes a word that is no
// number for 0 and an index out of range for none, and rounds a decimal number several times.

#include "math/vec.h"

#include <string>
#include <vector>

namespace refraster {

// What `s` said last: the number of a group, or one of these.
inline constexpr int no_smoothing_statement = -1;
inline constexpr int smoothing_off = 0;

struct ObjText {
  std::vector<Float3> v, vn;
  std::vector<Float2> vt;
  std::vector<int> smoothing; // of each face
  std::string text;           // the file with blanks for comments, for broken lines' ends, and for all statements but
                              // v, vt, vn and f: sound, and all that tinyobjloader need see
};

/// Throws InputError with all faults of the text, each with line and column. `file` only names it in messages.
ObjText check_obj(const std::string& file, std::string text);

} // namespace refraster
