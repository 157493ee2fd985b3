#pragma once
// How an entry ended.

#include <refraster/fields.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

namespace refraster::suite {

/// From what needs a look most to what needs none: the order of pages and summaries.
enum class State {
  unexplained,
  different,
  crashed,
  timed_out,
  out_of_memory,
  unwritable,
  bad_input,
  no_reference,
  missing,
  no_opengl,
  explained,
  done,
  equal
};

/// What a build server calls it (JUnit).
enum class Outcome { passed, failed, error, skipped };

struct StateFacts {
  State state;
  std::string_view name;
  Outcome outcome;
  int exit_code; ///< of a run in which this is the worst
  /// Whether it follows from what was read alone, so that it need not be found out again.
  bool is_repeatable;
  std::string_view meaning;
};

/// Every state. Exit codes are those of the program (app/command.h).
inline constexpr StateFacts state_facts[] = {
    {State::unexplained, "unexplained", Outcome::failed, 1, true, "pixels are not what a right device shows"},
    {State::different, "different", Outcome::failed, 1, true, "not its reference, within its limits"},
    {State::crashed, "crashed", Outcome::error, 70, false, "its process ended by a signal"},
    {State::timed_out, "timed out", Outcome::error, 3, false, "ended after its time"},
    {State::out_of_memory, "out of memory", Outcome::error, 3, false, "ended beyond its memory"},
    {State::unwritable, "unwritable", Outcome::error, 4, false, "what it makes cannot be written"},
    {State::bad_input, "bad input", Outcome::error, 3, true,
     "a file of it cannot be read, or is not what it should be"},
    {State::no_reference, "no reference", Outcome::failed, 1, true, "nothing to compare with: `suite update` makes it"},
    {State::missing, "missing", Outcome::error, 1, false, "no run has done it"},
    {State::no_opengl, "no OpenGL", Outcome::skipped, 5, false, "no OpenGL here that can draw it"},
    {State::explained, "explained", Outcome::passed, 0, true, "every pixel is what a right device shows"},
    {State::done, "done", Outcome::passed, 0, true, "made; nothing was to be compared"},
    {State::equal, "equal", Outcome::passed, 0, true, "its reference, within its limits"},
};

constexpr const StateFacts& facts_of(State state) {
  return *std::find_if(std::begin(state_facts), std::end(state_facts) - 1,
                       [&](const StateFacts& facts) { return facts.state == state; });
}

} // namespace refraster::suite

namespace refraster {

template <>
struct EnumNames<suite::State> {
  static constexpr auto names = [] {
    std::array<std::pair<suite::State, std::string_view>, std::size(suite::state_facts)> result;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = {suite::state_facts[i].state, suite::state_facts[i].name};
    return result;
  }();
};

} // namespace refraster
