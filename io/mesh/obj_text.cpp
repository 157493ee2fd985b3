#include "io/mesh/obj_text.h"

#include "io/file/text_kind.h"
#include "io/mesh/obj/chunk.h"
#include "io/mesh/obj/faults.h"
#include "io/mesh/obj/lines.h"
#include "io/mesh/obj_numbers.h"
#include "raster/parallel.h"

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

/// What lies before a chunk.
struct Before {
  std::size_t v = 0, vt = 0, vn = 0, corners = 0, faces = 0, lines = 0;
};

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
  ObjChunk whole;
  read_chunk(lines.text(), 0, lines.text().size(), &faults, whole);
  faults.finish(whole, whole.face_ends.empty() ? what_instead_of_faces(whole) : "");
  assert(false);
  throw InputError(InputFault{file, 0, 0, "", "text that cannot be read", obj_text});
}

class Joiner {
public:
  Joiner(std::vector<ObjChunk>& chunks, ObjText& obj) : chunks_(chunks), obj_(obj), before_(chunks.size() + 1) {
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      const ObjChunk& chunk = chunks[i];
      const Before& here = before_[i];
      before_[i + 1] = {here.v + chunk.v.size(),
                        here.vt + chunk.vt.size(),
                        here.vn + chunk.vn.size(),
                        here.corners + chunk.corners.size(),
                        here.faces + chunk.face_ends.size(),
                        here.lines + chunk.lines};
      obj.has_not_finite = obj.has_not_finite || chunk.has_not_finite;
      obj.has_mixed_corners = obj.has_mixed_corners || chunk.has_mixed_corners;
      has_not_finite_v_ = has_not_finite_v_ || chunk.has_not_finite_v;
    }
  }

  /// False if an index points nowhere, or to a v that is not finite.
  bool join(int threads) {
    const Before& all = before_.back();
    obj_.v.resize(all.v), obj_.vt.resize(all.vt), obj_.vn.resize(all.vn);
    obj_.faces.corners.resize(all.corners), obj_.faces.begin.resize(all.faces + 1);
    obj_.faces.begin[0] = 0;
    // Before what they are made of is given back, chunk by chunk.
    join_moved();
    join_statements();
    for (const ObjChunk& chunk : chunks_)
      if (!chunk.colours.empty()) obj_.colours.assign(all.v, Float3(-1.0f));
    std::atomic<bool> sound = true;
    parallel_for(threads, chunks_.size(), [&](std::size_t i, int) {
      if (!join_lists(chunks_[i], before_[i])) sound = false;
      chunks_[i] = {};
    });
    return sound && !(has_not_finite_v_ && uses_not_finite_v());
  }

private:
  bool join_lists(const ObjChunk& chunk, const Before& before) {
    const auto place = [](const auto& from, auto& to, std::size_t at) {
      std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(at));
    };
    place(chunk.v, obj_.v, before.v);
    place(chunk.vt, obj_.vt, before.vt);
    place(chunk.vn, obj_.vn, before.vn);
    place(chunk.colours, obj_.colours, before.v);
    for (std::size_t f = 0; f < chunk.face_ends.size(); ++f)
      obj_.faces.begin[before.faces + f + 1] = static_cast<std::uint32_t>(before.corners) + chunk.face_ends[f];
    const auto v = static_cast<std::int32_t>(obj_.v.size()), vt = static_cast<std::int32_t>(obj_.vt.size()),
               vn = static_cast<std::int32_t>(obj_.vn.size());
    bool sound = true;
    const auto resolve = [&](std::int32_t& index, std::size_t given_before, std::int32_t size) {
      if (index == -1) return;
      if (index < 0) index += static_cast<std::int32_t>(given_before) - relative_index;
      sound = sound && index >= 0 && index < size;
    };
    ObjCorner* to = obj_.faces.corners.data() + before.corners;
    for (ObjCorner corner : chunk.corners) {
      resolve(corner.v, before.v, v), resolve(corner.vt, before.vt, vt), resolve(corner.vn, before.vn, vn);
      *to++ = corner;
    }
    return sound;
  }

  bool uses_not_finite_v() const {
    return std::any_of(obj_.faces.corners.begin(), obj_.faces.corners.end(), [&](const ObjCorner& corner) {
      return !is_finite(obj_.v[static_cast<std::size_t>(corner.v)]);
    });
  }

  void join_moved() {
    const Float3* last = nullptr; // of the chunks before
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      const ObjChunk& chunk = chunks_[i];
      const auto first = static_cast<std::int32_t>(before_[i].v);
      if (chunk.v.empty()) continue;
      if (last)
        if (const float by = moved_by(chunk.first_v, chunk.v.front(), *last); by > 0) obj_.moved.push_back({first, by});
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
        const auto line = static_cast<int>(before_[i].lines + statement.line);
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
            group =
                groups.try_emplace(statement.smoothing, static_cast<std::int32_t>(groups.size()) + 1).first->second;
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
  std::vector<Before> before_; // each chunk; and the end
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
  std::vector<ObjChunk> chunks(begin.size() - 1);
  parallel_for(threads, chunks.size(),
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
  ObjText result;
  if (is_faulty || faces == 0 || !Joiner(chunks, result).join(threads)) throw_faults(file, lines);
  found.append_to(notes, file, [&](std::string_view part) { return lines.place_of(part).line; });
  return result;
}

} // namespace refraster
