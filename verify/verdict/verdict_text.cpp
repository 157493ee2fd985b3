#include "verify/report_text.h"
#include "verify/verdict/rank_request.h"
#include "verify/verdict/verdict_report.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace refraster {
namespace {

/// Clusters and pixels that are listed.
constexpr std::size_t max_shown_clusters = 6;

std::string percent(double share) {
  return rounded_text(100 * share, 3) + " %";
}

std::string values_text(const Double3& levels) {
  return rounded_text(levels.x, 4) + " " + rounded_text(levels.y, 4) + " " + rounded_text(levels.z, 4);
}

std::string allowed_text(const ColourBox& box) {
  std::string text;
  for (int c = 0; c < 3; ++c)
    text += (c > 0 ? ", " : "") + rounded_text(box.lo[c], 4) + " to " + rounded_text(box.hi[c], 4);
  return text;
}

std::string clusters_text(const Verdict& verdict) {
  std::string text;
  for (std::size_t i = 0; i < std::min(verdict.clusters.size(), max_shown_clusters); ++i) {
    const Cluster& c = verdict.clusters[i].where;
    const std::string pixels = c.pixels == 1 ? "1 pixel" : std::to_string(c.pixels) + " pixels";
    text +=
        report_line(i == 0 ? "clusters" : "", format("%s of %s in x %d to %d, y %d to %d; worst at (%d, %d)",
                                                     pixels.c_str(), verdict.clusters[i].object.c_str(), c.x,
                                                     c.x + c.width - 1, c.y, c.y + c.height - 1, c.worst_x, c.worst_y));
    const auto worst = std::find_if(verdict.details.begin(), verdict.details.end(),
                                    [&](const JudgedDetail& d) { return d.x == c.worst_x && d.y == c.worst_y; });
    if (worst == verdict.details.end()) continue;
    if (worst->objection == Objection::surface) {
      text += report_line("", "    shows a triangle that cannot be seen there");
      continue;
    }
    if (worst->objection == Objection::depth) {
      text += report_line("", "    the depth is none that this surface may have there");
      continue;
    }
    text += report_line("", "    shows " + values_text(worst->actual) + ", reference " + values_text(worst->reference) +
                                ", allowed " + allowed_text(worst->allowed) +
                                (worst->surfaces > 1 ? " of that surface, and what " +
                                                           std::to_string(worst->surfaces - 1) + " more may show"
                                                     : ""));
  }
  if (verdict.clusters.size() > max_shown_clusters)
    text += report_line("", format("and %zu more", verdict.clusters.size() - max_shown_clusters));
  return text;
}

/// The likely cause, or that there is none.
std::string hypotheses_text(const VerdictReport& report) {
  if (!report.ranking) return {};
  const hypotheses::Ranking& ranking = *report.ranking;
  if (ranking.causes.empty() || !ranking.named())
    return report_line("cause",
                       "none of " + std::to_string(ranking.tried) + " hypotheses explains more than half of them");
  constexpr std::size_t max_causes = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(report.cause_sentences.size(), max_causes); ++i) {
    if (ranking.causes[i].score() < ranking.causes[0].score() / 4) break; // no rival
    text += report_line(i == 0 ? "cause" : "or", report.cause_sentences[i]);
  }
  return text;
}

std::string causes_text(const CauseShares& shares) {
  std::vector<std::pair<double, std::string_view>> sorted;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] >= 0.005) sorted.emplace_back(shares[i], bound_cause_names[i]);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [share, name] : sorted)
    text += (text.empty() ? "" : ", ") + std::string(name) + " " + rounded_text(std::round(100 * share), 3) + " %";
  return text;
}

} // namespace

std::vector<ClassLimit> VerdictReport::exceeded() const {
  std::vector<ClassLimit> all = limits;
  if (std::none_of(all.begin(), all.end(),
                   [](const ClassLimit& limit) { return limit.pixel_class == PixelClass::unexplained; }))
    all.push_back({});
  std::erase_if(all, [&](const ClassLimit& limit) { return verdict.count(limit.pixel_class) <= limit.most; });
  return all;
}

std::string verdict_headline(const VerdictReport& report) {
  const Verdict& verdict = report.verdict;
  const auto pixels = static_cast<unsigned long long>(verdict.classes.values.size());
  const std::string device = report.profile.name;
  if (const std::uint64_t wrong = verdict.count(PixelClass::unexplained); wrong > 0)
    return format("unexplained: %llu of %llu pixels are not what a device such as %s may show",
                  static_cast<unsigned long long>(wrong), pixels, device.c_str());
  if (!report.passes()) return "explained, but over a limit";
  return "explained: each pixel is what a device such as " + device + " may show";
}

std::string power_text(const JudgePower& power) {
  if (power.pixels == 0) return {};
  return "colours that pass are less than 0.1 levels apart in " + percent(power.below_tenth) + ", 1 level in " +
         percent(power.below_one) + ", 4 levels in " + percent(power.below_four) + " of the pixels; " +
         rounded_text(power.median, 3) + " in the median";
}

void rank_causes(VerdictReport& report, const Scene& scene, const DeviceImage& image) {
  if (report.verdict.is_explained()) return;
  Image<float> values;
  report.ranking =
      rank_hypotheses(hypotheses::rank_request(scene, image, report.profile, report.options, report.verdict, values));
  for (const hypotheses::Cause& cause : report.ranking->causes)
    report.cause_sentences.push_back(hypotheses::sentence(cause, *report.ranking, scene));
}

std::string verdict_text(const VerdictReport& report) {
  const Verdict& verdict = report.verdict;
  std::string text = verdict_headline(report) + "\n";
  text += report_line("scene", report.scene);
  text += report_line("image", report.actual);
  text += report_line("device", report.profile.name + ", version " + std::to_string(report.profile.version) +
                                    ": refraster list devices");
  text += report_line("size", format("%d x %d", verdict.width, verdict.height) +
                                  (report.options.samples > 1 ? format(", %d samples a pixel", report.options.samples)
                                                              : std::string()));
  for (const auto& [label, content] : report.provenance) text += report_line(label, content);
  const std::uint64_t pixels = verdict.classes.values.size();
  for (const auto& [pixel_class, name] : EnumNames<PixelClass>::names)
    if (verdict.count(pixel_class) > 0 || pixel_class == PixelClass::exact || pixel_class == PixelClass::unexplained)
      text += report_line(std::string(name), share_text(verdict.count(pixel_class), pixels));
  text += hypotheses_text(report);
  text += clusters_text(verdict);
  for (const ClassLimit& limit : report.exceeded())
    if (limit.pixel_class != PixelClass::unexplained || limit.most > 0)
      text += report_line("over a limit", format("%llu %s pixels, at most %llu may be",
                                                 static_cast<unsigned long long>(verdict.count(limit.pixel_class)),
                                                 std::string(name_of(limit.pixel_class)).c_str(),
                                                 static_cast<unsigned long long>(limit.most)));
  for (const ObjectBias& bias : verdict.biases)
    if (bias.is_biased())
      text += report_line("drift",
                          format("object %zu: %s of its values are stored as another level, at most %s by chance",
                                 bias.object + 1, percent(bias.moved).c_str(), percent(bias.allowed_moved).c_str()));
  if (verdict.power.pixels > 0) {
    const JudgePower& power = verdict.power;
    text +=
        report_line("power", "colours that pass are less than 0.1 levels apart in " + percent(power.below_tenth) + ",");
    text += report_line("", "1 level in " + percent(power.below_one) + ", 4 levels in " + percent(power.below_four) +
                                " of the pixels; " + rounded_text(power.median, 3) + " in the median");
    if (const std::string causes = causes_text(verdict.causes); !causes.empty())
      text += report_line("because of", causes);
  }
  return text;
}

} // namespace refraster
