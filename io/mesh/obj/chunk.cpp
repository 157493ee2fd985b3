#include "io/mesh/obj/chunk.h"

#include "io/file/text.h"
#include "io/mesh/obj/byte_masks.h"
#include "io/mesh/obj/fast_numbers.h"
#include "io/mesh/obj/faults.h"
#include "io/mesh/obj/words.h"
#include "io/mesh/obj_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>

namespace refraster {
namespace {

constexpr Float3 no_colour{-1.0f, -1.0f, -1.0f};
constexpr std::size_t max_numbers = 7; // of a statement
using Numbers = std::array<float, max_numbers>;

class ChunkReader {
public:
  ChunkReader(std::string_view text, ObjFaults* faults, ObjChunk& chunk)
      : text_(text), end_(text.data() + text.size()), faults_(faults), chunk_(chunk) {}

  void run(std::size_t begin, std::size_t end) {
    const char* at = text_.data() + begin;
    const char* const stop = text_.data() + end;
    while (at < stop && (faults_ || !chunk_.is_faulty)) {
      ++chunk_.lines;
      if (const char* const next = faults_ ? nullptr : usual_line(at)) {
        at = next;
        continue;
      }
      const std::size_t from = static_cast<std::size_t>(at - text_.data());
      const std::string_view line = text_.substr(from, std::min(text_.find('\n', from), end) - from);
      statement(line.substr(0, comment_in(line)), line);
      at = line.data() + line.size() + 1;
    }
    if (!chunk_.colours.empty()) chunk_.colours.resize(chunk_.v.size(), no_colour);
  }

private:
  // Lines as nearly all are: a keyword, a blank, numbers. What follows returns the begin of the next line, or null for
  // a line of any other kind, which has then changed nothing: statement() reads it.

  const char* usual_line(const char* at) {
    if (at[0] == 'v') {
      if (at[1] == ' ') return usual_numbers<3>(at + 2, ObjList::v, chunk_.v, 3, max_numbers);
      if (at[1] == 'n' && at[2] == ' ') return usual_numbers<3>(at + 3, ObjList::vn, chunk_.vn, 3, 3);
      if (at[1] == 't' && at[2] == ' ') return usual_numbers<2>(at + 3, ObjList::vt, chunk_.vt, 1, 3);
    }
    if (at[0] == 'f' && at[1] == ' ') return usual_face(at + 2);
    return nullptr;
  }

  /// At the end of a line behind it; else null.
  static const char* behind_line(const char* at) {
    at += *at == '\r';
    return *at == '\n' ? at + 1 : nullptr;
  }

  template <glm::length_t N>
  const char* usual_numbers(const char* at, ObjList which, Part<glm::vec<N, float, glm::defaultp>>& list,
                            std::size_t least, std::size_t most) {
    Numbers numbers{};
    std::size_t count = 0;
    for (;; ++count) {
      while (*at == ' ') ++at;
      if (const char* const next = behind_line(at)) {
        at = next;
        break;
      }
      if (count == most) return nullptr;
      at = fast_float(at, end_, numbers[count]);
      if (!at || !(*at == ' ' || *at == '\n' || *at == '\r')) return nullptr;
    }
    if (count < least) return nullptr;
    if constexpr (N == 3)
      if (which == ObjList::v &&
          (list.empty() || rounding_may_matter({numbers[0], numbers[1], numbers[2]}, list.back())))
        return nullptr;
    add_point<N>(which, list, numbers, count);
    return at;
  }

  /// All corners of one form, v, v/vt, v//vn or v/vt/vn.
  const char* usual_face(const char* at) {
    Part<ObjCorner>& corners = chunk_.corners;
    const std::size_t first = corners.size();
    const auto unusual = [&]() -> const char* {
      corners.shrink_to(first);
      return nullptr;
    };
    for (;;) {
      while (*at == ' ') ++at;
      if (const char* const next = behind_line(at)) {
        at = next;
        break;
      }
      ObjCorner corner{-1, -1, -1};
      if (!(at = usual_index(at, ObjList::v, corner.v))) return unusual();
      if (*at == '/') {
        if (*++at != '/' && !(at = usual_index(at, ObjList::vt, corner.vt))) return unusual();
        if (*at == '/' && !(at = usual_index(at + 1, ObjList::vn, corner.vn))) return unusual();
      }
      if (!(*at == ' ' || *at == '\n' || *at == '\r')) return unusual();
      corners.push_back(corner);
      if ((corner.vt == -1) != (corners[first].vt == -1) || (corner.vn == -1) != (corners[first].vn == -1))
        return unusual();
    }
    if (corners.size() < first + 3) return unusual();
    chunk_.face_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    return at;
  }

  const char* usual_index(const char* at, ObjList list, std::int32_t& from_zero) {
    std::int32_t value = 0;
    at = fast_integer(at, end_, value);
    return at && from_zero_of(value, list, from_zero) ? at : nullptr;
  }

  /// False if the value can be no index.
  bool from_zero_of(long long value, ObjList list, std::int32_t& from_zero) {
    if (value == 0 || value < -max_back || value > std::numeric_limits<std::int32_t>::max()) return false;
    if (value > 0) {
      from_zero = static_cast<std::int32_t>(value - 1);
      std::int32_t& last = chunk_.last_used[static_cast<std::size_t>(list)];
      last = std::max(last, from_zero);
    } else {
      from_zero = static_cast<std::int32_t>(static_cast<long long>(count(list)) + value + relative_index);
      chunk_.has_relative = true;
    }
    return true;
  }

  // Lines of every kind.

  /// `with_comment`: the whole line.
  void statement(std::string_view line, std::string_view with_comment) {
    const std::string_view all = line, keyword = take_word(line);
    // Behind a v may follow a weight, or a colour, or both.
    if (keyword == "v") numbers<3>(ObjList::v, chunk_.v, line, all, 3, max_numbers);
    else if (keyword == "vn") numbers<3>(ObjList::vn, chunk_.vn, line, all, 3, 3);
    else if (keyword == "vt") numbers<2>(ObjList::vt, chunk_.vt, line, all, 1, 3);
    else if (keyword == "f") face(line, all);
    else if (keyword == "fo") {
      remark(ObjRemark::face_outline, all, [] { return "fo"; });
      face(line, all);
    } else if (keyword == "s") smoothing(take_word(line), all);
    else if (!keyword.empty()) {
      if (keyword == "mtllib" || keyword == "usemtl") {
        take_word(with_comment);
        add_statement(keyword == "mtllib" ? ObjStatement::Kind::library : ObjStatement::Kind::material, all).name =
            trimmed(with_comment);
      }
      skip(keyword, all);
    }
  }

  ObjStatement& add_statement(ObjStatement::Kind kind, std::string_view all) {
    return chunk_.statements.emplace_back(
        ObjStatement{kind, static_cast<std::uint32_t>(chunk_.face_ends.size()), chunk_.lines, all});
  }

  /// A statement that says nothing about the shape, or is not read.
  void skip(std::string_view keyword, std::string_view all) {
    const auto remark_on = [&](ObjRemark kind) { remark(kind, all, [&] { return in_quotes(trimmed(all)); }); };
    switch (obj_keyword(keyword)) {
    case ObjKeyword::shape:
    case ObjKeyword::harmless:
      return;
    case ObjKeyword::points_and_lines:
      ++(keyword == "p" ? chunk_.points_drawn : chunk_.lines_drawn);
      return remark_on(ObjRemark::points_and_lines);
    case ObjKeyword::free_form:
      ++chunk_.free_forms;
      return remark_on(ObjRemark::free_form);
    case ObjKeyword::materials:
      return remark_on(ObjRemark::materials);
    case ObjKeyword::other_files:
      return remark_on(ObjRemark::other_files);
    case ObjKeyword::unknown:
      return remark_on(ObjRemark::unknown);
    }
  }

  /// Coordinates. Numbers beyond those that a point of the list has are checked, but not used.
  template <glm::length_t N>
  void numbers(ObjList which, Part<glm::vec<N, float, glm::defaultp>>& list, std::string_view rest,
               std::string_view all, std::size_t least, std::size_t most) {
    Numbers numbers{};
    std::size_t count = 0;
    std::string_view not_finite;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      float number = 0;
      const NumberText read = read_coordinate(word, number);
      if (read == NumberText::not_a_number) fault(word, in_quotes(word), finite_number);
      if (read == NumberText::not_finite) number = std::numeric_limits<float>::quiet_NaN();
      if (count < N && read == NumberText::not_finite && not_finite.empty()) not_finite = word;
      if (count < max_numbers) numbers[count] = number;
    }
    if (count < least || count > most)
      fault(all, counted(count, "number"),
            least == most ? counted(least, "number") : std::to_string(least) + " to " + counted(most, "number"));
    if (!not_finite.empty()) {
      std::fill_n(numbers.begin(), N, std::numeric_limits<float>::quiet_NaN());
      not_finite_point(which, not_finite);
    }
    if constexpr (N == 3)
      if (which == ObjList::v) {
        const Float3 point{numbers[0], numbers[1], numbers[2]};
        if (list.empty()) chunk_.first_v = all;
        else if (const float by = moved_by(all, point, list.back()); by > 0)
          chunk_.moved.push_back({static_cast<std::int32_t>(list.size()), by});
      }
    add_point<N>(which, list, numbers, count);
  }

  /// The first `count` of `numbers` were given; what others there are is 0.
  template <glm::length_t N>
  void add_point(ObjList which, Part<glm::vec<N, float, glm::defaultp>>& list, const Numbers& numbers,
                 std::size_t count) {
    if (which == ObjList::v && (count == 6 || count == 7)) {
      chunk_.colours.resize(list.size(), no_colour);
      chunk_.colours.push_back({numbers[count - 3], numbers[count - 2], numbers[count - 1]});
    }
    if constexpr (N == 3) list.push_back({numbers[0], numbers[1], numbers[2]});
    else list.push_back({numbers[0], numbers[1]});
  }

  /// A coordinate of the next point of a list is not finite.
  void not_finite_point(ObjList list, std::string_view word) {
    const auto coordinate = [&] { return "the coordinate " + in_quotes(word); };
    if (list != ObjList::v) {
      chunk_.has_not_finite = true;
      return remark(list == ObjList::vn ? ObjRemark::normal_not_finite : ObjRemark::uv_not_finite, word, coordinate);
    }
    chunk_.has_not_finite_v = true;
    remark(ObjRemark::position_not_finite, word, coordinate); // of no use if a face uses it
    if (faults_) faults_->not_finite_v(chunk_.v.size(), word);
  }

  /// Any integer of 64 bits, signed or not: some programs write the groups of a face as the bits of a word.
  void smoothing(std::string_view word, std::string_view all) {
    std::pair<bool, std::uint64_t> group{false, 0};
    if (word.empty()) {
      remark(ObjRemark::smoothing_bare, all, [] { return "s without a value"; });
    } else if (word == "on") {
      remark(ObjRemark::smoothing_on, word, [] { return "\"s on\""; });
      group.second = 1;
    } else if (word != "off") {
      group.first = word.starts_with('-');
      const char* const end = word.data() + word.size();
      const auto [stop, error] = std::from_chars(word.data() + (group.first ? 1 : 0), end, group.second);
      if (error != std::errc() || stop != end || (group.first && group.second > std::uint64_t{1} << 63))
        return fault(word, in_quotes(word), "off, or the number of a smoothing group");
      if (group.second > 0 && (group.first || group.second > std::numeric_limits<std::int32_t>::max()))
        remark(ObjRemark::smoothing_number, word, [&] { return "the smoothing group " + std::string(word); });
    }
    add_statement(ObjStatement::Kind::smoothing, all).smoothing = group;
  }

  void face(std::string_view rest, std::string_view all) {
    std::size_t corners = 0, with_vt = 0, with_vn = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++corners) {
      const ObjCorner read = corner(word);
      with_vt += read.vt != -1, with_vn += read.vn != -1;
      chunk_.corners.push_back(read);
    }
    if (corners < 3) fault(all, "a face with " + counted(corners, "corner"), "at least 3 corners");
    if ((with_vt > 0 && with_vt < corners) || (with_vn > 0 && with_vn < corners)) {
      chunk_.has_mixed_corners = true;
      remark(ObjRemark::mixed_corners, all, [] { return "a face whose corners are of several forms"; });
    }
    chunk_.face_ends.push_back(static_cast<std::uint32_t>(chunk_.corners.size()));
  }

  /// v, v/vt, v//vn or v/vt/vn; also with nothing behind the last slash.
  ObjCorner corner(std::string_view word) {
    std::string_view rest = word;
    const auto slash = [&] {
      if (!rest.starts_with('/')) return false;
      rest.remove_prefix(1);
      return true;
    };
    ObjCorner result{-1, -1, -1};
    bool sound = index(rest, ObjList::v, result.v);
    if (sound && slash()) {
      if (!rest.empty() && !rest.starts_with('/')) sound = index(rest, ObjList::vt, result.vt);
      if (sound && slash() && !rest.empty()) sound = index(rest, ObjList::vn, result.vn);
    }
    if (!sound || !rest.empty()) fault(word, in_quotes(word), "v, v/vt, v//vn or v/vt/vn");
    else if (word.ends_with('/')) remark(ObjRemark::empty_slot, word, [&] { return "the corner " + in_quotes(word); });
    return result;
  }

  /// Takes an index off the front, from 1 or counted back from the last point given, and makes it one from 0. False if
  /// there is no integer. One that points nowhere is a fault of its own.
  bool index(std::string_view& rest, ObjList list, std::int32_t& from_zero) {
    long long value = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error == std::errc::invalid_argument) return false;
    const std::string_view word = rest.substr(0, static_cast<std::size_t>(stop - rest.data()));
    rest.remove_prefix(word.size());
    const bool out_of_range = error == std::errc::result_out_of_range;
    from_zero = 0; // of no use where it points nowhere
    if (out_of_range || !from_zero_of(value, list, from_zero)) chunk_.is_faulty = true;
    if (faults_) faults_->index(list, word, value, out_of_range, count(list));
    return true;
  }

  std::size_t count(ObjList list) const {
    return list == ObjList::v ? chunk_.v.size() : list == ObjList::vt ? chunk_.vt.size() : chunk_.vn.size();
  }

  /// `where` is a part of the text.
  void fault(std::string_view where, std::string found, std::string expected) {
    chunk_.is_faulty = true;
    if (faults_) faults_->add(where, std::move(found), std::move(expected));
  }

  /// One more of a kind; `found()` says what, for the first.
  template <class Found>
  void remark(ObjRemark kind, std::string_view where, const Found& found) {
    chunk_.notes.add(kind, [&] { return ObjNotes::First{where, found()}; });
  }

  std::string_view text_;
  const char* end_; // of the text
  ObjFaults* faults_;
  ObjChunk& chunk_;
};

} // namespace

ObjChunk::ObjChunk(ObjText& obj, const ObjCounts& before, const ObjCounts& room)
    : v(obj.v.data() + before.v, room.v), vn(obj.vn.data() + before.vn, room.vn),
      vt(obj.vt.data() + before.vt, room.vt), corners(obj.faces.corners.data() + before.corners, room.corners),
      face_ends(obj.faces.begin.data() + before.faces + 1, room.faces) {}

void make_room(const ObjCounts& counts, ObjText& obj) {
  obj.v.resize(counts.v), obj.vt.resize(counts.vt), obj.vn.resize(counts.vn);
  obj.faces.corners.resize(counts.corners);
  obj.faces.begin.resize(counts.faces + 1);
  obj.faces.begin[0] = 0;
}

namespace {

/// Words that begin behind a blank, from `at` to the end of its line, which is returned; or the end of the text.
const char* count_words(const char* at, const char* stop, std::size_t& words) {
  std::uint32_t was_blank = 0; // 1: before `at`
  while (stop - at >= 16) {
    const SixteenBytes bytes(at);
    const std::uint32_t ends = bytes.are('\n'), blanks = bytes.are(' ') | bytes.are('\t') | bytes.are('\r');
    const std::uint32_t of_line = ends == 0 ? 0xffff : (ends & -ends) - 1;
    words += static_cast<std::size_t>(std::popcount(~blanks & (blanks << 1 | was_blank) & of_line));
    if (ends != 0) return at + std::countr_zero(ends);
    was_blank = blanks >> 15;
    at += 16;
  }
  for (; at < stop && *at != '\n'; ++at) {
    words += was_blank != 0 && !is_blank(*at);
    was_blank = is_blank(*at);
  }
  return at;
}

const char* line_end(const char* at, const char* stop) {
  for (; stop - at >= 16; at += 16)
    if (const std::uint32_t ends = SixteenBytes(at).are('\n')) return at + std::countr_zero(ends);
  while (at < stop && *at != '\n') ++at;
  return at;
}

} // namespace

ObjCounts count_chunk(std::string_view text, std::size_t begin, std::size_t end) {
  ObjCounts counts;
  const char* at = text.data() + begin;
  const char* const stop = text.data() + end;
  for (; at < stop; ++at) {
    while (at < stop && is_blank(*at)) ++at;
    if (at == stop) break;
    if (*at == 'f') {
      ++counts.faces;
      at = count_words(at, stop, counts.corners);
      continue;
    }
    if (*at == 'v') ++(at[1] == 'n' ? counts.vn : at[1] == 't' ? counts.vt : counts.v);
    at = line_end(at, stop);
  }
  return counts;
}

void read_chunk(std::string_view text, std::size_t begin, std::size_t end, ObjFaults* faults, ObjChunk& chunk) {
  ChunkReader(text, faults, chunk).run(begin, end);
}

float moved_by(std::string_view line, const Float3& point, const Float3& before) {
  if (!rounding_may_matter(point, before)) return 0;
  double by = 0;
  take_word(line); // the keyword
  for (glm::length_t c = 0; c < 3; ++c) {
    double exact = 0;
    if (read_number(take_word(line), exact) == NumberText::good)
      by = std::max(by, std::abs(exact - static_cast<double>(point[c])));
  }
  return static_cast<float>(by);
}

} // namespace refraster
