#include "brdf/comparison.h"
#include "brdf/fit/channels.h"

#include "io/file/text.h"
#include "io/json/report_parts.h"

namespace refraster {
namespace {

std::string rgb_text(const Rgb<double>& rgb) {
  return format("%.4g %.4g %.4g", rgb.x, rgb.y, rgb.z);
}

void write_errors(JsonWriter& json, const BrdfErrors& errors) {
  json.member("pairs", errors.pairs);
  json.member("fraction", errors.fraction);
  json.member("rms", errors.rms);
  json.member("relative_rms", errors.relative_rms);
  json.member("cosine_rms", errors.cosine_rms);
  json.member("log_rms", errors.log_rms);
  json.member("cube_root_rms", errors.cube_root_rms);
  json.member("mean_difference", errors.mean_difference);
}

void write_worst(JsonWriter& json, const WorstPair& pair) {
  write_members(json, pair.half_difference);
  write_members(json, pair.in_out);
  json.member("a", channels_of(pair.a));
  json.member("b", channels_of(pair.b));
  json.member("log_error", pair.log_error);
}

} // namespace

std::string comparison_text(const BrdfComparisonReport& report) {
  const BrdfComparison& found = report.found;
  std::string text = "a  " + report.a.label() + "\nb  " + report.b.label() + "\n";
  if (found.unknown > 0) text += counted(found.unknown, "pair") + " that one of the two does not know\n";
  if (found.equal) return text + "equal in all " + counted(found.of(BrdfRegion::all).pairs, "pair") + "\n";
  text += format("%-10s %7s %11s %10s %11s %10s %10s %11s\n", "region", "pairs", "RMS f, 1/sr", "relative",
                 "cosine RMS", "log RMS", "cube root", "mean b - a");
  for (const RegionWords& words : brdf_regions) {
    const BrdfErrors& e = found.of(words.region);
    text +=
        format("%-10s %6.2f%% %11.4g %10.4g %11.4g %10.4g %10.4g %+11.3g\n", std::string(words.name).c_str(),
               100 * e.fraction, e.rms, e.relative_rms, e.cosine_rms, e.log_rms, e.cube_root_rms, e.mean_difference);
  }
  text += "worst, by |ln(1 + b cos) - ln(1 + a cos)|; angles in degrees, f in 1/sr\n";
  text += format("%7s %7s %6s   %7s %7s %7s   %-26s %-26s %s\n", "theta_h", "theta_d", "phi_d", "in", "out", "dphi",
                 "a", "b", "error");
  for (const WorstPair& pair : found.worst)
    text +=
        format("%7.2f %7.2f %6.1f   %7.2f %7.2f %7.2f   %-26s %-26s %.3g\n", pair.half_difference.theta_h,
               pair.half_difference.theta_d, pair.half_difference.phi_d, pair.in_out.theta_in, pair.in_out.theta_out,
               pair.in_out.dphi, rgb_text(pair.a).c_str(), rgb_text(pair.b).c_str(), pair.log_error);
  return text;
}

std::string comparison_json(const BrdfComparisonReport& report) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("a", report.a.label());
    json.member("b", report.b.label());
    json.member("same", is_within(report.limits, report.found));
    json.object("limits", [&] {
      json.member("max_rms", report.limits.max_rms);
      json.member("max_cosine_rms", report.limits.max_cosine_rms);
      json.member("max_log_rms", report.limits.max_log_rms);
      json.member("max_cube_root_rms", report.limits.max_cube_root_rms);
    });
    json.member("equal", report.found.equal);
    json.member("unknown", report.found.unknown);
    json.object("regions", [&] {
      for (const RegionWords& words : brdf_regions)
        json.object(words.name, [&] { write_errors(json, report.found.of(words.region)); });
    });
    json.array("worst", [&] {
      for (const WorstPair& pair : report.found.worst) json.object([&] { write_worst(json, pair); });
    });
  });
  return json.text();
}

} // namespace refraster
