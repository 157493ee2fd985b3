// refraster suite: what its commands have in common.

#include "app/arguments.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/suite/suite_commands.h"
#include "app/usage_error.h"
#include "bench/machine/cpus.h"
#include "io/file/input_file.h"
#include "io/file/nearest.h"
#include "io/file/text.h"
#include "io/json/json.h"
#include "suite/file/suite_reader.h"
#include "suite/run/program.h"

#include <algorithm>
#include <set>

namespace refraster {
namespace {

using suite::Entry;

/// The same option, by which it is noted that it is there.
Option noted(Option option, std::vector<std::string>& given) {
  option.read = [read = option.read, name = option.name, &given](const std::string& text) {
    given.push_back(name);
    return read(text);
  };
  return option;
}

/// Whether a file is a suite, and not a scene: by its key "entries".
bool is_suite_file(const std::string& path) {
  constexpr std::string_view key = "entries";
  if (extension(path) != "json") return false;
  std::string text;
  try {
    text = read_file(path, "a suite file", JsonDocument::max_bytes);
    const JsonDocument document(path, text);
    for (JsonIndex i = document[0].first_child; i; i = document[i].next)
      if (document[i].key == key) return true;
    return false;
  } catch (const InputError&) { // not readable: then what is wrong is said by whoever it is meant for
    return text.find("\"entries\"") != std::string::npos;
  }
}

void check_only(const std::vector<std::string>& only, const std::vector<Entry>& entries) {
  std::set<std::string_view> known;
  for (const Entry& entry : entries) {
    known.insert(entry.name);
    known.insert(entry.tags.begin(), entry.tags.end());
  }
  for (const std::string& word : only)
    if (!known.contains(word))
      throw UsageError("--only", in_quotes(word),
                       "a name or a tag of an entry" + did_you_mean({known.begin(), known.end()}, word));
}

} // namespace

OptionGroup suite_options(SuiteArguments& a) {
  const auto add_only = [&a](const std::string& text) -> std::optional<ValueFault> {
    for (const std::string_view word : split(text, ',')) a.only.emplace_back(word);
    return std::nullopt;
  };
  return {
      "Suite",
      {arguments("SUITE.json|SCENE", a.files, "a suite file, or scene files, models and patterns of them"),
       folder_option("--references", a.references, "folder of references, in place of the suite file's; docs/suite.md"),
       value_option("--only", "NAME|TAG,…", "only entries of this name, or with this tag", add_only)}};
}

OptionGroup entry_options(SuiteArguments& a) {
  std::vector<Option> options = {
      size_option(a.picture),
      samples_option(a.picture, "samples a pixel"),
      srgb_option(a.picture, "apply the sRGB curve"),
      linear_option(a.picture),
      enum_option("--precision", a.common.precision, "number type of shading; `refraster list precisions`"),
      enum_option("--action", a.common.action, "what is done with each scene"),
      text_option("--device", "NAME|FILE", a.common.device, "profile of a device, for verify; who draws, for gl"),
      parsed_option("--max-abs", "X", a.common.limits.compare.max_abs, distance_from, "a number >= 0",
                    "largest difference of a value that is allowed, in levels of 1/255"),
      parsed_option("--max-rms", "X", a.common.limits.compare.max_rms, distance_from, "a number >= 0",
                    "largest root mean square difference that is allowed, in levels"),
      parsed_option("--max-count", "N", a.common.limits.compare.max_count, count_from, "a whole number >= 0",
                    "so many pixels may differ by more than --max-abs, or at all"),
      number_option("--timeout", a.common.timeout_seconds, Range{0, 1e6, Ends::excluded},
                    "seconds after which an entry is ended"),
      outside_option(a.common.outside)};
  for (Option& option : options) option = noted(std::move(option), a.given);
  return {"Of scenes, where there is no suite file", std::move(options)};
}

std::vector<Option> work_options(SuiteArguments& a) {
  return {number_option("--jobs", a.jobs, Range{0, double(limit::threads.value)},
                        "entries at a time; 0: as many as this machine has processors"),
          parsed_option("--max-memory", "SIZE", a.max_memory, memory_from, "a size of at least 64M, as 512M or 2G",
                        "most memory of all entries at a time together")
              .by_default("what there is"),
          quiet_option(a.diagnostics)};
}

suite::Suite suite_of(const SuiteArguments& a) {
  suite::Suite suite;
  if (a.files.size() == 1 && is_suite_file(a.files.front())) {
    if (!a.given.empty()) throw UsageError(a.given.front(), "is for scenes; a suite file says it for its entries");
    suite = suite::read_suite(a.files.front());
  } else {
    Entry common = a.common;
    if (a.picture.size) common.size = suite::PixelSize{a.picture.size->width, a.picture.size->height};
    common.samples = a.picture.samples;
    common.transfer = a.picture.transfer;
    suite = suite::suite_of_scenes(a.files, common);
  }
  if (!a.references.empty()) suite.references = a.references;
  check_only(a.only, suite.entries);
  return suite;
}

void fill_request(suite::SuiteRequest& request, const SuiteArguments& a) {
  const auto processors = static_cast<int>(bench::usable_cpus().size());
  request.suite = suite_of(a);
  request.only = a.only;
  request.jobs = a.jobs > 0 ? a.jobs : processors;
  request.memory_bytes = a.max_memory > 0 ? a.max_memory : suite::available_memory_bytes();
  const int workers = std::clamp(static_cast<int>(std::min<std::size_t>(request.suite.entries.size(), 1024)), 1,
                                 suite::jobs_within(request.jobs, request.memory_bytes));
  request.threads = std::max(1, processors / workers);
  request.limits = {set_memory_limit, clear_memory_limit};
  request.stop = &interrupted();
}

Command suite_command() {
  return {.name = "suite",
          .meaning = "Many scenes against their references",
          .commands = {suite_run_command(), suite_update_command(), suite_merge_command()}};
}

} // namespace refraster
