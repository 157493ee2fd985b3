#pragma once
// What is wrong with an OBJ file, told by line and column: the whole text is read again for it, in one go.

#include "io/file/fault_list.h"
#include "io/file/text.h"
#include "io/mesh/obj/chunk.h"
#include "io/mesh/obj/lines.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

inline constexpr const char* finite_number = "a finite number in single precision";

class ObjFaults {
public:
  ObjFaults(const std::string& file, ObjLines& lines) : file_(file), lines_(lines) {}

  /// `where` is a part of the text.
  void add(std::string_view where, std::string found, std::string expected);

  /// The next v has a coordinate that is not finite: a fault if a face uses it.
  void not_finite_v(std::size_t v, std::string_view word);

  /// An index of a face, word and value; out of range if it does not fit. `given`: of each list, what the text has so
  /// far. One that points nowhere is a fault; one to a point that may still be given, finish() decides on.
  void index(ObjList list, std::string_view word, long long value, bool out_of_range, std::size_t given);

  /// At the end of the text, which has no face if `instead` says what there is. Throws InputError with all faults.
  void finish(const ObjChunk& whole, const std::string& instead);

private:
  /// Where a v has a coordinate that is not finite.
  struct NotFinite {
    std::string_view where;
    std::string word; // in quotes
  };

  /// An index to what had not been given yet where it was met.
  struct Forward {
    std::string_view word;
    long long value;
    ObjList list;
  };

  void use(long long v);
  void no_such_index(std::string_view word, ObjList list, std::size_t given);

  const std::string& file_;
  ObjLines& lines_;
  FaultList faults_;
  std::vector<Forward> forward_;
  std::map<long long, NotFinite> not_finite_v_; // by their place in v; those that no face has used so far
};

} // namespace refraster
