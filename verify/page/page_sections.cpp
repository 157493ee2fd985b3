#include "verify/page/page_parts.h"

#include "io/file/text.h"
#include "io/html/html_table.h"
#include "io/html/markup.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

std::string element(const std::string& name, const std::string& content) {
  return content.empty() ? "" : "<" + name + ">" + content + "</" + name.substr(0, name.find(' ')) + ">\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& about,
                    const std::string& content) {
  if (content.empty()) return {};
  return "<section id=\"" + id + "\">\n<h2>" + title + "</h2>\n" + element("p class=\"soft\"", about) + content +
         "</section>\n";
}

/// "99.8 %". Cut, not rounded: 100 % means all.
std::string percent(double fraction) {
  const double tenths = std::floor(std::clamp(fraction, 0.0, 1.0) * 1000 + 1e-9) / 10;
  return format("%.*f %%", tenths == 100 ? 0 : 1, tenths);
}

std::string pixels(std::uint64_t count) {
  return with_commas(count) + (count == 1 ? " pixel" : " pixels");
}

std::string_view badge_of(PageTone tone) {
  switch (tone) {
  case PageTone::passed:
    return "<span class=\"badge passed\" aria-hidden=\"true\">✓</span>";
  case PageTone::failed:
    return "<span class=\"badge failed\" aria-hidden=\"true\">✕</span>";
  case PageTone::neutral:
    break;
  }
  return {};
}

/// A bar whose length is a count of pixels beside the greatest one.
std::string bar(const std::string& label, std::uint64_t count, std::uint64_t greatest) {
  const double fraction = greatest == 0 ? 0 : static_cast<double>(count) / static_cast<double>(greatest);
  return "<div class=\"bar\"><span class=\"label\">" + label + "</span><span class=\"track\"><span class=\"fill\"" +
         format(" style=\"width:%.2f%%\"", 100 * fraction) + "></span></span><span class=\"count\">" + pixels(count) +
         "</span></div>\n";
}

std::string hypotheses_section(const ReportPage& page) {
  if (page.hypotheses.empty()) return {};
  std::string list = "<ol class=\"hypotheses\">\n";
  for (std::size_t i = 0; i < page.hypotheses.size(); ++i) {
    const PageHypothesis& one = page.hypotheses[i];
    const std::uint64_t greatest = std::max(one.before, one.after);
    list += "<li>\n<p class=\"explained\"><b>" + percent(one.explained) + "</b> explained</p>\n<div>\n";
    list += element("h3", escaped(one.text)) + element("p class=\"soft\"", escaped(one.detail));
    list += bar("before", one.before, greatest) + bar("after", one.after, greatest);
    if (!one.image.empty())
      list += "<button type=\"button\" class=\"needs-script\" data-show=\"hypothesis-" + std::to_string(i) +
              "\">Show the image with this fault</button>\n";
    list += "</div>\n</li>\n";
  }
  return section(
      "causes", "Possible causes",
      "Each fault was tried: the scene was rendered with it, and the pixels that stayed unexplained counted.",
      list + "</ol>\n");
}

std::string objects_text(const PageCluster& cluster) {
  std::string text;
  for (const auto& [name, count] : cluster.objects)
    text += (text.empty() ? "" : ", ") + escaped(name) +
            (cluster.objects.size() == 1 ? "" : " <span class=\"soft\">" + with_commas(count) + "</span>");
  return text;
}

/// "12–17", or "12" of one.
std::string range_text(int first, int count) {
  const std::string text = std::to_string(first);
  return count == 1 ? text : text + "–" + std::to_string(first + count - 1);
}

std::string clusters_section(const ReportPage& page) {
  if (page.clusters.empty()) return {};
  const bool named = std::any_of(page.clusters.begin(), page.clusters.end(),
                                 [](const PageCluster& cluster) { return !cluster.objects.empty(); });
  std::string rows;
  for (std::size_t i = 0; i < page.clusters.size(); ++i) {
    const Cluster& at = page.clusters[i].where;
    rows += "<tr><td class=\"left\"><button type=\"button\" class=\"link\" data-cluster=\"" + std::to_string(i) +
            "\">x " + range_text(at.x, at.width) + ", y " + range_text(at.y, at.height) + "</button></td>";
    rows += "<td>" + with_commas(at.pixels) + "</td>";
    if (named) rows += "<td class=\"left\">" + objects_text(page.clusters[i]) + "</td>";
    rows += "<td>" + (std::isfinite(at.largest) ? format("%.4g", at.largest) : std::string("none")) + "</td>";
    rows += format("<td>(%d, %d)</td></tr>\n", at.worst_x, at.worst_y);
  }
  const std::uint64_t count = std::max<std::uint64_t>(page.cluster_count, page.clusters.size());
  const std::string about =
      "Pixels that touch each other. " +
      (count > page.clusters.size()
           ? "The largest " + std::to_string(page.clusters.size()) + " of " + with_commas(count) + "."
           : with_commas(count) + (count == 1 ? " cluster." : " clusters."));
  return section("clusters", "Where", about,
                 "<div class=\"wide\"><table>\n<tr><th class=\"left\">rectangle</th><th>pixels</th>" +
                     std::string(named ? "<th class=\"left\">objects</th>" : "") +
                     "<th>largest difference</th><th>at</th></tr>\n" + rows + "</table></div>\n");
}

std::string tables_section(const ReportPage& page) {
  std::string content;
  for (const PageTable& table : page.tables) {
    HtmlTable html(table.columns, 1);
    for (const std::vector<std::string>& row : table.rows) html.add(row);
    if (!html.html().empty())
      content += "<div>\n" + element("h3", escaped(table.title)) + element("p class=\"soft\"", escaped(table.about)) +
                 html.html() + "</div>\n";
  }
  return section("numbers", "Numbers", {}, content.empty() ? "" : "<div class=\"tables\">\n" + content + "</div>\n");
}

std::string provenance_section(const ReportPage& page) {
  std::string rows;
  for (const auto& [name, value] : page.provenance)
    rows += "<dt>" + escaped(name) + "</dt><dd><code>" + escaped(value) + "</code></dd>\n";
  return section("provenance", "Provenance", {}, rows.empty() ? "" : "<dl class=\"facts\">\n" + rows + "</dl>\n");
}

} // namespace

std::string page_headline(const ReportPage& page) {
  std::string text = element("p class=\"title\"", escaped(page.title));
  text += "<h1>" + std::string(badge_of(page.tone)) + escaped(page.headline) + "</h1>\n";
  for (const std::string& line : page.summary) text += element("p", escaped(line));
  return text + element("p class=\"soft\"", escaped(page.power));
}

std::string page_sections(const ReportPage& page) {
  return hypotheses_section(page) + clusters_section(page) + tables_section(page) + provenance_section(page);
}

} // namespace refraster
