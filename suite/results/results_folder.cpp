#include "suite/results/results_folder.h"

#include "io/file/atomic_file.h"
#include "suite/actions/actions.h"
#include "suite/results/wall.h"

#include <refraster/notes.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace refraster::suite {
namespace {

namespace fs = std::filesystem;

/// What the journals know, in the terms of a run.
RunResults joint(const KnownResults& known, const RunResults& own, const std::vector<std::string>& names) {
  RunResults results;
  results.suite = own.suite;
  results.seconds = own.seconds;
  results.contradictions = own.contradictions;
  results.entries = own.entries;
  std::set<std::string> there;
  for (const EntryResult& entry : own.entries) there.insert(entry.name);
  for (const std::string& name : names) {
    if (there.contains(name)) continue;
    EntryResult entry;
    if (const auto found = known.latest.find(name); found != known.latest.end()) {
      entry = found->second;
      entry.from = ResultFrom::cache;
    } else {
      entry.name = name;
      entry.message = facts_of(State::missing).meaning;
    }
    results.entries.push_back(std::move(entry));
  }
  results.sort();
  return results;
}

} // namespace

void prepare_results(const std::string& folder) {
  std::error_code error;
  for (const char* const below : {images_folder, pages_folder, journal_folder})
    fs::create_directories(fs::path(folder) / below, error);
  if (!fs::is_directory(fs::path(folder) / journal_folder))
    throw OutputError(folder, "it is no folder, and none can be made there");
}

void write_results(const std::string& folder, const RunResults& results) {
  write_file(folder + "/junit.xml", junit_xml(results));
  write_file(folder + "/index.html", wall_html(results));
  write_file(folder + "/results.json", results_json(results)); // last: where it is new, all are
}

RunResults write_joint_results(const std::string& folder, const RunResults& own,
                               const std::vector<std::string>& names) {
  while (true) {
    const KnownResults known = read_journals(folder);
    RunResults results = joint(known, own, names);
    write_results(folder, results);
    if (read_journals(folder).sizes == known.sizes) return results;
  }
}

bool files_are_there(const std::string& folder, const EntryResult& result) {
  return [&](std::initializer_list<std::string_view> files) {
    return std::all_of(files.begin(), files.end(), [&](std::string_view file) {
      std::error_code error;
      return file.empty() || fs::is_regular_file(fs::path(folder) / file, error);
    });
  }({result.page, result.image, result.difference});
}

} // namespace refraster::suite
