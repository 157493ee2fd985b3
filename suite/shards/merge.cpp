#include "suite/shards/merge.h"

#include <refraster/notes.h>

#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "suite/results/results_folder.h"

#include <algorithm>
#include <map>
#include <set>

namespace refraster::suite {
namespace {

/// A result, and the folder that it is from.
struct Placed {
  EntryResult result;
  std::string folder;
};

/// Contents of the files alone: folders differ from machine to machine.
std::vector<std::string> contents_of(const EntryResult& result) {
  std::vector<std::string> digests;
  for (const InputDigest& input : result.inputs) digests.push_back(input.sha256);
  std::sort(digests.begin(), digests.end());
  return digests;
}

/// What two results of one entry say against each other; empty if nothing.
std::string contradiction(const Placed& a, const Placed& b) {
  const EntryResult &one = a.result, &other = b.result;
  if (!facts_of(one.state).is_repeatable || !facts_of(other.state).is_repeatable) return {};
  const std::string where = one.name + ": " + a.folder + " and " + b.folder + " ";
  if (one.scene != other.scene || one.action != other.action) return where + "have different entries of this name";
  if (contents_of(one) != contents_of(other)) return where + "have it of different files";
  if (one.state != other.state)
    return where + "disagree: " + std::string(facts_of(one.state).name) + " and " +
           std::string(facts_of(other.state).name);
  if (one.image_sha256 != other.image_sha256) return where + "have different images of the same files";
  return {};
}

void copy_file(const std::string& from, const std::string& to, const std::string& file) {
  if (file.empty() || canonical_path(from) == canonical_path(to)) return;
  write_file(to + "/" + file, read_file(from + "/" + file, "a file of results", UINT64_MAX));
}

} // namespace

Merged merge_results(const std::vector<std::string>& folders, const std::string& folder) {
  Merged merged;
  std::map<std::string, Placed> last;
  std::set<std::string> names;
  for (const std::string& from : folders) {
    const KnownResults known = read_journals(from);
    if (known.sizes.empty())
      throw InputError(InputFault{from, 0, 0, "", "no results", "a folder that `suite run` has written"});
    merged.notes.insert(merged.notes.end(), known.notes.begin(), known.notes.end());
    names.insert(known.names.begin(), known.names.end());
    if (!known.suite.empty()) merged.results.suite = known.suite;
    for (const auto& [name, result] : known.latest) {
      const Placed here{result, from};
      const auto [there, is_new] = last.try_emplace(name, here);
      if (is_new) continue;
      if (std::string text = contradiction(there->second, here); !text.empty())
        merged.results.contradictions.push_back(std::move(text));
      if (there->second.result.finished <= result.finished) there->second = here;
    }
  }
  prepare_results(folder);
  const std::vector<std::string> all(names.begin(), names.end());
  Journal journal(folder, {merged.results.suite, all});
  for (auto& [name, placed] : last) {
    if (!names.contains(name)) continue;
    EntryResult& result = placed.result;
    try {
      for (const std::string* const file : {&result.page, &result.image, &result.difference})
        copy_file(placed.folder, folder, *file);
    } catch (const InputError& error) {
      merged.notes.emplace_back(error.faults().front().text());
    }
    journal.add(result);
    merged.results.seconds += result.seconds;
    merged.results.entries.push_back(std::move(result));
  }
  journal.finish();
  merged.results = write_joint_results(folder, merged.results, all);
  return merged;
}

} // namespace refraster::suite
