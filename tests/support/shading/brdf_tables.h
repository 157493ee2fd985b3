#pragma once
// Tables of formulas, as the commands of `refraster brdf` have them.

#include "brdf/brdf.h"

#include <memory>
#include <string>

namespace refraster::test {

inline Brdf table_brdf(std::shared_ptr<const MerlTable> table, std::string label = "table") {
  Merl merl;
  merl.table = std::move(table);
  return {std::move(label), std::move(merl)};
}

/// The table of f(n, i, o).
template <class Formula>
Brdf table_brdf_from(const Formula& formula, std::string label = "table") {
  return table_brdf(std::shared_ptr<const MerlTable>(new MerlTable(merl_table_from(formula))), std::move(label));
}

} // namespace refraster::test
