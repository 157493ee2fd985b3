#include "tests/system/faults/fault_runs.h"

#include "tests/system/faults/sandbox.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

namespace refraster {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Numbers of a call until one is not reached: the first of them and then ever fewer.
template <class Run>
void for_each_number(Effort effort, Run&& run) {
  const bool thorough = effort == Effort::thorough;
  const int close_together = thorough ? 40 : 3, growth = thorough ? 4 : 1;
  for (int n = 1; run(n); n += n < close_together ? 1 : n / growth) {
  }
}

/// A fault in every call of that name, in every command, with and without old files.
void everywhere(std::vector<FaultRow>& rows, const std::vector<std::unique_ptr<Sandbox>>& sandboxes, Effort effort,
                const std::string& title, const std::string& call, const std::string& how, int error) {
  FaultRow row;
  row.fault = title;
  for (const auto& sandbox : sandboxes)
    for (const Before before : {Before::old_files, Before::nothing}) {
      if (effort != Effort::thorough && before == Before::nothing && sandbox != sandboxes.front()) continue;
      for_each_number(effort, [&](int n) {
        const std::string fault = call + " " + std::to_string(n) + " " + how + " " + std::to_string(error);
        const bool reached = sandbox->run_with_fault(fault, before, row);
        if (reached && how == "kill") sandbox->run_again(row);
        return reached;
      });
    }
  rows.push_back(std::move(row));
}

std::vector<std::unique_ptr<Sandbox>> all_sandboxes(Effort effort) {
  std::vector<std::unique_ptr<Sandbox>> sandboxes;
  for (WritingCommand& command : commands_that_write(effort))
    sandboxes.push_back(std::make_unique<Sandbox>(std::move(command)));
  return sandboxes;
}

} // namespace

std::vector<FaultRow> failing_calls(Effort effort) {
  std::vector<FaultRow> rows;
  const auto sandboxes = all_sandboxes(effort);
  const auto fail = [&](const std::string& call, const std::string& how, int error, const std::string& title) {
    everywhere(rows, sandboxes, effort, title, call, how, error);
  };
  fail("open", "once", EACCES, "n-th open: EACCES");
  fail("write", "on", ENOSPC, "n-th write and all after: ENOSPC");
  fail("write", "short", 0, "n-th write: only half of it");
  fail("fsync", "once", EIO, "n-th fsync: EIO");
  fail("rename", "once", EIO, "n-th rename: EIO");
  if (effort == Effort::quick) return rows;
  fail("open", "once", EMFILE, "n-th open: EMFILE");
  fail("open", "once", EOPNOTSUPP, "n-th open: EOPNOTSUPP (no files without a name)");
  fail("open", "once", EINTR, "n-th open: EINTR");
  fail("write", "once", EIO, "n-th write: EIO");
  fail("write", "once", EINTR, "n-th write: EINTR");
  fail("fsync", "once", ENOSPC, "n-th fsync: ENOSPC");
  fail("fsync", "once", EINTR, "n-th fsync: EINTR");
  fail("linkat", "once", EIO, "n-th linkat: EIO");
  fail("rename", "once", EACCES, "n-th rename: EACCES");
  fail("close", "once", EIO, "n-th close: EIO");
  fail("close", "once", EINTR, "n-th close: EINTR");
  const Environment network_disk({std::pair<std::string, std::string>("REFRASTER_NO_NAMELESS", "1")});
  fail("open", "once", EACCES, "no files without a name, n-th open: EACCES");
  fail("write", "on", ENOSPC, "no files without a name, n-th write and all after: ENOSPC");
  fail("fsync", "once", EIO, "no files without a name, n-th fsync: EIO");
  fail("rename", "once", EIO, "no files without a name, n-th rename: EIO");
  fail("close", "once", EIO, "no files without a name, n-th close: EIO");
  return rows;
}

std::vector<FaultRow> killed_at_calls(Effort effort) {
  std::vector<FaultRow> rows;
  const auto sandboxes = all_sandboxes(effort);
  for (const std::string call : {"open", "write", "fsync", "linkat", "rename", "close"})
    everywhere(rows, sandboxes, effort, "SIGKILL before the n-th " + call, call, "kill", 0);
  return rows;
}

std::vector<FaultRow> failing_allocations(Effort effort) {
  std::vector<FaultRow> rows;
  const auto sandboxes = all_sandboxes(Effort::quick); // drivers of OpenGL do not bear it
  everywhere(rows, sandboxes, effort, "n-th allocation of 16 KiB or more: none", "malloc", "once", 0);
  everywhere(rows, sandboxes, effort, "n-th and all after: none", "malloc", "on", 0);
  return rows;
}

std::vector<FaultRow> killed_at_random(int runs) {
  FaultRow row;
  row.fault = "SIGKILL at a random moment";
  Sandbox sandbox(
      {"render .png, depth .pfm, report",
       {"render", "s.json", "--size", "320x240", "-o", "out/o.png", "--aov", "depth,normal", "--report", "out/r.json"},
       {"o.png", "o.depth.pfm", "o.normal.pfm", "r.json"}});
  const auto start = Clock::now();
  sandbox.run_again(row);
  const double whole = seconds_since(start);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> moment(0, 1.1 * whole);
  for (int i = 0; i < runs; ++i) {
    const Before before = i % 2 == 0 ? Before::old_files : Before::nothing;
    sandbox.prepare(before);
    Running run(sandbox.folder(), sandbox.command().words);
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
    run.send(SIGKILL);
    sandbox.judge(run.wait(), before, row);
    if (i % 10 == 9) sandbox.run_again(row);
  }
  sandbox.run_again(row);
  return {row};
}

std::string table_of(const std::vector<FaultRow>& rows) {
  std::string text =
      "| fault | runs | exit 0 | exit 3, 4, 130 | killed | old files | new files | none, as before | whole, "
      "under a temporary name | wrong |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const FaultRow& row : rows) {
    text += "| " + row.fault;
    for (const int count : {row.runs, row.done, row.refused, row.killed, row.old_files, row.new_files, row.absent,
                            row.left_over, static_cast<int>(row.wrong.size())})
      text += " | " + std::to_string(count);
    text += " |\n";
  }
  return text;
}

} // namespace refraster
