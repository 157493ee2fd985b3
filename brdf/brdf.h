#pragma once
// A reflectance to look into: a table, or models that add up.

#include "brdf/angles.h"
#include "brdf/model.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace refraster {

/// f of a pair of directions.
struct BrdfValue {
  Rgb<double> f{0};     // 1/sr, without cosine; 0 where it is not known
  bool measured = true; // false where a table has no sample around, and where a direction is not above the surface
};

/// Luminance of linear red, green and blue: ITU-R BT.709.
inline double luminance(const Rgb<double>& rgb) {
  return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

/// Immutable; for several threads at once.
class Brdf {
public:
  /// label: as the user named it, in reports.
  Brdf(std::string label, Merl table) : label_(std::move(label)), source_(std::move(table)) {}
  Brdf(std::string label, std::vector<BrdfModel> lobes) : label_(std::move(label)), source_(std::move(lobes)) {}

  const std::string& label() const { return label_; }
  /// Null if it is no table.
  const Merl* table() const { return std::get_if<Merl>(&source_); }
  /// Null if it is a table.
  const std::vector<BrdfModel>* lobes() const { return std::get_if<std::vector<BrdfModel>>(&source_); }

  /// Of unit vectors over a surface with normal (0, 0, 1).
  BrdfValue value(const DirectionPair& at) const;

private:
  std::string label_;
  std::variant<Merl, std::vector<BrdfModel>> source_;
};

} // namespace refraster
