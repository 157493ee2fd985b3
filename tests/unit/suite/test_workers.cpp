// Workers, and who looks after them.

#include "suite/workers/supervisor.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <map>

#include <csignal>
#include <sys/socket.h>
#include <unistd.h>

using namespace refraster;
using namespace refraster::suite;

namespace {

struct Place : TemporaryFolder {
  Place() {
    std::filesystem::create_directories(path / "images");
    save_text(*this / "s.json", ball_scene);
    workplace.results = path;
    workplace.references = &references;
  }
  Entry entry(const std::string& name) const {
    Entry result;
    result.name = name, result.scene = *this / "s.json", result.action = Action::render;
    result.size = PixelSize{32, 24};
    return result;
  }
  std::map<std::string, EntryResult> run(const std::vector<Entry>& entries, Supervision how) const {
    std::map<std::string, EntryResult> results;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < entries.size(); ++i) order.push_back(i);
    how.done = [&](EntryResult result) {
      const std::string name = result.name;
      CHECK(results.emplace(name, std::move(result)).second);
    };
    CHECK(supervise(entries, order, workplace, how) == Supervised::all_done);
    return results;
  }

  References references{""};
  Workplace workplace;
};

} // namespace

TEST_CASE("a message arrives whole, in whatever pieces it is sent") {
  int pair[2];
  REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0);
  const std::string text(100'000, 'x');
  MessageReader reader;
  const std::uint64_t length = text.size();
  const std::string bytes = std::string(reinterpret_cast<const char*>(&length), sizeof length) + text;
  for (std::size_t at = 0; at < bytes.size(); at += 3001) {
    const std::string piece = bytes.substr(at, 3001);
    REQUIRE(write(pair[1], piece.data(), piece.size()) == static_cast<ssize_t>(piece.size()));
    CHECK(reader.read_from(pair[0]) == MessageReader::Channel::open);
    if (at + 3001 < bytes.size()) CHECK_FALSE(reader.next());
  }
  CHECK(reader.next() == text);
  CHECK_FALSE(reader.next());
  close(pair[1]);
  CHECK(reader.read_from(pair[0]) == MessageReader::Channel::closed);
  close(pair[0]);
}

TEST_CASE("each entry is done once, by one worker or by several") {
  const Place place;
  std::vector<Entry> entries;
  for (int i = 0; i < 20; ++i) entries.push_back(place.entry("e" + std::to_string(i)));
  entries[3].action = Action::bench; // alone, at the end
  for (const int jobs : {1, 3}) {
    const auto results = place.run(entries, {.jobs = jobs, .limits = {}, .done = {}});
    CHECK(results.size() == 20);
    for (const auto& result : results)
      CHECK_MESSAGE(result.second.state == State::done, result.first << ": " << result.second.message);
    CHECK(results.at("e3").frame_ms > 0);
  }
}

TEST_CASE("what takes too long or too much memory ends alone, and is reported as that") {
  const Place place;
  Entry slow = place.entry("slow"), large = place.entry("large");
  slow.precision = Precision::exact, slow.size = PixelSize{4000, 4000}, slow.timeout_seconds = 0.5;
  large.size = PixelSize{8000, 8000}, large.max_memory_mib = 64;
  const auto results =
      place.run({place.entry("a"), slow, large, place.entry("b")}, {.jobs = 2, .limits = {}, .done = {}});
  CHECK(results.at("slow").state == State::timed_out);
  CHECK(results.at("slow").message == "ended after 0.5 s");
  CHECK(results.at("large").state == State::out_of_memory);
  CHECK(results.at("a").state == State::done);
  CHECK(results.at("b").state == State::done);
}

TEST_CASE("a worker that is killed is replaced, and what it was at is reported") {
  const Place place;
  Entry slow = place.entry("slow");
  slow.precision = Precision::exact, slow.size = PixelSize{4000, 4000};
  const std::vector<Entry> entries = {slow};
  Worker worker(entries, place.workplace, {}, 0);
  REQUIRE(worker.begin(0, slow));
  REQUIRE(kill(worker.process(), SIGKILL) == 0);
  CHECK(worker.end(Worker::How::by_itself).signal == SIGKILL);
  CHECK_FALSE(worker.begin(0, slow));
}

TEST_CASE("a worker ends when nobody asks it any more, though another was forked after it") {
  const Place place;
  const std::vector<Entry> entries = {place.entry("a")};
  Worker first(entries, place.workplace, {}, 0), second(entries, place.workplace, {}, 0);
  const Ending ending = first.end(Worker::How::by_itself);
  CHECK(ending.signal == 0);
  CHECK(ending.exit_code == 0);
}
