#include "io/mesh/obj_text.h"

#include "io/file/text_kind.h"
#include "io/mesh/obj/chunk.h"
#include "io/mesh/obj/faults.h"
#include "io/mesh/obj/lines.h"
#include "io/mesh/obj_numbers.h"
#include "io/parallel/pieces.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <map>
#include <thread>
#include <utility>

namespace refraster {
namespace {

constexpr const char* obj_text = "an OBJ file: text in ASCII or UTF-8";

/// Nothing less is worth to be read by a thread of its own.
constexpr std::size_t min_chunk_bytes = std::size_t{1} << 16;

/// Of a text without faults and faces, what there is.
std::string what_instead_of_faces(const ObjChunk& whole) {
  std::string found;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) found += (found.empty() ? "" : " and ") + std::string(what);
  };
  add(whole.points_drawn, "points");
  add(whole.lines_drawn, "lines");
  add(whole.free_forms, "free-form curves or surfaces");
  if (!found.empty()) return "only " + found + ": they are not drawn";
  return whole.v.empty() ? "no statement v or f" : "no face, only vertices";
}

/// Throws InputError with all that is wrong.
[[noreturn]] void throw_faults(const std::string& file, ObjLines& lines) {
  ObjFaults faults(file, lines);
  ObjText obj;
  const ObjCounts room = count_chunk(lines.text(), 0, lines.text().size());
  make_room(room, obj);
  ObjChunk whole(obj, {}, room);
  read_chunk(lines.text(), 0, lines.text().size(), &faults, whole);
  faults.finish(whole, whole.face_ends.empty() ? what_instead_of_faces(whole) : "");
  assert(false);
  throw InputError(InputFault{file, 0, 0, "", "text that cannot be read", obj_text});
}

class Joiner {
public:
  Joiner(std::vector<ObjChunk>& chunks, ObjText& obj)
      : chunks_(chunks), obj_(obj), before_(chunks.size() + 1), lines_before_(chunks.size()) {
    std::size_t lines = 0;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      const ObjChunk& chunk = chunks[i];
      before_[i + 1] = before_[i];
      before_[i + 1] += chunk.counts();
      lines_before_[i] = lines;
      lines += chunk.lines;
      obj.has_not_finite = obj.has_not_finite || chunk.has_not_finite;
      obj.has_mixed_corners = obj.has_mixed_corners || chunk.has_mixed_corners;
      has_not_finite_v_ = has_not_finite_v_ || chunk.has_not_finite_v;
    }
  }

  /// False if an index points nowhere, or to a v that is not finite.
  bool join(int threads) {
    const ObjCounts& all = before_.back();
    join_moved();
    join_statements();
    for (std::size_t i = 0; i < chunks_.size(); ++i) close_gap(chunks_[i], before_[i]);
    make_room(all, obj_); // no less than that
    if (std::any_of(chunks_.begin(), chunks_.end(), [](const ObjChunk& chunk) { return !chunk.colours.empty(); }))
      obj_.colours.assign(all.v, Float3(-1.0f));
    std::atomic<bool> sound = true;
    for_pieces(threads, chunks_.size(), [&](std::size_t i, int) {
      if (!resolve(chunks_[i], before_[i])) sound = false;
    });
    return sound && !(has_not_finite_v_ && uses_not_finite_v());
  }

private:
  /// Where there was more room than the chunks before needed.
  void close_gap(const ObjChunk& chunk, const ObjCounts& before) {
    const auto move = [](const auto& part, auto* to) {
      if (part.begin() != to) std::copy(part.begin(), part.end(), to);
    };
    move(chunk.v, obj_.v.data() + before.v);
    move(chunk.vt, obj_.vt.data() + before.vt);
    move(chunk.vn, obj_.vn.data() + before.vn);
    move(chunk.corners, obj_.faces.corners.data() + before.corners);
    move(chunk.face_ends, obj_.faces.begin.data() + before.faces + 1);
  }

  bool resolve(const ObjChunk& chunk, const ObjCounts& before) {
    std::copy(chunk.colours.begin(), chunk.colours.end(),
              obj_.colours.begin() + static_cast<std::ptrdiff_t>(chunk.colours.empty() ? 0 : before.v));
    if (before.corners > 0)
      for (std::size_t f = 0; f < chunk.face_ends.size(); ++f)
        obj_.faces.begin[before.faces + f + 1] += static_cast<std::uint32_t>(before.corners);
    bool sound = chunk.last_used[0] < static_cast<std::int32_t>(obj_.v.size()) &&
                 chunk.last_used[1] < static_cast<std::int32_t>(obj_.vt.size()) &&
                 chunk.last_used[2] < static_cast<std::int32_t>(obj_.vn.size());
    if (!chunk.has_relative) return sound; // nearly always: the others are as they are to be
    const auto resolve = [&](std::int32_t& index, std::size_t given_before, std::size_t size) {
      if (index == -1) return;
      if (index < 0) index += static_cast<std::int32_t>(given_before) - relative_index;
      sound = sound && index >= 0 && index < static_cast<std::int32_t>(size);
    };
    ObjCorner* const corners = obj_.faces.corners.data() + before.corners;
    for (std::size_t i = 0; i < chunk.corners.size(); ++i) {
      resolve(corners[i].v, before.v, obj_.v.size());
      resolve(corners[i].vt, before.vt, obj_.vt.size());
      resolve(corners[i].vn, before.vn, obj_.vn.size());
    }
    return sound;
  }

  bool uses_not_finite_v() const {
    return std::any_of(obj_.faces.corners.begin(), obj_.faces.corners.end(),
                       [&](const ObjCorner& corner) { return !is_finite(obj_.v[static_cast<std::size_t>(corner.v)]); });
  }

  void join_moved() {
    const Float3* last = nullptr; // of the chunks before
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      const ObjChunk& chunk = chunks_[i];
      const auto first = static_cast<std::int32_t>(before_[i].v);
      if (chunk.v.empty()) continue;
      if (last)
        if (const float by = moved_by(chunk.first_v, chunk.v[0], *last); by > 0) obj_.moved.push_back({first, by});
      for (const MovedVertex& moved : chunk.moved) obj_.moved.push_back({first + moved.v, moved.by});
      last = &chunk.v.back();
    }
  }

  /// In the order of the file: what a statement says holds until the next one.
  void join_statements() {
    std::map<std::pair<bool, std::uint64_t>, std::int32_t> groups; // by sign and size
    std::int32_t group = smoothing_off;
    for (std::size_t i = 0; i < chunks_.size(); ++i)
      for (const ObjStatement& statement : chunks_[i].statements) {
        const std::size_t face = before_[i].faces + statement.face;
        const auto line = static_cast<int>(lines_before_[i] + statement.line);
        switch (statement.kind) {
        case ObjStatement::Kind::library:
          obj_.material_libraries.push_back({std::string(statement.name), line});
          break;
        case ObjStatement::Kind::material:
          add_material(statement.name, static_cast<std::uint32_t>(face), line);
          break;
        case ObjStatement::Kind::smoothing:
          obj_.has_smoothing = true;
          obj_.smoothing.resize(face, group);
          group = smoothing_off;
          if (statement.smoothing.second > 0)
            group = groups.try_emplace(statement.smoothing, static_cast<std::int32_t>(groups.size()) + 1).first->second;
        }
      }
    if (obj_.has_smoothing) obj_.smoothing.resize(before_.back().faces, group);
  }

  void add_material(std::string_view name, std::uint32_t face, int line) {
    MaterialRun run{face, -1};
    if (!name.empty()) {
      const auto next = static_cast<std::int32_t>(obj_.material_names.size());
      const auto [at, is_new] = names_.try_emplace(std::string(name), next);
      if (is_new) obj_.material_names.push_back({std::string(name), line});
      run.name = at->second;
    }
    std::vector<MaterialRun>& runs = obj_.material_runs;
    if (!runs.empty() && runs.back().face == run.face) runs.back() = run;
    else runs.push_back(run);
  }

  std::vector<ObjChunk>& chunks_;
  ObjText& obj_;
  std::vector<ObjCounts> before_; // of each chunk, what lies before it; then what there is
  std::vector<std::size_t> lines_before_;
  bool has_not_finite_v_ = false;
  std::map<std::string, std::int32_t> names_; // of materials
};

} // namespace

int threads_of(const ObjWork& work) {
  return work.threads > 0 ? work.threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

ObjText parse_obj(const std::string& file, std::string text, NoteList& notes, const ObjWork& work) {
  const TextKind kind = text_kind(text);
  if (kind == TextKind::zero) {
    const TextPlace place = place_in(text, text.find('\0'));
    throw InputError(InputFault{file, place.line, place.column, "", "a zero byte", "text"});
  }
  if (kind != TextKind::plain) throw InputError(InputFault{file, 0, 0, "", std::string(name_of(kind)), obj_text});
  ObjLines lines(std::move(text));
  const int threads = threads_of(work);
  const std::size_t bytes =
      work.chunk_bytes > 0 ? work.chunk_bytes
                           : std::max(min_chunk_bytes, lines.text().size() / (4 * static_cast<std::size_t>(threads)));
  const std::vector<std::size_t> begin = lines.chunks_of(bytes);
  const std::size_t count = begin.size() - 1;
  std::vector<ObjCounts> rooms(count);
  for_pieces(threads, count, [&](std::size_t i, int) { rooms[i] = count_chunk(lines.text(), begin[i], begin[i + 1]); });
  ObjCounts room;
  for (const ObjCounts& of_chunk : rooms) room += of_chunk;
  ObjText result;
  make_room(room, result);
  std::vector<ObjChunk> chunks;
  ObjCounts before;
  for (const ObjCounts& of_chunk : rooms) {
    chunks.emplace_back(result, before, of_chunk);
    before += of_chunk;
  }
  for_pieces(threads, count,
             [&](std::size_t i, int) { read_chunk(lines.text(), begin[i], begin[i + 1], nullptr, chunks[i]); });

  std::size_t faces = 0;
  bool is_faulty = false;
  ObjNotes found;
  for (ObjChunk& chunk : chunks) {
    faces += chunk.face_ends.size();
    is_faulty = is_faulty || chunk.is_faulty;
    found.add(chunk.notes);
    for (ObjStatement& statement : chunk.statements) statement.line += lines.joints_before(statement.where);
  }
  if (is_faulty || faces == 0 || !Joiner(chunks, result).join(threads)) throw_faults(file, lines);
  found.append_to(notes, file, [&](std::string_view part) { return lines.place_of(part).line; });
  return result;
}

} // namespace refraster
