#include "brdf/brdf.h"

#include "shading/merl_lookup.h"

namespace refraster {

BrdfValue Brdf::value(const DirectionPair& at) const {
  if (!(at.i.z > 0 && at.o.z > 0)) return {Rgb<double>(0), false};
  if (const Merl* const merl = table()) {
    const MerlValue<double> read =
        merl_value(*merl->table, merl->lookup, merl_point(half_difference(merl->angles, Double3(0, 0, 1), at.i, at.o)));
    return {read.f, !read.unmeasured};
  }
  Rgb<double> sum(0);
  for (const BrdfModel& lobe : *lobes()) sum += model_value(lobe, at);
  return {sum, true};
}

} // namespace refraster
