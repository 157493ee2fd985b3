#include "io/mesh/obj_notes.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace refraster {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(ObjRemark::count_)> consequences = {
    "skipped: no face uses it",
    "taken as no normal",
    "taken as no texture coordinate",
    "read without its empty part",
    "read as it stands: without vt at all corners no texture, without vn a computed normal",
    "read as f",
    "skipped: points and lines are not drawn",
    "skipped: free-form curves and surfaces are not drawn",
    "read as \"s off\"",
    "read as \"s 1\"",
    "read as a group of its own",
    "skipped: textures are those of the materials",
    "skipped: no other file is read, and no command run",
    "skipped: the format has no such statement",
};

// Appendix B1 of the Advanced Visualizer manual, version 4.2, with the statements that version 3.0 had. Those of
// free-form geometry that only belong to a curv, curv2 or surf are harmless: that one is noted.
constexpr std::pair<std::string_view, ObjKeyword> keywords[] = {
    {"v", ObjKeyword::shape},
    {"vt", ObjKeyword::shape},
    {"vn", ObjKeyword::shape},
    {"f", ObjKeyword::shape},
    {"fo", ObjKeyword::shape},
    {"s", ObjKeyword::shape},
    {"usemtl", ObjKeyword::harmless}, // read, but no part of the shape
    {"mtllib", ObjKeyword::harmless},
    {"usemap", ObjKeyword::materials},
    {"maplib", ObjKeyword::materials},
    {"g", ObjKeyword::harmless},
    {"o", ObjKeyword::harmless},
    {"p", ObjKeyword::points_and_lines},
    {"l", ObjKeyword::points_and_lines},
    {"curv", ObjKeyword::free_form},
    {"curv2", ObjKeyword::free_form},
    {"surf", ObjKeyword::free_form},
    {"bsp", ObjKeyword::free_form}, // patches and curves of version 2
    {"bzp", ObjKeyword::free_form},
    {"cdc", ObjKeyword::free_form},
    {"cdp", ObjKeyword::free_form},
    {"vp", ObjKeyword::harmless},
    {"cstype", ObjKeyword::harmless},
    {"deg", ObjKeyword::harmless},
    {"bmat", ObjKeyword::harmless},
    {"step", ObjKeyword::harmless},
    {"parm", ObjKeyword::harmless},
    {"trim", ObjKeyword::harmless},
    {"hole", ObjKeyword::harmless},
    {"scrv", ObjKeyword::harmless},
    {"sp", ObjKeyword::harmless},
    {"end", ObjKeyword::harmless},
    {"con", ObjKeyword::harmless},
    {"mg", ObjKeyword::harmless},
    {"bevel", ObjKeyword::harmless}, // how the Advanced Visualizer displays what is there
    {"c_interp", ObjKeyword::harmless},
    {"d_interp", ObjKeyword::harmless},
    {"lod", ObjKeyword::harmless},
    {"shadow_obj", ObjKeyword::harmless},
    {"trace_obj", ObjKeyword::harmless},
    {"ctech", ObjKeyword::harmless},
    {"stech", ObjKeyword::harmless},
    {"res", ObjKeyword::harmless},
    {"call", ObjKeyword::other_files},
    {"csh", ObjKeyword::other_files},
};

} // namespace

void ObjNotes::add(const ObjNotes& later) {
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
    if (kinds_[kind].count == 0) kinds_[kind].first = later.kinds_[kind].first;
    kinds_[kind].count += later.kinds_[kind].count;
  }
}

void ObjNotes::append_to(NoteList& notes, const std::string& file,
                         const std::function<int(std::string_view)>& line_of) const {
  struct Met {
    std::size_t kind;
    int line;
  };
  std::vector<Met> met;
  for (std::size_t kind = 0; kind < kinds_.size(); ++kind)
    if (kinds_[kind].count > 0) met.push_back({kind, line_of(kinds_[kind].first.where)});
  std::stable_sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.line < b.line; });
  for (const auto& [kind, line] : met)
    notes.add({file, line, kinds_[kind].first.found, std::string(consequences[kind]), kinds_[kind].count});
}

ObjKeyword obj_keyword(std::string_view word) {
  for (const auto& [listed, keyword] : keywords)
    if (word == listed) return keyword;
  return ObjKeyword::unknown;
}

} // namespace refraster
