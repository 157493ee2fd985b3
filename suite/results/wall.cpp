#include "suite/results/wall.h"

#include "io/file/build_info.h"
#include "io/file/text.h"
#include "io/html/base_style.h"
#include "io/html/filled.h"
#include "io/html/markup.h"

#include <algorithm>
#include <map>

namespace refraster::suite {
namespace {

/// Words that a filter offers, numbered: an attribute of a card lists numbers.
class WordNumbers {
public:
  explicit WordNumbers(const std::vector<EntryResult>& entries, std::vector<std::string> EntryResult::*words)
      : words_(words) {
    for (const EntryResult& entry : entries)
      for (const std::string& word : entry.*words) ++counts_[word];
    std::size_t number = 0;
    for (const auto& [word, count] : counts_) numbers_[word] = number++;
  }
  std::string of(const EntryResult& entry) const {
    std::string text;
    for (const std::string& word : entry.*words_) text += (text.empty() ? "" : " ") + std::to_string(numbers_.at(word));
    return text;
  }
  const std::map<std::string, std::size_t>& counts() const { return counts_; }
  std::size_t number(const std::string& word) const { return numbers_.at(word); }

private:
  std::vector<std::string> EntryResult::*words_;
  std::map<std::string, std::size_t> counts_, numbers_;
};

std::string_view class_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::passed:
    return "passed";
  case Outcome::failed:
    return "failed";
  case Outcome::error:
    return "error";
  case Outcome::skipped:
    break;
  }
  return "skipped";
}

/// Whether `suite update` would store something.
bool would_be_stored(const EntryResult& entry) {
  return entry.action == Action::compare && (entry.state == State::different || entry.state == State::no_reference);
}

/// An address within the folder: names have no character that needs more than HTML's own.
std::string address(const std::string& file) {
  return escaped(file);
}

std::string headline(const RunResults& results) {
  const bool passed = results.exit_code() == 0;
  std::string html = "<p class=\"title\">refraster suite " + escaped(results.suite) + "</p>\n<h1><span class=\"badge " +
                     (passed ? "passed\">✓" : "failed\">✕") + "</span>" + escaped(counts_text(results.entries)) +
                     "</h1>\n";
  for (const std::string& one : results.contradictions) html += "<p>" + escaped(one) + "</p>\n";
  const auto stored = std::count_if(results.entries.begin(), results.entries.end(), would_be_stored);
  if (stored > 0)
    html += "<p>" + std::string("<code>refraster suite update</code> would store ") +
            counted(static_cast<std::size_t>(stored), "reference") + ".</p>\n";
  return html;
}

std::string filters(const RunResults& results, const WordNumbers& tags, const WordNumbers& objects) {
  std::map<State, std::size_t> states;
  for (const EntryResult& entry : results.entries) ++states[entry.state];
  std::string html = "<div class=\"group\" role=\"group\" aria-label=\"States\">\n";
  for (const auto& [state, count] : states) {
    const StateFacts& facts = facts_of(state);
    html += "<button type=\"button\" aria-pressed=\"false\" data-choose-state=\"" + escaped(facts.name) +
            "\" title=\"" + escaped(facts.meaning) + "\"><span class=\"state " + std::string(class_of(facts.outcome)) +
            "\">" + escaped(facts.name) + "</span> <b>" + std::to_string(count) + "</b></button>\n";
  }
  if (const auto stored = std::count_if(results.entries.begin(), results.entries.end(), would_be_stored); stored > 0)
    html += "<button type=\"button\" aria-pressed=\"false\" data-choose-state=\"bless\">what update would store <b>" +
            std::to_string(stored) + "</b></button>\n";
  html += "</div>\n";
  if (!tags.counts().empty()) {
    html += "<div class=\"group\" role=\"group\" aria-label=\"Tags\">\n";
    for (const auto& [word, count] : tags.counts())
      html += "<button type=\"button\" aria-pressed=\"false\" data-choose-tag=\"" + std::to_string(tags.number(word)) +
              "\">" + escaped(word) + " <b>" + std::to_string(count) + "</b></button>\n";
    html += "</div>\n";
  }
  if (!objects.counts().empty()) {
    html += "<label>Object <select id=\"object\"><option value=\"\">all</option>\n";
    for (const auto& [word, count] : objects.counts())
      html += "<option value=\"" + std::to_string(objects.number(word)) + "\">" + escaped(word) + " (" +
              std::to_string(count) + ")</option>\n";
    html += "</select></label>\n";
  }
  return html + "<label>Words <input id=\"words\" type=\"search\"></label>\n"
                "<label>Order <select id=\"order\"><option value=\"worst\">worst first</option>"
                "<option value=\"name\">name</option><option value=\"time\">time</option></select></label>\n";
}

std::string figure(const std::string& png, const std::string& caption, const EntryResult& entry) {
  return "<figure><img loading=\"lazy\" src=\"data:image/png;base64," + png + "\" alt=\"" +
         escaped(caption + " of " + entry.name) + "\"><figcaption>" + escaped(caption) + "</figcaption></figure>";
}

/// Beside each other what was, what is and where they differ; of an entry that passes its image alone.
std::string images(const EntryResult& entry) {
  std::string html;
  if (!entry.reference_thumbnail.empty()) html += figure(entry.reference_thumbnail, "reference", entry);
  else if (would_be_stored(entry) && !entry.thumbnail.empty())
    html += "<figure><div class=\"none\">no image</div><figcaption>reference</figcaption></figure>";
  if (!entry.thumbnail.empty()) html += figure(entry.thumbnail, entry.passes() ? "image" : "now", entry);
  if (!entry.difference_thumbnail.empty())
    html += figure(entry.difference_thumbnail, entry.action == Action::verify ? "classes" : "difference", entry);
  if (html.empty()) html = "<figure><div class=\"none\">no image</div></figure>";
  const std::string& leads_to = entry.page.empty() ? entry.image : entry.page;
  const std::string ratio = entry.width > 0 && entry.height > 0 ? " style=\"--ratio: " + std::to_string(entry.width) +
                                                                      " / " + std::to_string(entry.height) + "\""
                                                                : "";
  if (leads_to.empty()) return "<div class=\"images\"" + ratio + ">" + html + "</div>\n";
  return "<a class=\"images\"" + ratio + " href=\"" + address(leads_to) + "\">" + html + "</a>\n";
}

std::string facts(const EntryResult& entry) {
  std::string text = std::string(name_of(entry.action));
  if (!entry.device.empty()) text += " " + entry.device;
  if (entry.width > 0) text += format(", %dx%d", entry.width, entry.height);
  if (entry.samples > 1) text += format(", %d samples", entry.samples);
  if (entry.precision != "double") text += ", " + entry.precision;
  text += entry.seconds < 1 ? format(", %.0f ms", 1e3 * entry.seconds) : format(", %.3g s", entry.seconds);
  if (entry.from == ResultFrom::cache) text += ", known from before";
  return text;
}

std::string links(const EntryResult& entry) {
  std::string html;
  const auto link = [&](const std::string& file, const char* words) {
    if (!file.empty()) html += (html.empty() ? "<p>" : " · ") + ("<a href=\"" + address(file) + "\">") + words + "</a>";
  };
  link(entry.page, "pixel by pixel"), link(entry.image, "image"), link(entry.difference, "difference");
  return html.empty() ? html : html + "</p>\n";
}

/// How many images stand beside each other in a card, as a class of it.
const char* width_of(const EntryResult& entry) {
  if (!entry.difference_thumbnail.empty()) return " wide";
  return !entry.reference_thumbnail.empty() || (would_be_stored(entry) && !entry.thumbnail.empty()) ? " pair" : "";
}

std::string card(const EntryResult& entry, std::size_t rank, const WordNumbers& tags, const WordNumbers& objects) {
  const StateFacts& state = facts_of(entry.state);
  std::string html = "<li class=\"card" + std::string(width_of(entry)) + "\" data-state=\"" + escaped(state.name) +
                     "\" data-name=\"" + escaped(entry.name) + "\" data-rank=\"" + std::to_string(rank) +
                     format("\" data-seconds=\"%.6f", entry.seconds) + "\" data-tags=\"" + tags.of(entry) +
                     "\" data-objects=\"" + objects.of(entry) + "\"" +
                     (would_be_stored(entry) ? " data-bless=\"yes\"" : "") + ">\n" + images(entry) +
                     "<div class=\"words\">\n<h2>" + escaped(entry.name) + " <span class=\"state " +
                     std::string(class_of(state.outcome)) + "\">" + escaped(state.name) + "</span></h2>\n";
  if (!entry.passes() || entry.message != state.name) html += "<p>" + escaped(entry.message) + "</p>\n";
  if (!entry.details.empty()) {
    html += "<details><summary>more</summary>\n";
    for (const std::string& line : entry.details) html += "<p>" + escaped(line) + "</p>\n";
    html += "</details>\n";
  }
  html += links(entry) + "<p class=\"facts\">" + escaped(facts(entry)) + "</p>\n";
  if (!entry.tags.empty()) {
    html += "<p class=\"facts\">";
    for (const std::string& tag : entry.tags) html += "<span class=\"tag\">" + escaped(tag) + "</span>";
    html += "</p>\n";
  }
  return html + "</div>\n</li>\n";
}

std::string footer(const RunResults& results) {
  const BuildInfo build = this_build();
  return "<p>" + escaped("refraster " + build.version + ", " + build.compiler + ", " + build.isa) +
         format("; %.3g s", results.seconds) + "</p>\n";
}

} // namespace

std::string wall_html(const RunResults& results) {
  const WordNumbers tags(results.entries, &EntryResult::tags), objects(results.entries, &EntryResult::objects);
  std::string cards;
  for (std::size_t i = 0; i < results.entries.size(); ++i) cards += card(results.entries[i], i, tags, objects);
  return filled(wall_text.html, {{"title", escaped("refraster suite " + results.suite)},
                                 {"style", std::string(base_style) + std::string(wall_text.style)},
                                 {"headline", headline(results)},
                                 {"filters", filters(results, tags, objects)},
                                 {"cards", cards},
                                 {"footer", footer(results)},
                                 {"script", std::string(wall_text.script)}});
}

} // namespace refraster::suite
