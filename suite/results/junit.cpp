// JUnit's XML. There is no standard; this is what Jenkins, GitLab and GitHub's actions read.

#include "io/file/text.h"
#include "io/html/markup.h"
#include "suite/results/summary.h"

#include <algorithm>

namespace refraster::suite {
namespace {

std::size_t count(const RunResults& results, Outcome outcome) {
  return static_cast<std::size_t>(std::count_if(results.entries.begin(), results.entries.end(),
                                                [&](const EntryResult& entry) { return entry.outcome() == outcome; }));
}

/// The element within a test case that says what came of it; nothing for one that passed.
const char* element_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::failed:
    return "failure";
  case Outcome::error:
    return "error";
  case Outcome::skipped:
    return "skipped";
  case Outcome::passed:
    break;
  }
  return nullptr;
}

std::string test_case(const EntryResult& entry) {
  std::string xml = "    <testcase name=\"" + escaped(entry.name) + "\" classname=\"" + escaped(name_of(entry.action)) +
                    "\" file=\"" + escaped(entry.scene) + format("\" time=\"%.3f\"", entry.seconds);
  const char* const element = element_of(entry.outcome());
  if (element == nullptr) return xml + "/>\n";
  xml += std::string(">\n      <") + element + " message=\"" + escaped(entry.message) + "\" type=\"" +
         escaped(facts_of(entry.state).name) + "\">";
  for (const std::string& line : entry.details) xml += escaped(line) + "\n";
  if (!entry.page.empty()) xml += escaped(entry.page) + "\n";
  return xml + "</" + element + ">\n    </testcase>\n";
}

} // namespace

std::string junit_xml(const RunResults& results) {
  const std::string numbers = format("tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"%zu\" time=\"%.3f\"",
                                     results.entries.size(), count(results, Outcome::failed),
                                     count(results, Outcome::error), count(results, Outcome::skipped), results.seconds);
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + numbers + ">\n  <testsuite name=\"" +
                    escaped(results.suite.empty() ? "refraster suite" : results.suite) + "\" " + numbers + ">\n";
  for (const EntryResult& entry : results.entries) xml += test_case(entry);
  return xml + "  </testsuite>\n</testsuites>\n";
}

} // namespace refraster::suite
