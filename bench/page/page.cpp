#include "bench/page/page.h"

#include "bench/page/charts.h"
#include "bench/page/style.h"
#include "bench/page/tables.h"
#include "io/file/build_info.h"
#include "io/file/text.h"
#include "io/html/base_style.h"
#include "io/html/markup.h"

#include <cctype>

namespace refraster::bench {
namespace {

std::string section(const std::string& title, const std::string& about, const std::string& content) {
  if (content.empty()) return {};
  return "<h2>" + title + "</h2>\n<p>" + about + "</p>\n" + content;
}

/// "1 sphere, 2 torus": which number in a picture is which scene.
std::string scene_numbers(const Run& run) {
  if (run.scenes.size() < 2) return {};
  std::string list = "<p class=\"soft\">";
  for (std::size_t i = 0; i < run.scenes.size(); ++i)
    list += (i == 0 ? "" : ", ") + std::to_string(i + 1) + " " + escaped(label(run, run.scenes[i]));
  return list + "</p>\n";
}

std::string errors_section(const Run& run) {
  const std::string chart = error_chart(run);
  const std::string picture = chart.empty() ? "" : "<div class=\"wide\">" + chart + "</div>\n" + scene_numbers(run);
  return section(
      "What accuracy costs",
      "Each point is a precision on a scene: farther down is more exact, farther to the left is faster. Error is "
      "the mean over some hundred pixels of |value − exact| / |exact|, the exact value worked out in 60 "
      "digits.",
      picture + errors_table(run));
}

std::string splits_section(const Run& run) {
  std::string content;
  for (const SceneResult& scene : run.scenes) {
    if (scene.counts.shaded == 0) continue; // no pixel that its time could go to
    content += "<h3>" + escaped(label(run, scene)) + "</h3>\n<div class=\"wide\">" + split_chart(scene) + "</div>\n";
  }
  return section(
      "Where a pixel's time goes",
      "Wall time of a frame by shaded pixel. Interpolation is what a frame without lights spends in shading; "
      "fragment functions are the rest of it.",
      run.scenes.empty() ? "" : content);
}

std::string opengl_section(const Run& run) {
  const std::string chart = ratio_chart(run);
  if (chart.empty()) return {};
  std::string drivers;
  for (const SceneResult& scene : run.scenes)
    for (const OpenGlResult& one : scene.opengl)
      if (drivers.empty()) drivers = one.renderer + ", " + one.version;
  return section(
      "Beside OpenGL",
      "The same scene, size and number of threads, frames in turn. Dots are medians over the repetitions, bars "
      "hold half of them. Drawn by " +
          escaped(drivers) + ".",
      "<div class=\"wide\">" + chart + "</div>\n");
}

/// Both pictures of one growth, and what they say.
std::string growth(const Run& run, Growth growth) {
  std::vector<const ScalingCurve*> curves;
  for (const ScalingCurve& curve : run.scaling)
    if (curve.growth == growth) curves.push_back(&curve);
  if (curves.empty()) return {};
  std::string name(name_of(growth));
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return "<h3>" + name + "</h3>\n" +
         (growth == Growth::overdraw ? "<p class=\"soft\">Dashed: front to back.</p>\n" : "") + "<div class=\"pair\">" +
         growth_chart(run, curves) + memory_chart(run, curves) + "</div>\n" + scaling_table(curves);
}

std::string scaling_section(const Run& run) {
  std::string content;
  for (const auto& [value, name] : growth_names) content += growth(run, value);
  return section("How cost grows",
                 "One number of a scene grows, all else stays. The broken line is linear growth up to the last point. "
                 "The slope is that of "
                 "the upper half of the points, in logarithms; at most 1 means that twice as much costs at most twice "
                 "the time.",
                 content);
}

std::string headline(const Run& run) {
  const BuildInfo build = this_build();
  std::string text = "<h1>refraster bench</h1>\n<p class=\"soft\">" + escaped(run.machine.cpu) + ", " +
                     std::to_string(run.machine.usable_cpus.size()) + " CPUs · refraster " + escaped(build.version) +
                     ", " + escaped(build.compiler) + ", " + escaped(build.isa) + " · " + escaped(run.started) +
                     "<br><code>" + escaped(run.command) + "</code></p>\n";
  for (const std::string& note : run.notes) text += "<p>Note: " + escaped(note) + ".</p>\n";
  return text;
}

} // namespace

std::string run_html(const Run& run) {
  std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width\">\n<title>refraster bench</title>\n<style>";
  page += base_style;
  page += page_style;
  page += "</style>\n</head>\n<body>\n<main>\n" + headline(run);
  page += section("Frames",
                  "Median wall time of a frame; ±: half of the distance of the quartiles, in per cent of the median. "
                  "Cycles are reference cycles, of the time stamp counter.",
                  frames_table(run));
  if (std::any_of(run.scenes.begin(), run.scenes.end(), [](const SceneResult& s) { return !s.commands.empty(); }))
    page +=
        section("The whole command",
                "What a user waits for: refraster render, to a PNG, from the start of the process to its end, in ms. "
                "Start is what is left beside reading, the frame and writing.",
                commands_table(run));
  page += errors_section(run) + splits_section(run);
  page += section(
      "What one more thing costs",
      "In ns of CPU time, from frames of the scene with and without it, drawn in turn: the median and the "
      "quartiles of the repetitions. What is smaller than its spread, the distance of the quartiles, is shown as "
      "a bound: < 1.2.",
      costs_table(run));
  page += opengl_section(run) + scaling_section(run);
  page += section("Machine and method", "docs/bench.md says more.", facts_table(run));
  return page + "</main>\n</body>\n</html>\n";
}

} // namespace refraster::bench
