#pragma once
// The text of an OBJ file, read line by line, each fault with its line and column: points, faces, smoothing groups.

#include <refraster/notes.h>

#include "io/mesh/obj/raw_vector.h"
#include "math/vec.h"

#include <cstdint>
#include <span>
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

/// Indices from 0; -1: not given.
struct ObjCorner {
  std::int32_t v, vt, vn;
};

struct ObjFaces {
  RawVector<ObjCorner> corners;         // of all faces, one after the other
  RawVector<std::uint32_t> begin = {0}; // of each face its first corner; then the number of corners

  std::size_t count() const { return begin.size() - 1; }
  std::span<ObjCorner> face(std::size_t i) { return std::span(corners).subspan(begin[i], begin[i + 1] - begin[i]); }
  std::span<const ObjCorner> face(std::size_t i) const {
    return std::span(corners).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// What a `usemtl` says: the faces from `face` on, up to the next run's, have this material. Faces before the first run
/// have none. Runs stand in the order of the file, no two begin at one face. A face of n corners becomes n - 2
/// triangles, so that the first triangle of a face f is faces.begin[f] - 2 f.
struct MaterialRun {
  std::uint32_t face;
  std::int32_t name; // which of material_names; -1: `usemtl` without a name
};

/// Words of a statement as they stand: up to the end of the line, without blanks at both ends. A '#' is part of them:
/// it may belong to a name, or begin a comment.
struct ObjName {
  std::string text;
  int line; // counted from 1
};

struct ObjText {
  RawVector<Float3> v, vn; // a v that a face uses is finite; a vn or vt that is not stands for none
  RawVector<Float2> vt;
  ObjFaces faces;                          // each index is one of a point that is there, or -1
  std::vector<std::int32_t> smoothing;     // of each face; empty if there is no `s`
  bool has_smoothing = false;              // whether there is any `s`
  bool has_not_finite = false;             // whether any vn or vt is not finite
  bool has_mixed_corners = false;          // whether some corners of any face have a vt or vn, others none
  std::vector<ObjName> material_libraries; // each `mtllib`, which may name several files
  std::vector<ObjName> material_names;     // of `usemtl`, each once, in the order of the file
  std::vector<MaterialRun> material_runs;
  /// Of each v, `v x y z r g b` or `v x y z w r g b`, as the numbers stand, NaN for what is not finite; -1 of a v
  /// without. Empty if none has one.
  std::vector<Float3> colours;
  /// Those of which rounding_may_matter (obj_numbers.h) says that it may.
  std::vector<MovedVertex> moved;
};

/// How the work is shared. It changes nothing of what comes out.
struct ObjWork {
  int threads = 0;             // 0: all
  std::size_t chunk_bytes = 0; // text that is read at a time; 0: as is good for so many threads
};

int threads_of(const ObjWork& work);

/// Throws InputError with all faults of the text, each with line and column. `file` only names it in messages. What is
/// unusual but read, or not read, goes to `notes`.
ObjText parse_obj(const std::string& file, std::string text, NoteList& notes, const ObjWork& work = {});

} // namespace refraster
