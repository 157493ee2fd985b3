#include "brdf/page/page.h"

#include "brdf/facts.h"
#include "io/file/build_info.h"
#include "io/file/text.h"
#include "io/html/base_style.h"
#include "io/html/html_table.h"
#include "io/html/markup.h"

#include <algorithm>

namespace refraster {
namespace {

constexpr std::string_view page_style = R"(
:root { --series0: #1566b0; --series1: #c2510a; --series2: #14866b; --series3: #8c4aa8;
  --red: #c62f21; --green: #1d8040; --blue: #2460c4; }
@media (prefers-color-scheme: dark) {
  :root { --series0: #62aef0; --series1: #f4934f; --series2: #4cc9a4; --series3: #c58fe0;
    --red: #ff7a6b; --green: #5fce85; --blue: #7fb0ff; }
  .lobe { fill-opacity: .16 !important; } }
main { max-width: 900px; margin: 0 auto; padding: 28px 20px 60px; }
svg { display: block; max-width: 100%; height: auto; }
.facts td { white-space: normal; overflow-wrap: anywhere; text-align: left; }
.facts td:first-child { color: var(--soft); white-space: nowrap; vertical-align: top; }
pre { font: 12.5px/1.5 ui-monospace, monospace; overflow-x: auto; }
)";

/// escaped() makes one line of its text.
std::string escaped_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string rgb_words(const Rgb<double>& rgb) {
  return format("%.3g %.3g %.3g", rgb.x, rgb.y, rgb.z);
}

} // namespace

std::vector<std::pair<std::string, std::string>> page_facts(const Brdf& brdf, const std::string& name) {
  const BrdfFacts facts = brdf_facts(brdf);
  std::vector<std::pair<std::string, std::string>> rows = {
      {name, brdf.label() + (brdf.lobes() ? ": " + model_text(*brdf.lobes()) : "")}};
  std::string albedo;
  for (const AlbedoFact& fact : facts.albedos)
    albedo += (albedo.empty() ? "" : " · ") + format("%g°: ", fact.degrees) + rgb_words(fact.albedo);
  rows.emplace_back("albedo", albedo);
  rows.emplace_back("greatest f", format("%.4g %.4g %.4g per steradian", facts.channels[0].max, facts.channels[1].max,
                                         facts.channels[2].max));
  for (const std::string& sentence : impossibilities(facts)) rows.emplace_back("note", "it " + sentence);
  return rows;
}

std::string brdf_page_html(const BrdfPage& page) {
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                     "content=\"width=device-width, initial-scale=1\">\n<title>" +
                     escaped(page.title) + "</title>\n<style>" + std::string(base_style) + std::string(page_style) +
                     "</style>\n</head>\n<body>\n<main>\n<h1>" + escaped(page.title) +
                     "</h1>\n<p class=\"soft\">refraster " + escaped(this_build().version) + "</p>\n";
  HtmlTable facts({"", ""}, 2);
  for (const auto& [name, words] : page.facts) facts.add({name, words});
  html += "<div class=\"facts\">" + facts.html() + "</div>\n";
  for (const BrdfChart& chart : brdf_charts)
    html += "<h2>" + std::string(chart.title) + "</h2>\n<p>" + std::string(chart.about) + "</p>\n<div class=\"wide\">" +
            chart.chart(page.shown) + "</div>\n";
  if (!page.comparison.empty())
    html += "<h2>How far apart</h2>\n<div class=\"wide\"><pre>" + escaped_lines(page.comparison) + "</pre></div>\n";
  return html + "</main>\n</body>\n</html>\n";
}

} // namespace refraster
