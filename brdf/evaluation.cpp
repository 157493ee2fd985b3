#include "brdf/evaluation.h"

#include "io/file/text.h"
#include "io/json/report_parts.h"

namespace refraster {
namespace {

struct EvaluatedPair {
  InOutAngles in_out;
  HalfDifferenceAngles half_difference;
  BrdfValue value;
};

EvaluatedPair evaluated(const Brdf& brdf, const DirectionPair& pair) {
  EvaluatedPair result{in_out_angles(pair), half_difference_angles(pair), brdf.value(pair)};
  // Below the surface nothing is reflected: that is known, and no gap of a table.
  if (!(pair.i.z > 0 && pair.o.z > 0)) result.value.measured = true;
  return result;
}

} // namespace

std::string evaluation_csv(const Brdf& brdf, std::span<const DirectionPair> pairs) {
  std::string text = "theta_in,theta_out,dphi,theta_h,theta_d,phi_d,r,g,b\n";
  for (const DirectionPair& pair : pairs) {
    const auto [in_out, half_difference, value] = evaluated(brdf, pair);
    text += format("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", in_out.theta_in, in_out.theta_out, in_out.dphi,
                   half_difference.theta_h, half_difference.theta_d, half_difference.phi_d);
    text += value.measured ? format(",%.17g,%.17g,%.17g\n", value.f.x, value.f.y, value.f.z) : ",nan,nan,nan\n";
  }
  return text;
}

std::string evaluation_json(const Brdf& brdf, std::span<const DirectionPair> pairs) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("brdf", brdf.label());
    json.array("points", [&] {
      for (const DirectionPair& pair : pairs) {
        const EvaluatedPair point = evaluated(brdf, pair);
        json.object([&] {
          write_members(json, point.in_out);
          write_members(json, point.half_difference);
          json.optional("f", point.value.measured ? &point.value.f : nullptr, [&](const Rgb<double>& f) {
            json.value(std::vector<double>{f.x, f.y, f.z});
          });
        });
      }
    });
  });
  return json.text();
}

} // namespace refraster
