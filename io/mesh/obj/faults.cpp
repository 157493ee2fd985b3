#include "io/mesh/obj/faults.h"

namespace refraster {

void ObjFaults::add(std::string_view where, std::string found, std::string expected) {
  faults_.add_from([&] {
    const TextPlace place = lines_.place_of(where);
    return InputFault{file_, place.line, place.column, "", std::move(found), std::move(expected)};
  });
}

void ObjFaults::not_finite_v(std::size_t v, std::string_view word) {
  not_finite_v_.emplace(static_cast<long long>(v), NotFinite{word, in_quotes(word)});
}

void ObjFaults::index(ObjList list, std::string_view word, long long value, bool out_of_range, std::size_t given) {
  const auto count = static_cast<long long>(given);
  const long long at = value < 0 ? count + value : value - 1;
  if (out_of_range || value == 0 || at < 0) return no_such_index(word, list, given);
  if (at >= count) forward_.push_back({word, value, list});
  else if (list == ObjList::v) use(at);
}

void ObjFaults::finish(const ObjChunk& whole, const std::string& instead) {
  for (const Forward& index : forward_) {
    const std::size_t given = index.list == ObjList::v    ? whole.v.size()
                              : index.list == ObjList::vt ? whole.vt.size()
                                                          : whole.vn.size();
    if (index.value > static_cast<long long>(given)) no_such_index(index.word, index.list, given);
    else if (index.list == ObjList::v) use(index.value - 1);
  }
  if (!instead.empty() && faults_.empty()) faults_.add({file_, 0, 0, "", instead, "at least one face (a statement f)"});
  faults_.sort_by_place();
  faults_.throw_if_any();
}

/// A face uses this v, counted from 0.
void ObjFaults::use(long long v) {
  const auto found = not_finite_v_.find(v);
  if (found == not_finite_v_.end()) return;
  add(found->second.where, found->second.word, finite_number);
  not_finite_v_.erase(found);
}

void ObjFaults::no_such_index(std::string_view word, ObjList list, std::size_t given) {
  const std::string name = list == ObjList::v ? "v" : list == ObjList::vt ? "vt" : "vn";
  const std::string count = std::to_string(given);
  add(word, name + " index " + std::string(word.substr(0, 24)),
      given == 0 ? "no " + name + " index, since none is given" : "1 to " + count + " or -1 to -" + count);
}

} // namespace refraster
