// Parts of a suite.

#include "suite/shards/shard.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace refraster::suite;

namespace {

std::vector<Entry> numbered_entries(int count) {
  std::vector<Entry> entries;
  for (int i = 0; i < count; ++i) {
    Entry entry;
    entry.name = "e" + std::to_string(i);
    entry.size = PixelSize{10 * (1 + i % 7), 10};
    entries.push_back(entry);
  }
  return entries;
}

} // namespace

TEST_CASE("the parts of a suite are all of it, each entry once, whatever order its entries have") {
  const std::vector<Entry> entries = numbered_entries(50);
  std::vector<Entry> reversed(entries.rbegin(), entries.rend());
  const References none("");
  for (const int parts : {1, 2, 3, 7, 60}) {
    std::set<std::string> all;
    for (int part = 1; part <= parts; ++part) {
      const auto names = [&](const std::vector<Entry>& of) {
        std::set<std::string> result;
        for (const std::size_t i : entries_of({part, parts}, of, entry_costs(of, none))) result.insert(of[i].name);
        return result;
      };
      const std::set<std::string> here = names(entries);
      CHECK(here == names(reversed));
      for (const std::string& name : here) CHECK(all.insert(name).second);
    }
    CHECK(all.size() == entries.size());
  }
}

TEST_CASE("no part has much more to do than another") {
  const std::vector<Entry> entries = numbered_entries(50);
  const std::vector<double> costs = entry_costs(entries, References(""));
  std::vector<double> sums;
  for (int part = 1; part <= 4; ++part) {
    double sum = 0;
    for (const std::size_t i : entries_of({part, 4}, entries, costs)) sum += costs[i];
    sums.push_back(sum);
  }
  // The longest entry first to who has least: two parts differ by at most one entry.
  CHECK(*std::max_element(sums.begin(), sums.end()) - *std::min_element(sums.begin(), sums.end()) <=
        *std::max_element(costs.begin(), costs.end()));
}
