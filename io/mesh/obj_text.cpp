#include "io/mesh/obj_text.h"

#include "io/file/fault_list.h"
#include "io/file/text.h"
#include "io/file/text_kind.h"
#include "io/mesh/obj_notes.h"
#include "io/mesh/obj_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace refraster {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// The next word of a line, which is taken off its front; empty at the end.
std::string_view take_word(std::string_view& line) {
  std::size_t begin = 0; // find_first_of is slow: it searches its list for every character
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

/// Where a comment begins in a line; its size if it has none. A '#' may also be that of 1.#QNAN.
std::size_t comment_in(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    std::size_t begin = at, end = at;
    while (begin > 0 && !is_blank(line[begin - 1])) --begin;
    while (end < line.size() && !is_blank(line[end])) ++end;
    if (!is_not_finite(line.substr(begin, end - begin))) return at;
  }
  return line.size();
}

class ObjParser {
public:
  ObjParser(const std::string& file, std::string text, ObjText& obj) : file_(file), obj_(obj), text_(std::move(text)) {}

  void run() {
    const TextKind kind = text_kind(text_);
    if (kind == TextKind::zero) {
      fault(std::string_view(text_).substr(text_.find('\0')), "a zero byte", "text");
      return faults_.throw_if_any();
    }
    if (kind != TextKind::plain) throw InputError(InputFault{file_, 0, 0, "", std::string(name_of(kind)), obj_text});
    if (text_.starts_with("\xef\xbb\xbf")) blank(0, 3); // byte order mark
    mend_line_ends();
    for (std::size_t begin = 0, end = 0; begin < text_.size(); begin = end + 1) {
      end = std::min(text_.find('\n', begin), text_.size());
      while (joints_before_ < joints_.size() && joints_[joints_before_] < begin) ++joints_before_;
      ++statements_;
      const std::string_view line = std::string_view(text_).substr(begin, end - begin);
      statement(line.substr(0, comment_in(line)), line);
    }
    for (const Forward& index : forward_) {
      if (index.value > count(index.list)) no_such_index(index.word, index.list);
      else if (index.list == List::v) use(index.value - 1);
    }
    if (!obj_.colours.empty()) obj_.colours.resize(obj_.v.size(), no_colour);
    if (obj_.smoothing.empty() && faults_.empty())
      faults_.add({file_, 0, 0, "", what_instead_of_faces(), "at least one face (a statement f)"});
    faults_.sort_by_place();
    faults_.throw_if_any();
    for (const auto& unused : not_finite_v_)
      remark(ObjRemark::position_not_finite, unused.second.where,
             [&] { return "the coordinate " + unused.second.word; });
  }

  const ObjNotes& notes() const { return notes_; }

private:
  static constexpr const char* obj_text = "an OBJ file: text in ASCII or UTF-8";

  enum class List { v, vt, vn };

  /// Where a v has a coordinate that is not finite: a fault if a face uses it.
  struct NotFinite {
    std::string_view where;
    std::string word; // in quotes
  };

  /// An index to what had not been given yet where it was met.
  struct Forward {
    std::string_view word;
    long long value;
    List list;
  };

  void blank(std::size_t begin, std::size_t end) {
    std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.begin() + static_cast<std::ptrdiff_t>(end),
              ' ');
  }

  /// '\r' alone ends a line. A backslash at the end of a line that is no comment continues the line:
  /// both become blanks, and where the line ended is remembered for messages.
  void mend_line_ends() {
    for (std::size_t at = text_.find('\r'); at != std::string::npos; at = text_.find('\r', at + 1))
      if (at + 1 == text_.size() || text_[at + 1] != '\n') text_[at] = '\n';
    // Each character is looked at once, however many lines are joined to one.
    bool in_comment = false;
    std::size_t seen = 0;
    for (std::size_t at = text_.find('\\'); at != std::string::npos; at = text_.find('\\', at + 1)) {
      for (; seen < at; ++seen) in_comment = text_[seen] != '\n' && (in_comment || text_[seen] == '#');
      const std::size_t end = text_.find_first_not_of('\r', at + 1);
      if (end == std::string::npos || text_[end] != '\n' || in_comment) continue;
      blank(at, end + 1);
      joints_.push_back(end);
      seen = end + 1;
    }
  }

  /// `with_comment`: the whole line.
  void statement(std::string_view line, std::string_view with_comment) {
    const std::string_view all = line, keyword = take_word(line);
    if (keyword == "v") numbers(List::v, obj_.v, line, all, 3, 7); // then may follow a weight, or a colour, or both
    else if (keyword == "vn") numbers(List::vn, obj_.vn, line, all, 3, 3);
    else if (keyword == "vt") numbers(List::vt, obj_.vt, line, all, 1, 3);
    else if (keyword == "f") face(line, all);
    else if (keyword == "fo") {
      remark(ObjRemark::face_outline, all, [] { return "fo"; });
      face(line, all);
    } else if (keyword == "s") smoothing(take_word(line), all);
    else if (!keyword.empty()) {
      if (keyword == "mtllib" || keyword == "usemtl") {
        take_word(with_comment);
        material(keyword, trimmed(with_comment));
      }
      skip(keyword, all);
    }
  }

  void material(std::string_view keyword, std::string_view name) {
    const int line = static_cast<int>(statements_ + joints_before_);
    if (keyword == "mtllib") return obj_.material_libraries.push_back({std::string(name), line});
    MaterialRun run{static_cast<std::uint32_t>(obj_.faces.count()), -1};
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

  /// A statement that says nothing about the shape, or is not read.
  void skip(std::string_view keyword, std::string_view all) {
    const auto remark_on = [&](ObjRemark kind) { remark(kind, all, [&] { return in_quotes(trimmed(all)); }); };
    switch (obj_keyword(keyword)) {
    case ObjKeyword::shape:
    case ObjKeyword::harmless:
      return;
    case ObjKeyword::points_and_lines:
      ++(keyword == "p" ? points_ : lines_);
      return remark_on(ObjRemark::points_and_lines);
    case ObjKeyword::free_form:
      ++free_forms_;
      return remark_on(ObjRemark::free_form);
    case ObjKeyword::materials:
      return remark_on(ObjRemark::materials);
    case ObjKeyword::other_files:
      return remark_on(ObjRemark::other_files);
    case ObjKeyword::unknown:
      return remark_on(ObjRemark::unknown);
    }
  }

  /// Of a text without faults and faces, what there is.
  std::string what_instead_of_faces() const {
    std::string found;
    const auto add = [&](std::size_t count, const char* what) {
      if (count > 0) found += (found.empty() ? "" : " and ") + std::string(what);
    };
    add(points_, "points");
    add(lines_, "lines");
    add(free_forms_, "free-form curves or surfaces");
    if (!found.empty()) return "only " + found + ": they are not drawn";
    return obj_.v.empty() ? "no statement v or f" : "no face, only vertices";
  }

  /// Coordinates. Numbers beyond those that a point of the list has are checked, but not used.
  template <glm::length_t N>
  void numbers(List which, std::vector<glm::vec<N, float, glm::defaultp>>& list, std::string_view rest,
               std::string_view all, std::size_t least, std::size_t most) {
    glm::vec<N, float, glm::defaultp> point(0.0f);
    Float3 last(0.0f); // the last three numbers
    std::array<std::string_view, static_cast<std::size_t>(N)> words;
    std::size_t count = 0;
    std::string_view not_finite;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      float number = 0;
      const NumberText read = read_coordinate(word, number);
      if (read == NumberText::not_a_number) fault(word, in_quotes(word), finite_number);
      if (read == NumberText::not_finite) number = std::numeric_limits<float>::quiet_NaN();
      if (which == List::v) last = {last.y, last.z, number};
      if (count >= N) continue;
      if (read == NumberText::not_finite && not_finite.empty()) not_finite = word;
      point[static_cast<glm::length_t>(count)] = number;
      words[count] = word;
    }
    if (count < least || count > most)
      fault(all, counted(count, "number"),
            least == most ? counted(least, "number") : std::to_string(least) + " to " + counted(most, "number"));
    if (!not_finite.empty()) {
      point = glm::vec<N, float, glm::defaultp>(std::numeric_limits<float>::quiet_NaN());
      not_finite_point(which, not_finite);
    } else if constexpr (N == 3) {
      if (which == List::v && !list.empty() && rounding_may_matter(point, list.back())) moved(point, words);
    }
    if (which == List::v && count >= 6) {
      obj_.colours.resize(list.size(), no_colour);
      obj_.colours.push_back(last);
    }
    list.push_back(point);
  }

  /// A coordinate of the next point of a list is not finite.
  void not_finite_point(List list, std::string_view word) {
    if (list == List::v) {
      not_finite_v_.emplace(count(list), NotFinite{word, in_quotes(word)});
      return;
    }
    obj_.has_not_finite = true;
    remark(list == List::vn ? ObjRemark::normal_not_finite : ObjRemark::uv_not_finite, word,
           [&] { return "the coordinate " + in_quotes(word); });
  }

  void moved(const Float3& point, const std::array<std::string_view, 3>& words) {
    double by = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      double exact = 0;
      if (read_number(words[c], exact) == NumberText::good)
        by = std::max(by, std::abs(exact - static_cast<double>(point[static_cast<glm::length_t>(c)])));
    }
    if (by > 0) obj_.moved.push_back({static_cast<std::int32_t>(obj_.v.size()), static_cast<float>(by)});
  }

  /// Any integer of 64 bits, signed or not: some programs write the groups of a face as the bits of a word.
  void smoothing(std::string_view word, std::string_view all) {
    obj_.has_smoothing = true;
    if (word.empty()) {
      remark(ObjRemark::smoothing_bare, all, [] { return "s without a value"; });
      smoothing_ = smoothing_off;
    } else if (word == "off") {
      smoothing_ = smoothing_off;
    } else if (word == "on") {
      remark(ObjRemark::smoothing_on, word, [] { return "\"s on\""; });
      smoothing_ = group({false, 1});
    } else {
      const bool negative = word.starts_with('-');
      std::uint64_t size = 0;
      const char* const end = word.data() + word.size();
      const auto [stop, error] = std::from_chars(word.data() + (negative ? 1 : 0), end, size);
      if (error != std::errc() || stop != end || (negative && size > std::uint64_t{1} << 63))
        return fault(word, in_quotes(word), "off, or the number of a smoothing group");
      if (size > 0 && (negative || size > std::numeric_limits<std::int32_t>::max()))
        remark(ObjRemark::smoothing_number, word, [&] { return "the smoothing group " + std::string(word); });
      smoothing_ = size == 0 ? smoothing_off : group({negative, size});
    }
  }

  std::int32_t group(const std::pair<bool, std::uint64_t>& number) {
    return groups_.try_emplace(number, static_cast<std::int32_t>(groups_.size()) + 1).first->second;
  }

  void face(std::string_view rest, std::string_view all) {
    std::size_t corners = 0, with_vt = 0, with_vn = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++corners) {
      const ObjCorner read = corner(word);
      with_vt += read.vt >= 0, with_vn += read.vn >= 0;
      obj_.faces.corners.push_back(read);
    }
    if (corners < 3) fault(all, "a face with " + counted(corners, "corner"), "at least 3 corners");
    if ((with_vt > 0 && with_vt < corners) || (with_vn > 0 && with_vn < corners))
      remark(ObjRemark::mixed_corners, all, [] { return "a face whose corners are of several forms"; });
    obj_.faces.begin.push_back(static_cast<std::uint32_t>(obj_.faces.corners.size()));
    obj_.smoothing.push_back(smoothing_);
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
    bool sound = index(rest, List::v, result.v);
    if (sound && slash()) {
      if (!rest.empty() && !rest.starts_with('/')) sound = index(rest, List::vt, result.vt);
      if (sound && slash() && !rest.empty()) sound = index(rest, List::vn, result.vn);
    }
    if (!sound || !rest.empty()) fault(word, in_quotes(word), "v, v/vt, v//vn or v/vt/vn");
    else if (word.ends_with('/')) remark(ObjRemark::empty_slot, word, [&] { return "the corner " + in_quotes(word); });
    return result;
  }

  /// Takes an index off the front, from 1 or counted back from the last point given, and makes it one from 0. False if
  /// there is no integer. One that points nowhere is a fault of its own; one to a point that may still be given, the
  /// end of the file decides on.
  bool index(std::string_view& rest, List list, std::int32_t& from_zero) {
    long long value = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error == std::errc::invalid_argument) return false;
    const std::string_view word = rest.substr(0, static_cast<std::size_t>(stop - rest.data()));
    rest.remove_prefix(word.size());
    const long long given = count(list), at = value < 0 ? given + value : value - 1;
    from_zero = 0; // of no use where it points nowhere
    if (error == std::errc::result_out_of_range || value == 0 || at < 0) {
      no_such_index(word, list);
      return true;
    }
    if (at <= std::numeric_limits<std::int32_t>::max()) from_zero = static_cast<std::int32_t>(at);
    if (at >= given) forward_.push_back({word, value, list});
    else if (list == List::v) use(at);
    return true;
  }

  /// A face uses this v, counted from 0.
  void use(long long v) {
    if (not_finite_v_.empty()) return;
    const auto found = not_finite_v_.find(v);
    if (found == not_finite_v_.end()) return;
    fault(found->second.where, found->second.word, finite_number);
    not_finite_v_.erase(found);
  }

  long long count(List list) const {
    return static_cast<long long>(list == List::v ? obj_.v.size() : list == List::vt ? obj_.vt.size() : obj_.vn.size());
  }

  void no_such_index(std::string_view word, List list) {
    const std::string_view name = list == List::v ? "v" : list == List::vt ? "vt" : "vn";
    const std::string given = std::to_string(count(list));
    fault(word, std::string(name) + " index " + std::string(word.substr(0, 24)),
          count(list) == 0 ? "no " + std::string(name) + " index, since none is given"
                           : "1 to " + given + " or -1 to -" + given);
  }

  std::size_t offset_of(std::string_view part) const { return static_cast<std::size_t>(part.data() - text_.data()); }

  /// As the user sees it.
  TextPlace place_of(std::string_view part) {
    for (const std::size_t joint : joints_) text_[joint] = '\n'; // for a moment
    const TextPlace place = place_in(text_, offset_of(part));
    for (const std::size_t joint : joints_) text_[joint] = ' ';
    return place;
  }

  /// `where` is a part of the text.
  void fault(std::string_view where, std::string found, std::string expected) {
    faults_.add_from([&] {
      const TextPlace place = place_of(where);
      return InputFault{file_, place.line, place.column, "", std::move(found), std::move(expected)};
    });
  }

  /// One more of a kind; `found()` says what, for the first.
  template <class Found>
  void remark(ObjRemark kind, std::string_view where, const Found& found) {
    notes_.add(kind, [&] { return ObjNotes::First{place_of(where).line, found()}; });
  }

  static constexpr Float3 no_colour{-1.0f, -1.0f, -1.0f};
  static constexpr const char* finite_number = "a finite number in single precision";

  const std::string& file_;
  ObjText& obj_;
  std::string text_; // characters change, the size does not: views into it stay valid
  FaultList faults_;
  std::vector<Forward> forward_;
  std::vector<std::size_t> joints_;
  ObjNotes notes_;
  std::map<long long, NotFinite> not_finite_v_; // by their place in v; those that no face has used so far
  std::map<std::pair<bool, std::uint64_t>, std::int32_t> groups_; // by sign and size
  std::map<std::string, std::int32_t> names_;                     // of materials
  std::size_t statements_ = 0;                                    // with the present one
  std::size_t joints_before_ = 0; // of joints_, how many lie before the present statement
  std::int32_t smoothing_ = smoothing_off;
  std::size_t points_ = 0, lines_ = 0, free_forms_ = 0;
};

} // namespace

ObjText parse_obj(const std::string& file, std::string text, NoteList& notes) {
  ObjText result;
  ObjParser parser(file, std::move(text), result);
  parser.run();
  parser.notes().append_to(notes, file);
  return result;
}

} // namespace refraster
