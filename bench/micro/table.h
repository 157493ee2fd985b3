#pragma once

#include "scenes/synthesis/merl_synthesis.h"

#include <memory>

namespace refraster::micro {

/// A measured BRDF's table, made when it is first asked for.
inline std::shared_ptr<const MerlTable> synthetic_table() {
  static const std::shared_ptr<const MerlTable> table(
      new MerlTable(merl_table_from(find_brdf_preset("nylon-like")->brdf)));
  return table;
}

} // namespace refraster::micro
