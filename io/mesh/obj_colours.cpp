#include "io/mesh/obj_colours.h"

#include "io/file/text.h"
#include "io/mesh/obj_numbers.h"
#include "shading/srgb_curve.h"

#include <algorithm>
#include <cstdint>

namespace refraster {
namespace {

constexpr float of_no_colour = -1; // ObjText::colours

bool has_colour(const Float3& colour) {
  return colour != Float3(of_no_colour);
}

/// What stands in the file is one of these. Whole bytes are what scanners write; a file in which no colour exceeds 1
/// says nothing else than it would in the range 0 to 1.
bool is_of_bytes(const ObjText& obj) {
  return std::any_of(obj.colours.begin(), obj.colours.end(),
                     [](const Float3& c) { return c.x > 1 || c.y > 1 || c.z > 1; });
}

/// Which colours are no colours.
struct Odd {
  std::uint64_t not_finite = 0, negative = 0;
};

void note(const std::string& path, NoteList& notes, std::uint64_t count, std::string_view what,
          std::string_view consequence) {
  if (count > 0) notes.add({path, 0, counted(count, "vertex colour") + std::string(what), std::string(consequence)});
}

} // namespace

std::vector<Float3> vertex_colours(const std::string& path, const ObjText& obj,
                                   std::span<const TripleIndex::Triple> vertices, VertexColours taken_as,
                                   NoteList& notes) {
  if (obj.colours.empty() || taken_as == VertexColours::ignored) return {};
  const bool of_bytes = is_of_bytes(obj);
  if (of_bytes) notes.add({path, 0, "vertex colours above 1", "all are taken as from 0 to 255"});
  Odd odd;
  std::vector<Float3> of_v(obj.colours.size(), Float3(1));
  for (std::size_t v = 0; v < of_v.size(); ++v) {
    const Float3& given = obj.colours[v];
    if (!has_colour(given)) continue;
    if (!is_finite(given)) {
      ++odd.not_finite;
      continue;
    }
    odd.negative += given.x < 0 || given.y < 0 || given.z < 0;
    for (int c = 0; c < 3; ++c) {
      const double value = std::max(0.0, static_cast<double>(given[c])) / (of_bytes ? 255 : 1);
      of_v[v][c] = static_cast<float>(taken_as == VertexColours::srgb ? srgb_decoded(value) : value);
    }
  }
  note(path, notes, odd.not_finite, " with a number that is not finite", "taken as white");
  note(path, notes, odd.negative, " below 0", "taken as 0 there");
  std::vector<Float3> colours;
  colours.reserve(vertices.size());
  for (const auto& vertex : vertices) colours.push_back(of_v[static_cast<std::size_t>(vertex[0])]);
  return colours;
}

} // namespace refraster
