#include "suite/results/summary.h"

#include "io/file/text.h"
#include "io/json/report_parts.h"
#include "suite/results/result_json.h"

#include <algorithm>
#include <map>

namespace refraster::suite {
namespace {

constexpr std::size_t listed_worst = 3, listed_in_markdown = 50;

/// A cell of a table: no line end, and nothing that Markdown would take for its own.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : one_line(text)) {
    if (std::string_view("|\\`*_<>[]").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::map<State, std::size_t> counts_of(const std::vector<EntryResult>& entries) {
  std::map<State, std::size_t> counts;
  for (const EntryResult& entry : entries) ++counts[entry.state];
  return counts;
}

std::size_t cached_of(const std::vector<EntryResult>& entries) {
  return static_cast<std::size_t>(std::count_if(
      entries.begin(), entries.end(), [](const EntryResult& entry) { return entry.from == ResultFrom::cache; }));
}

} // namespace

void RunResults::sort() {
  std::sort(entries.begin(), entries.end(), is_worse);
}

int RunResults::exit_code() const {
  const int code = exit_code_of(entries);
  return contradictions.empty() || (code != 0 && code != 5) ? code : 1;
}

std::string counts_text(const std::vector<EntryResult>& entries) {
  std::string text;
  for (const auto& [state, count] : counts_of(entries))
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(facts_of(state).name);
  return text.empty() ? "no entries" : text;
}

std::string summary_text(const RunResults& results, const std::string& folder) {
  std::string text = counts_text(results.entries);
  if (const std::size_t cached = cached_of(results.entries); cached > 0)
    text += " (" + std::to_string(cached) + " known from before)";
  text += format(" in %.3g s\n", results.seconds);
  std::size_t listed = 0;
  for (const EntryResult& entry : results.entries) {
    if (entry.passes() || listed == listed_worst) break;
    ++listed;
    text += "  " + entry.name + ": " + std::string(facts_of(entry.state).name) + ": " + entry.message + "\n";
  }
  const auto failing = static_cast<std::size_t>(
      std::count_if(results.entries.begin(), results.entries.end(), [](const EntryResult& e) { return !e.passes(); }));
  if (failing > listed) text += "  and " + std::to_string(failing - listed) + " more\n";
  for (const std::string& contradiction : results.contradictions) text += "  " + contradiction + "\n";
  return text + folder + "/index.html\n";
}

std::string summary_markdown(const RunResults& results) {
  std::string text = "### refraster suite\n\n" + counts_text(results.entries) + "\n";
  std::size_t listed = 0;
  for (const EntryResult& entry : results.entries) {
    if (entry.passes()) break;
    if (listed == 0) text += "\n| entry | state | |\n|---|---|---|\n";
    if (++listed > listed_in_markdown) continue;
    text += "| " + cell(entry.name) + " | " + cell(facts_of(entry.state).name) + " | " + cell(entry.message) + " |\n";
  }
  if (listed > listed_in_markdown)
    text += "\nAnd " + std::to_string(listed - listed_in_markdown) + " more that do not pass.\n";
  for (const std::string& contradiction : results.contradictions) text += "\n- " + cell(contradiction) + "\n";
  return text;
}

std::string results_json(const RunResults& results) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.text_or_null("suite", results.suite);
    json.member("exit_code", results.exit_code());
    json.member("seconds", results.seconds);
    json.object("counts", [&] {
      for (const auto& [state, count] : counts_of(results.entries)) json.member(facts_of(state).name, count);
    });
    json.member("contradictions", results.contradictions);
    json.array("entries", [&] {
      for (const EntryResult& entry : results.entries) write_result(json, entry, MemberOf::report);
    });
  });
  return json.text();
}

} // namespace refraster::suite
