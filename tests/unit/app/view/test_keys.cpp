// The declared keys.

#include "app/command.h"
#include "app/options/wrap.h"
#include "app/view/keys.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace refraster;

TEST_CASE("every key has one action, and every action a key and a line of help") {
  std::set<std::string_view> names;
  std::set<KeyAction> actions;
  for (const KeyLine& line : key_lines()) {
    INFO(line.shown);
    CHECK_FALSE(line.meaning.empty());
    CHECK_FALSE(line.meaning.ends_with('.'));
    for (const NamedKey& key : line.keys) {
      CHECK(names.insert(key.name).second);
      actions.insert(key.action);
      CHECK(action_of_key(key.name) == key.action);
    }
  }
  CHECK(actions.size() == static_cast<std::size_t>(KeyAction::count_));
  CHECK_FALSE(action_of_key("F12"));
}

TEST_CASE("the help of the command and of the window have every line; docs/view.md is what `list keys` prints") {
  const Command program = refraster_command();
  const auto view = std::find_if(program.commands.begin(), program.commands.end(),
                                 [](const Command& command) { return command.name == "view"; });
  REQUIRE(view != program.commands.end());
  const std::vector<std::string> table = key_table(160);
  REQUIRE(table.size() == key_lines().size());
  for (const std::string& line : key_table(50)) CHECK(columns_of(line) <= 50);
  for (std::size_t i = 0; i < table.size(); ++i) {
    CHECK(table[i].ends_with(key_lines()[i].meaning));
    CHECK(std::count(view->notes.begin(), view->notes.end(), key_note(key_lines()[i])) == 1);
  }
  const std::string page = text_of(std::string(REFRASTER_SOURCE_DIR) + "/docs/view.md");
  CHECK(page.find(keys_markdown()) != std::string::npos);
}
