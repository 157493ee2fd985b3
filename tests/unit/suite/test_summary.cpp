// Exit codes, order, and the formats of build servers.

#include "suite/results/summary.h"
#include "suite/results/wall.h"

#include <doctest/doctest.h>

using namespace refraster;
using namespace refraster::suite;

namespace {

EntryResult of_state(State state, const std::string& name = "e") {
  EntryResult result;
  result.name = name, result.state = state, result.message = "a <b> & \"c\"\x01 | d";
  return result;
}

} // namespace

TEST_CASE("the exit code is that of the gravest state") {
  const auto code = [](std::initializer_list<State> states) {
    std::vector<EntryResult> results;
    for (const State state : states) results.push_back(of_state(state));
    return exit_code_of(results);
  };
  CHECK(code({}) == 0);
  CHECK(code({State::equal, State::explained, State::done}) == 0);
  CHECK(code({State::equal, State::no_opengl}) == 5);
  CHECK(code({State::no_opengl, State::different}) == 1);
  CHECK(code({State::no_reference}) == 1);
  CHECK(code({State::different, State::bad_input, State::equal}) == 3);
  CHECK(code({State::timed_out}) == 3);
  CHECK(code({State::bad_input, State::unwritable}) == 4);
  CHECK(code({State::unwritable, State::crashed}) == 70);
}

TEST_CASE("what needs a look comes first, the worst of its state before others") {
  RunResults results;
  results.entries = {of_state(State::equal, "a"), of_state(State::different, "b"), of_state(State::different, "c"),
                     of_state(State::unexplained, "d")};
  results.entries[2].severity = 0.5;
  results.sort();
  std::string order;
  for (const EntryResult& entry : results.entries) order += entry.name;
  CHECK(order == "dcba");
  CHECK(counts_text(results.entries) == "1 unexplained, 2 different, 1 equal");
}

TEST_CASE("contradictions fail a run in which all is equal") {
  RunResults results;
  results.entries = {of_state(State::equal)};
  CHECK(results.exit_code() == 0);
  results.contradictions = {"e: a and b disagree"};
  CHECK(results.exit_code() == 1);
}

TEST_CASE("every state has a name, a meaning and a place in the order of badness") {
  for (const StateFacts& facts : state_facts) {
    CHECK(value_named<State>(facts.name) == facts.state);
    CHECK_FALSE(facts.meaning.empty());
    CHECK((facts.outcome == Outcome::passed) == (facts.exit_code == 0));
    CHECK(&facts_of(facts.state) == &facts);
  }
}

TEST_CASE("texts of results end no cell, element or attribute") {
  RunResults results;
  results.entries = {of_state(State::different)};
  const std::string markdown = summary_markdown(results), xml = junit_xml(results), html = wall_html(results);
  CHECK(markdown.find("a \\<b\\> & \"c\"? \\| d") != std::string::npos);
  CHECK(xml.find("message=\"a &lt;b&gt; &amp; &quot;c&quot;? | d\"") != std::string::npos);
  CHECK(html.find("<p>a &lt;b&gt; &amp; &quot;c&quot;? | d</p>") != std::string::npos);
}
