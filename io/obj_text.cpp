#include "io/obj_text.h"

#include "io/fault_list.h"
#include "io/number_text.h"
#include "io/text.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

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

class ObjChecker {
public:
  ObjChecker(const std::string& file, ObjText& obj) : file_(file), obj_(obj), text_(obj.text) {}

  void run() {
    if (const std::size_t zero = text_.find('\0'); zero != std::string::npos) {
      fault(std::string_view(text_).substr(zero), "a zero byte", "text");
      return faults_.throw_if_any();
    }
    if (text_.starts_with("\xef\xbb\xbf")) blank(0, 3); // byte order mark
    mend_line_ends();
    for (std::size_t begin = 0, end = 0; begin < text_.size(); begin = end + 1) {
      end = std::min(text_.find('\n', begin), text_.size());
      if (const std::size_t comment = std::string_view(text_).substr(begin, end - begin).find('#');
          comment != std::string_view::npos)
        blank(begin + comment, end);
      if (!statement(std::string_view(text_).substr(begin, end - begin))) blank(begin, end);
    }
    for (const Forward& index : forward_)
      if (index.value > count(index.list)) no_such_index(index.word, index.list);
    if (obj_.smoothing.empty() && faults_.empty()) {
      InputFault none;
      none.file = file_;
      none.found = "no face";
      none.expected = "at least one statement f";
      faults_.add(none);
    }
    faults_.sort_by_place();
    faults_.throw_if_any();
  }

private:
  enum class List { v, vt, vn };

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

  /// '\r' alone ends a line, as tinyobjloader has it. A backslash at the end of a line that is no comment continues the
  /// line: both become blanks, and where the line ended is remembered for messages.
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

  /// False if it says nothing about the shape.
  bool statement(std::string_view line) {
    const std::string_view all = line, keyword = take_word(line);
    if (keyword == "v") numbers(obj_.v, line, all, 3, 7); // then may follow a weight, or a colour, or both
    else if (keyword == "vn") numbers(obj_.vn, line, all, 3, 3);
    else if (keyword == "vt") numbers(obj_.vt, line, all, 1, 3);
    else if (keyword == "f") face(line, all);
    else {
      if (keyword == "s") smoothing(take_word(line), all);
      return false;
    }
    return true;
  }

  /// Coordinates. Numbers beyond those that a point of the list has are checked, but not used.
  template <glm::length_t N>
  void numbers(std::vector<glm::vec<N, float, glm::defaultp>>& list, std::string_view rest, std::string_view all,
               std::size_t least, std::size_t most) {
    const std::size_t digits = static_cast<std::size_t>(rest.data() - text_.data()), size = rest.size();
    glm::vec<N, float, glm::defaultp> point(0.0f);
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
      float number = 0;
      if (read_number(word, number) != NumberText::good)
        fault(word, in_quotes(word), "a finite number in single precision");
      if (count < N) point[static_cast<glm::length_t>(count)] = number;
    }
    if (count < least || count > most)
      fault(all, counted(count, "number"),
            least == most ? counted(least, "number") : std::to_string(least) + " to " + counted(most, "number"));
    list.push_back(point);
    blank(digits, digits + size); // tinyobjloader need only count it
  }

  void smoothing(std::string_view word, std::string_view all) {
    int group = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, group);
    if (word == "off") smoothing_ = smoothing_off;
    else if (word == "on") smoothing_ = 1; // not in the specification, but written by some programs
    else if (error == std::errc() && stop == end && group >= 0) smoothing_ = group;
    else
      fault(word.empty() ? all : word, word.empty() ? "nothing" : in_quotes(word),
            "off, or the number of a smoothing group");
  }

  void face(std::string_view rest, std::string_view all) {
    std::size_t corners = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++corners) corner(word);
    if (corners < 3) fault(all, "a face with " + counted(corners, "corner"), "at least 3 corners");
    obj_.smoothing.push_back(smoothing_);
  }

  /// v, v/vt, v//vn or v/vt/vn.
  void corner(std::string_view word) {
    std::string_view rest = word;
    const auto slash = [&] {
      if (!rest.starts_with('/')) return false;
      rest.remove_prefix(1);
      return true;
    };
    bool sound = index(rest, List::v);
    if (sound && !rest.empty()) {
      sound = slash() && (rest.starts_with('/') || index(rest, List::vt));
      if (sound && !rest.empty()) sound = slash() && index(rest, List::vn) && rest.empty();
    }
    if (!sound) fault(word, in_quotes(word), "v, v/vt, v//vn or v/vt/vn");
  }

  /// Takes an integer off the front; false if there is none. One that points nowhere is a fault of its own.
  bool index(std::string_view& rest, List list) {
    long long value = 0;
    const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error == std::errc::invalid_argument) return false;
    const std::string_view word = rest.substr(0, static_cast<std::size_t>(stop - rest.data()));
    rest.remove_prefix(word.size());
    if (error == std::errc::result_out_of_range || value == 0 || value < -count(list)) no_such_index(word, list);
    else if (value > count(list)) forward_.push_back({word, value, list});
    return true;
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

  /// `where` is a part of the text.
  void fault(std::string_view where, std::string found, std::string expected) {
    faults_.add_from([&] {
      const auto offset = static_cast<std::size_t>(where.data() - text_.data());
      for (const std::size_t joint : joints_) text_[joint] = '\n'; // as the user sees it, for a moment
      const TextPlace place = place_in(text_, offset);
      for (const std::size_t joint : joints_) text_[joint] = ' ';
      return InputFault{file_, place.line, place.column, "", std::move(found), std::move(expected)};
    });
  }

  const std::string& file_;
  ObjText& obj_;
  std::string& text_; // characters change, the size does not: views into it stay valid
  FaultList faults_;
  std::vector<Forward> forward_;
  std::vector<std::size_t> joints_;
  int smoothing_ = no_smoothing_statement;
};

} // namespace

ObjText check_obj(const std::string& file, std::string text) {
  ObjText result;
  result.text = std::move(text);
  ObjChecker(file, result).run();
  return result;
}

} // namespace refraster
