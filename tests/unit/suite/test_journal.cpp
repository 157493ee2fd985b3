// What a run writes down as it goes on.

#include "suite/results/journal.h"
#include "suite/results/result_json.h"
#include "suite/results/results_folder.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace refraster;
using namespace refraster::suite;

namespace {

namespace fs = std::filesystem;

EntryResult result_named(const std::string& name) {
  EntryResult result;
  result.name = name, result.scene = "s/" + name + ".json";
  result.action = Action::verify;
  result.state = State::different;
  result.message = "differ by 3 levels, \"quoted\"\nand a line";
  result.details = {"first", "second"};
  result.severity = 0.25;
  result.precision = "double", result.device = "llvmpipe", result.driver = "llvmpipe (LLVM 15)";
  result.tags = {"a", "b"}, result.objects = {"cube (object 1)"};
  result.width = 640, result.height = 360, result.samples = 4;
  result.max_levels = 3.5, result.rms_levels = 0.1, result.frame_ms = 2.5, result.pixels_over = 12345678901;
  result.image_sha256 = "ab", result.seconds = 1.25, result.peak_bytes = 1 << 20;
  result.page = "pages/x.html", result.image = "images/x.png", result.difference = "images/x.difference.png";
  result.finished = "2026-01-01T00:00:00Z", result.settings = "cd";
  result.inputs = {{"a.json", "12"}, {"gone.png", ""}};
  result.thumbnail = "QUJD", result.reference_thumbnail = "REVG", result.difference_thumbnail = "R0hJ";
  return result;
}

std::string only_journal(const TemporaryFolder& folder) {
  std::string path;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / journal_folder)) path = entry.path();
  return path;
}

} // namespace

TEST_CASE("every member of a result is there again when it is read") {
  const EntryResult before = result_named("x");
  const JsonDocument document("x", result_text(before));
  const std::optional<EntryResult> after = result_from(document, 0);
  REQUIRE(after);
  std::vector<std::string> different;
  CHECK(result_text(*after) == result_text(before));
  // Each member was given a value of its own: one that is not written would be seen.
  EntryResult empty;
  const JsonDocument blank("x", result_text(empty));
  for (JsonIndex i = document[0].first_child, j = blank[0].first_child; i; i = document[i].next, j = blank[j].next)
    if (document.source(document[i]) == blank.source(blank[j])) different.emplace_back(document[i].key);
  CHECK(different.empty());
}

TEST_CASE("a result of which a member is missing or of another kind is none") {
  const std::string text = result_text(result_named("x"));
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"state\"", "\"stat\""},
                                 {"\"different\"", "\"odd\""},
                                 {"\"seconds\": 1.25", "\"seconds\": \"long\""},
                                 {"\"severity\": 0.25", "\"severity\": -1"}}) {
    std::string wrong = text;
    const std::size_t at = wrong.find(from);
    REQUIRE(at != std::string::npos);
    wrong.replace(at, from.size(), to);
    const JsonDocument document("x", wrong);
    CHECK_FALSE(result_from(document, 0));
  }
}

TEST_CASE("a journal that ends anywhere has all that was whole before; none of it is taken for more") {
  const TemporaryFolder folder;
  prepare_results(folder.path);
  {
    Journal journal(folder.path, {"s.json", {"a", "b", "c"}});
    for (const char* const name : {"a", "b", "c"}) journal.add(result_named(name));
    journal.finish();
  }
  const std::string path = only_journal(folder), whole = text_of(path);
  const KnownResults all = read_journals(folder.path);
  CHECK(all.latest.size() == 3);
  CHECK(all.names == std::set<std::string>{"a", "b", "c"});
  CHECK(all.suite == "s.json");
  CHECK(all.notes.empty());
  std::size_t before = 0;
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    save_text(path, whole.substr(0, size));
    const KnownResults known = read_journals(folder.path);
    CHECK(known.latest.size() >= before);
    CHECK(known.latest.size() <= 3);
    before = known.latest.size();
    for (const auto& [name, result] : known.latest) CHECK(result_text(result) == result_text(result_named(name)));
  }
}

TEST_CASE("a byte that is another one costs one record, and is noted") {
  const TemporaryFolder folder;
  prepare_results(folder.path);
  {
    Journal journal(folder.path, {"", {"a", "b", "c"}});
    for (const char* const name : {"a", "b", "c"}) journal.add(result_named(name));
    journal.finish();
  }
  const std::string path = only_journal(folder);
  std::string text = text_of(path);
  text[text.find("s/b.json")] = 'x';
  save_text(path, text);
  const KnownResults known = read_journals(folder.path);
  CHECK(known.latest.size() == 2);
  CHECK_FALSE(known.latest.contains("b"));
  REQUIRE(known.notes.size() == 1);
  CHECK(known.notes.front().find("1 record cut off or corrupt") != std::string::npos);
}

TEST_CASE("journals that another one supersedes are removed, those of other entries and unfinished ones are not") {
  const TemporaryFolder folder;
  prepare_results(folder.path);
  const auto write = [&](const std::vector<std::string>& names, bool finished) {
    auto journal = std::make_unique<Journal>(folder.path, RunHeader{"", names});
    for (const std::string& name : names) journal->add(result_named(name));
    if (finished) journal->finish();
    return journal->path();
  };
  const std::string same = write({"a", "b"}, true), others = write({"a", "z"}, true), running = write({"a"}, false);
  const std::string own = write({"a", "b", "c"}, true);
  remove_superseded(folder.path, own);
  CHECK_FALSE(fs::exists(same));
  CHECK(fs::exists(others));
  CHECK(fs::exists(running)); // by this process, which lives
  CHECK(fs::exists(own));
}
