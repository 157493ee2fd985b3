#include "verify/compare/compare_report.h"

#include "io/file/text.h"
#include "io/json/report_parts.h"
#include "verify/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace refraster {
namespace {

/// Nine digits tell any two floats apart. Levels are integers, or follow from values of single precision, whose
/// rounding seven digits do not show.
std::string values_text(const std::vector<double>& values, CompareUnit unit) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ' ';
    text += rounded_text(value, unit == CompareUnit::levels ? 7 : 9);
  }
  return text;
}

/// "1 level", "0.5 levels", "0.004" of values, which have no name.
std::string with_unit(double x, CompareUnit unit) {
  return rounded_text(x) + (unit == CompareUnit::values ? "" : x == 1 ? " level" : " levels");
}

std::string limits_text(const CompareLimits& limits, CompareUnit unit) {
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += (text.empty() ? "" : ", ") + std::string(name) + " " + value;
  };
  if (limits.max_abs) add("max-abs", with_unit(*limits.max_abs, unit));
  if (limits.max_rms) add("max-rms", with_unit(*limits.max_rms, unit));
  if (limits.max_count) add("max-count", std::to_string(*limits.max_count));
  return text;
}

std::string cause_text(const ComparisonReport& report) {
  std::string text;
  for (const std::string& cause : comparison_causes(report)) text += report_line(text.empty() ? "cause" : "", cause);
  return text;
}

void write_transformation(JsonWriter& json, const ComparisonReport& report) {
  json.key("transformation");
  if (!report.transformation) return json.null();
  const FoundTransformation& t = *report.transformation;
  const double in_unit = full_range(report.found.unit) / 255;
  json.object([&] {
    json.member("name", known(t.which).name);
    json.member("text", transformation_text(t, report.found.unit));
    json.member("factor", t.factor);
    json.member("shift", std::vector<int>{t.x, t.y});
    json.member("pixels", t.pixels);
    json.member("within", t.within);
    json.member("equal_within", t.equal_within * in_unit);
    json.member("max", t.max * in_unit);
    json.member("rms", t.rms * in_unit);
  });
}

std::string worst_table(const std::vector<PixelDifference>& worst, CompareUnit unit) {
  std::vector<std::string> places, as, bs;
  for (const PixelDifference& pixel : worst) {
    places.push_back(format("(%d, %d)", pixel.x, pixel.y));
    as.push_back(values_text(pixel.a, unit));
    bs.push_back(values_text(pixel.b, unit));
  }
  const auto width = [](const std::vector<std::string>& column, std::size_t least) {
    for (const std::string& cell : column) least = std::max(least, cell.size());
    return static_cast<int>(least);
  };
  const int place_width = width(places, 6), a_width = width(as, 1), b_width = width(bs, 1);
  std::string text =
      format("worst pixels   %-*s  %-*s  %-*s  %s\n", place_width, "(x, y)", a_width, "a", b_width, "b", "difference");
  for (std::size_t i = 0; i < worst.size(); ++i)
    text +=
        format("               %-*s  %-*s  %-*s  %s\n", place_width, places[i].c_str(), a_width, as[i].c_str(), b_width,
               bs[i].c_str(), std::isfinite(worst[i].difference) ? rounded_text(worst[i].difference).c_str() : "none");
  return text;
}

/// "knot 1200, background 34"; of one object only its name.
std::string objects_text(const ObjectCounts& objects) {
  std::string text;
  for (const auto& [name, pixels] : objects)
    text += (text.empty() ? "" : ", ") + one_line(name) + (objects.size() == 1 ? "" : " " + std::to_string(pixels));
  return text;
}

/// Pixels that stand alone are among the worst pixels, or not worth a line.
std::string clusters_table(const ComparisonReport& report) {
  const Comparison& found = report.found;
  std::string text = report_line("clusters", format("%llu", static_cast<unsigned long long>(found.cluster_count)) +
                                                 (found.clusters.front().pixels == 1 ? ", each of one pixel" : ""));
  for (std::size_t i = 0; i < found.clusters.size(); ++i) {
    const Cluster& c = found.clusters[i];
    if (c.pixels == 1) continue;
    const std::string worst = std::isfinite(c.largest) ? rounded_text(c.largest) : "none";
    text += report_line("", format("%llu pixels in x %d to %d, y %d to %d; worst at (%d, %d): %s",
                                   static_cast<unsigned long long>(c.pixels), c.x, c.x + c.width - 1, c.y,
                                   c.y + c.height - 1, c.worst_x, c.worst_y, worst.c_str()));
    if (i < report.objects.size()) text += report_line("", "  of " + objects_text(report.objects[i]));
  }
  return text;
}

void write_objects(JsonWriter& json, const ObjectCounts& objects) {
  json.array([&] {
    for (const auto& object : objects) {
      json.object([&] {
        json.member("name", object.first);
        json.member("pixels", object.second);
      });
    }
  });
}

void write_clusters(JsonWriter& json, const ComparisonReport& report) {
  const Comparison& found = report.found;
  json.member("cluster_count", found.cluster_count);
  json.array("clusters", [&] {
    for (std::size_t i = 0; i < found.clusters.size(); ++i) {
      const Cluster& c = found.clusters[i];
      json.object([&] {
        json.member("box", std::vector<int>{c.x, c.y, c.width, c.height});
        json.member("pixels", c.pixels);
        json.member("largest", c.largest);
        json.member("worst", std::vector<int>{c.worst_x, c.worst_y});
        json.key("objects");
        if (i < report.objects.size()) write_objects(json, report.objects[i]);
        else json.null();
      });
    }
  });
}

} // namespace

std::string comparison_verdict(const ComparisonReport& report) {
  const Comparison& found = report.found;
  if (found.equal_pixels == found.pixels()) return "equal";
  if (found.same) return "equal within " + limits_text(report.limits, found.unit);
  if (report.limits.any()) return "differ by more than " + limits_text(report.limits, found.unit);
  return "differ";
}

std::vector<std::string> comparison_causes(const ComparisonReport& report) {
  std::vector<std::string> causes;
  if (report.transformation) {
    const FoundTransformation& t = *report.transformation;
    const double in_unit = full_range(report.found.unit) / 255;
    const std::string max = std::isfinite(t.max) ? rounded_text(t.max * in_unit) : "none";
    causes.push_back(transformation_text(t, report.found.unit));
    causes.push_back("then max " + max + ", rms " + rounded_text(t.rms * in_unit) + ", " +
                     format("%llu of %llu pixels equal within the limit and rounding",
                            static_cast<unsigned long long>(t.within), static_cast<unsigned long long>(t.pixels)));
  }
  if (report.compressed != Compressed::none)
    causes.push_back(std::string("differences follow 8 x 8 blocks: ") +
                     (report.compressed == Compressed::a ? "a" : "b") + " was compressed with loss, as JPEG does it");
  return causes;
}

std::string comparison_text(const ComparisonReport& report) {
  const Comparison& found = report.found;
  std::string text = comparison_verdict(report) + "\n" + cause_text(report);
  text += report_line("a", report.file_a);
  text += report_line("b", report.file_b);
  text += report_line("size", format("%d x %d, %d channel%s, compared in %s", found.width, found.height, found.channels,
                                     found.channels == 1 ? "" : "s",
                                     found.unit == CompareUnit::levels ? "levels (1/255)" : "values"));
  if (found.incomparable_pixels > 0) {
    text += report_line("NaN, infinite", share_text(found.incomparable_pixels, found.pixels()));
    text += report_line("  NaN in a, b", format("%llu, %llu", static_cast<unsigned long long>(found.nan_pixels_a),
                                                static_cast<unsigned long long>(found.nan_pixels_b)));
  }
  text += report_line("equal pixels", share_text(found.equal_pixels, found.pixels()));
  if (found.equal_pixels == found.pixels()) return text;
  if (found.zero_sign_pixels > 0)
    text += report_line("only 0 and -0", share_text(found.zero_sign_pixels, found.pixels()));
  text += report_line(("over " + rounded_text(report.limits.max_abs.value_or(0))).c_str(),
                      share_text(found.pixels_over, found.pixels()));
  text += report_line("max", rounded_text(found.max));
  text += report_line("rms", rounded_text(found.rms));
  text += report_line("psnr", std::isfinite(found.psnr_db) ? format("%.2f dB", found.psnr_db) : "infinite");
  std::string means;
  for (const double mean : found.mean) means += format("%s%+.3g", means.empty() ? "" : "  ", mean);
  text += report_line("mean of b - a", means);
  if (report.mean_flip) text += report_line("flip", format("%.6f", *report.mean_flip));
  if (!found.worst.empty()) text += worst_table(found.worst, found.unit);
  if (found.cluster_count > 0) text += clusters_table(report);
  return text;
}

std::string comparison_json(const ComparisonReport& report) {
  const Comparison& found = report.found;
  JsonWriter json;
  json.object([&] {
    json.member("a", report.file_a);
    json.member("b", report.file_b);
    json.text_or_null("scene", report.scene);
    json.member("same", found.same);
    json.member("unit", unit_name(found.unit));
    write_size(json, found.width, found.height);
    json.member("channels", found.channels);
    json.object("limits", [&] {
      json.member("max_abs", report.limits.max_abs);
      json.member("max_rms", report.limits.max_rms);
      json.member("max_count", report.limits.max_count);
    });
    json.object("pixels", [&] {
      json.member("all", found.pixels());
      json.member("incomparable", found.incomparable_pixels);
      json.member("nan_in_a", found.nan_pixels_a);
      json.member("nan_in_b", found.nan_pixels_b);
      json.member("equal", found.equal_pixels);
      json.member("differ_in_sign_of_zero", found.zero_sign_pixels);
      json.member("over_max_abs", found.pixels_over);
    });
    json.member("max", found.max);
    json.member("rms", found.rms);
    json.member("psnr_db", found.psnr_db);
    json.member("mean", found.mean);
    json.member("mean_flip", report.mean_flip);
    json.array("worst", [&] {
      for (const PixelDifference& pixel : found.worst) {
        json.object([&] {
          json.member("x", pixel.x);
          json.member("y", pixel.y);
          json.member("difference", pixel.difference);
          json.member("a", pixel.a);
          json.member("b", pixel.b);
        });
      }
    });
    write_clusters(json, report);
    write_transformation(json, report);
    json.key("compressed");
    if (report.compressed == Compressed::none) json.null();
    else json.value(report.compressed == Compressed::a ? "a" : "b");
    json.array("notes", [&] {
      for (const Note& note : report.notes.notes()) json.value(note.text());
    });
  });
  return json.text();
}

} // namespace refraster
