#pragma once

#include "shading/fields.h"
#include "shading/fragment.h"
#include "shading/merl_table.h"

#include <memory>
#include <string_view>

namespace refraster {

/// How a MERL table is read between its samples. docs/merl.md shows what each is for.
enum class MerlLookup { nearest, trilinear, trilinear_edge };

/// How the half and difference angles are computed. All agree in exact arithmetic.
enum class MerlAngles { closed, rotation, frame };

template <>
struct EnumNames<MerlLookup> {
  static constexpr std::pair<MerlLookup, std::string_view> names[] = {
      {MerlLookup::nearest, "nearest"},
      {MerlLookup::trilinear, "trilinear"},
      {MerlLookup::trilinear_edge, "trilinear-edge"},
  };
};
template <>
struct EnumNames<MerlAngles> {
  static constexpr std::pair<MerlAngles, std::string_view> names[] = {
      {MerlAngles::closed, "closed"},
      {MerlAngles::rotation, "rotation"},
      {MerlAngles::frame, "frame"},
  };
};

/// Measured reflection: f(i = l, o = v) <n.l> C; 0 unless n.l > 0 and n.v > 0. No ambient term.
struct Merl {
  static constexpr std::string_view name = "merl";
  static constexpr std::string_view shader_stems[] = {"merl_fs", "merl"};

  std::shared_ptr<const MerlTable> table;
  MerlLookup lookup = MerlLookup::trilinear;
  MerlAngles angles = MerlAngles::closed;

  static void fields(auto& self, auto&& field) {
    field("merl_lookup", self.lookup, Range{}, "how the table is read between its samples");
    field("merl_angles", self.angles, Range{}, "how the half and difference angles are computed");
  }
};

} // namespace refraster
