#include "suite/run/suite_run.h"

#include <refraster/notes.h>

#include "io/file/build_info.h"
#include "suite/actions/actions.h"
#include "suite/actions/input_digests.h"
#include "suite/actions/run_entry.h"
#include "suite/results/results_folder.h"
#include "suite/run/program.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

namespace refraster::suite {
namespace {

namespace fs = std::filesystem;

Workplace workplace_of(const SuiteRequest& request, const References& references, const std::vector<Entry>& entries) {
  Workplace workplace;
  workplace.references = &references;
  workplace.threads = request.threads;
  workplace.program = program_digest();
  for (const Entry& entry : entries)
    if (entry.needs_gl() && !workplace.drivers.contains(entry.device))
      workplace.drivers[entry.device] = driver_of(entry.device);
  return workplace;
}

Supervision supervision_of(const SuiteRequest& request) {
  return {.jobs = jobs_within(request.jobs, request.memory_bytes),
          .memory_bytes = request.memory_bytes,
          .limits = request.limits,
          .stop = request.stop,
          .done = {},
          .started = {}};
}

/// Whether an earlier result still holds.
bool still_holds(const EntryResult& known, const Entry& entry, const Workplace& workplace, Reuse reuse,
                 CurrentDigests& digests) {
  if (known.settings != settings_of(entry, workplace) || !files_are_there(workplace.results, known)) return false;
  if (!known.inputs.empty()) return digests.are_current(known.inputs);
  return reuse == Reuse::resume && known.state != State::missing && known.state != State::unwritable;
}

/// Files of an earlier result that this one does not name.
void remove_stale_files(const std::string& folder, const EntryResult& result) {
  const std::string image = std::string(images_folder) + "/" + result.name;
  for (const std::string& file :
       {image + ".png", image + ".difference.png", std::string(pages_folder) + "/" + result.name + ".html"}) {
    if (file == result.image || file == result.difference || file == result.page) continue;
    std::error_code ignored;
    fs::remove(fs::path(folder) / file, ignored);
  }
}

/// How much of the work is done, by its cost.
class DoneCost {
public:
  DoneCost(const std::vector<double>& costs, const std::vector<std::size_t>& to_do,
           const std::function<void(double)>& progress)
      : progress_(progress) {
    for (const std::size_t i : to_do) all_ += costs[i];
  }
  void add(double cost) {
    done_ += cost;
    if (progress_ && all_ > 0) progress_(std::min(done_ / all_, 1.0));
  }

private:
  const std::function<void(double)>& progress_;
  double all_ = 0, done_ = 0;
};

std::map<std::string, std::size_t> places_of(const std::vector<Entry>& entries) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < entries.size(); ++i) places[entries[i].name] = i;
  return places;
}

} // namespace

std::vector<Entry> chosen_entries(const std::vector<Entry>& entries, const std::vector<std::string>& only) {
  if (only.empty()) return entries;
  std::vector<Entry> chosen;
  std::copy_if(entries.begin(), entries.end(), std::back_inserter(chosen), [&](const Entry& entry) {
    return std::any_of(only.begin(), only.end(), [&](const std::string& word) {
      return word == entry.name || std::find(entry.tags.begin(), entry.tags.end(), word) != entry.tags.end();
    });
  });
  return chosen;
}

RunOutcome run_suite(const RunRequest& request) {
  const Stopwatch stopwatch;
  RunOutcome outcome;
  const References references(request.suite.references);
  const std::vector<Entry> entries = chosen_entries(request.suite.entries, request.only);
  const std::vector<double> costs = entry_costs(entries, references);
  const std::vector<std::size_t> own = entries_of(request.shard, entries, costs);
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);

  prepare_results(request.results);
  Workplace workplace = workplace_of(request, references, entries);
  workplace.results = request.results;
  KnownResults known = read_journals(request.results);
  remove_leftovers(request.results, known.gone);
  if (request.reuse == Reuse::none) known.latest.clear();
  outcome.notes = known.notes;
  Journal journal(request.results, {request.suite.path, names});
  std::vector<std::size_t> to_do;
  std::vector<double> expected_seconds = costs;
  CurrentDigests digests;
  for (const std::size_t i : own) {
    const auto found = known.latest.find(entries[i].name);
    if (found != known.latest.end()) expected_seconds[i] = found->second.seconds;
    if (found == known.latest.end() || !still_holds(found->second, entries[i], workplace, request.reuse, digests)) {
      to_do.push_back(i);
      continue;
    }
    EntryResult result = found->second;
    result.tags = entries[i].tags; // which decide nothing
    result.from = ResultFrom::cache;
    journal.add(result);
    outcome.own.entries.push_back(std::move(result));
  }
  // The longest first: the last worker ends soon after the others.
  std::stable_sort(to_do.begin(), to_do.end(),
                   [&](std::size_t a, std::size_t b) { return expected_seconds[a] > expected_seconds[b]; });

  const std::map<std::string, std::size_t> places = places_of(entries);
  DoneCost progress(expected_seconds, to_do, request.progress);
  Supervision supervision = supervision_of(request);
  supervision.done = [&](EntryResult result) {
    const std::size_t i = places.at(result.name);
    if (result.settings.empty()) result.settings = settings_of(entries[i], workplace);
    remove_stale_files(request.results, result);
    journal.add(result);
    progress.add(expected_seconds[i]);
    outcome.own.entries.push_back(std::move(result));
  };
  supervision.started = [&](int process) { journal.add_process(process); };
  outcome.ended = supervise(entries, to_do, workplace, supervision);
  outcome.own.suite = request.suite.path;
  outcome.own.seconds = stopwatch.seconds();
  if (outcome.ended == Supervised::stopped) return outcome;
  outcome.own.sort();
  journal.finish();
  outcome.joint = write_joint_results(request.results, outcome.own, names);
  remove_superseded(request.results, journal.path());
  return outcome;
}

UpdateOutcome update_suite(const SuiteRequest& request, const std::string& reason) {
  UpdateOutcome outcome;
  const References old(request.suite.references);
  std::vector<Entry> entries = chosen_entries(request.suite.entries, request.only);
  std::erase_if(entries, [](const Entry& entry) { return entry.action != Action::compare; });
  std::error_code error;
  fs::create_directories(old.folder(), error);
  if (!fs::is_directory(old.folder())) throw OutputError(old.folder(), "it is no folder, and none can be made there");
  Workplace workplace = workplace_of(request, old, entries);
  workplace.purpose = Purpose::update;
  const std::map<std::string, std::size_t> places = places_of(entries);
  const std::vector<double> costs = entry_costs(entries, old);
  std::vector<std::size_t> all(entries.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  DoneCost progress(costs, all, request.progress);
  Supervision supervision = supervision_of(request);
  supervision.done = [&](EntryResult result) {
    const Entry& entry = entries[places.at(result.name)];
    progress.add(costs[places.at(result.name)]);
    if (result.state != State::equal && result.state != State::different) {
      outcome.failed.entries.push_back(std::move(result));
      return;
    }
    UpdatedReference one;
    one.name = result.name;
    const Reference* const before = old.find(result.name);
    if (before != nullptr) one.before = *before;
    const ReferenceKind kind = entry.reference.value_or(before != nullptr ? before->kind : ReferenceKind::image);
    one.now = {kind,   result.image_sha256, result.width,  result.height, this_build().version, result.precision,
               reason, result.finished,     result.seconds};
    one.change = before == nullptr ? Change::added : result.state == State::equal ? Change::same : Change::changed;
    one.max_levels = result.max_levels, one.pixels_over = result.pixels_over;
    outcome.updated.push_back(std::move(one));
  };
  outcome.ended = supervise(entries, all, workplace, supervision);
  std::sort(outcome.updated.begin(), outcome.updated.end(),
            [](const UpdatedReference& a, const UpdatedReference& b) { return a.name < b.name; });
  const bool is_stored = outcome.ended == Supervised::all_done && outcome.failed.entries.empty();
  outcome.failed.sort();
  if (is_stored && std::any_of(outcome.updated.begin(), outcome.updated.end(),
                               [](const UpdatedReference& one) { return one.change != Change::same; }))
    store_references(old, outcome.updated);
  remove_waiting(old.folder(), is_stored ? References(old.folder()).all() : old.all());
  return outcome;
}

} // namespace refraster::suite
