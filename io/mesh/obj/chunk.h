#pragma once
// A part of an OBJ file's text, whole lines of it, read by itself: parts are read in parallel, and joined in
// obj_text.cpp.

#include "io/mesh/obj_notes.h"
#include "io/mesh/obj_text.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

enum class ObjList { v, vt, vn };

/// A statement that says something of the faces behind it, or names a file.
struct ObjStatement {
  enum class Kind { material, library, smoothing } kind;
  std::uint32_t face;                            // the next one of the chunk, from 0
  std::size_t line;                              // of the chunk, from 1; lines that continue one another are one
  std::string_view where;                        // the statement
  std::string_view name = {};                    // of a material or library
  std::pair<bool, std::uint64_t> smoothing = {}; // sign and size of the group's number; size 0: off
};

/// An index that is counted back from the last point given is one from the chunk's first point, which may lie before
/// it, less this: until the points before the chunk are counted. Fewer than 2^29 points have room in a file.
inline constexpr std::int32_t relative_index = -(1 << 30), max_back = 1 << 29;

/// How many there are of each thing, or at least how many of them there is room for.
struct ObjCounts {
  std::size_t v = 0, vt = 0, vn = 0, corners = 0, faces = 0;

  ObjCounts& operator+=(const ObjCounts& other) {
    v += other.v, vt += other.vt, vn += other.vn, corners += other.corners, faces += other.faces;
    return *this;
  }
  bool operator==(const ObjCounts&) const = default;
};

/// A part of a list that is filled from its begin on.
template <class T>
class Part {
public:
  Part() = default;
  Part(T* begin, std::size_t room) : begin_(begin), room_(room) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return begin_[i]; }
  T* begin() const { return begin_; }
  T* end() const { return begin_ + size_; }
  const T& back() const { return begin_[size_ - 1]; }
  /// There is room for what count_chunk has seen; what it might not have seen is left out.
  void push_back(const T& value) {
    assert(size_ < room_);
    if (size_ < room_) begin_[size_++] = value;
  }
  void shrink_to(std::size_t size) { size_ = size; }

private:
  T* begin_ = nullptr;
  std::size_t size_ = 0, room_ = 0;
};

/// What stands in a chunk. Indices and faces are counted from the chunk's first.
struct ObjChunk {
  ObjChunk() = default;
  /// Writes behind so many points and faces of lists that have room for the chunk.
  ObjChunk(ObjText& obj, const ObjCounts& before, const ObjCounts& room);

  ObjCounts counts() const { return {v.size(), vt.size(), vn.size(), corners.size(), face_ends.size()}; }

  Part<Float3> v, vn;
  Part<Float2> vt;
  Part<ObjCorner> corners;       // -1: not given; or from 0, not yet known to be there; or see relative_index
  Part<std::uint32_t> face_ends; // of each face, the corner behind its last
  std::vector<Float3> colours;   // as ObjText has them
  std::vector<MovedVertex> moved;
  std::vector<ObjStatement> statements;
  ObjNotes notes;
  std::string_view first_v; // the line of the first v
  std::size_t lines = 0;
  std::size_t points_drawn = 0, lines_drawn = 0, free_forms = 0; // that are not read: statements p, l, and curv or surf
  bool has_not_finite_v = false, has_not_finite = false;         // any v; any vn or vt
  bool has_mixed_corners = false;
  std::array<std::int32_t, 3> last_used = {-1, -1, -1}; // of v, vt, vn: the largest index that is not a relative one
  bool has_relative = false;                            // whether any index is
  bool is_faulty = false;                               // then nothing else of it is of use
};

/// What text[begin, end), which is whole lines, has room for: never less than read_chunk finds in it, and just that
/// where there is no comment behind a face.
ObjCounts count_chunk(std::string_view text, std::size_t begin, std::size_t end);

/// Makes room for so much. What is in the lists is lost.
void make_room(const ObjCounts& counts, ObjText& obj);

/// Hears of what is wrong with the text, and of indices while it is read: for messages.
class ObjFaults;

/// Reads text[begin, end), which is whole lines. `text` goes on behind them, at least by a zero byte. With `faults` the
/// chunk is the whole text, and every fault is reported; without, the chunk is said to be faulty at the first one.
void read_chunk(std::string_view text, std::size_t begin, std::size_t end, ObjFaults* faults, ObjChunk& chunk);

/// How far rounding moved a v, `line`: 0 unless rounding_may_matter.
float moved_by(std::string_view line, const Float3& point, const Float3& before);

} // namespace refraster
