// Prints what faults were made, how often, and what was left on disk.
//
//     fault_table [calls | kills | random | allocations | signals | disks ...]    all of them by default

#include "tests/system/faults/disks.h"
#include "tests/system/faults/fault_runs.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h> // for the checks of tests/support/program/program.cpp

int main(int argc, char** argv) try {
  using namespace refraster;
  doctest::Context context;
  context.setAsDefaultForAssertsOutOfTestCases();
  context.setAssertHandler([](const doctest::AssertData& data) {
    std::fprintf(stderr, "%s\n", data.m_expr);
    std::exit(1);
  });
  std::vector<FaultRow> rows;
  const auto add = [&](const std::vector<FaultRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
    for (const FaultRow& row : more)
      for (const std::string& wrong : row.wrong) std::fprintf(stderr, "%s: %s\n", row.fault.c_str(), wrong.c_str());
  };
  const auto wanted = [&](std::string_view part) {
    return argc == 1 || std::find(argv + 1, argv + argc, part) != argv + argc;
  };
  if (wanted("calls")) add(failing_calls(Effort::thorough));
  if (wanted("kills")) add(killed_at_calls(Effort::thorough));
  if (wanted("random")) add(killed_at_random(300));
  if (wanted("allocations")) add(failing_allocations(Effort::thorough));
  if (wanted("signals")) add(interrupted_runs(Effort::thorough));
  if (wanted("disks")) add(bad_disks()); // last: it goes to a place of its own for mounts
  std::fputs(table_of(rows).c_str(), stdout);
  for (const FaultRow& row : rows)
    if (!row.wrong.empty()) return 1;
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
