#include "suite/results/journal.h"

#include <refraster/notes.h>

#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/json/report_parts.h"
#include "suite/results/result_json.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <functional>

#include <fcntl.h>
#include <unistd.h>

namespace refraster::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "refraster-journal ", ending = ".journal";
constexpr double seconds_between_flushes = 1; // what a power cut may cost

std::string host_name() {
  char name[256] = {};
  if (gethostname(name, sizeof name - 1) != 0) return "machine";
  std::string result = name;
  std::replace(result.begin(), result.end(), '/', '_');
  return result;
}

std::string header_text(const RunHeader& header) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.text_or_null("suite", header.suite);
    json.member("names", header.names);
  });
  return json.text();
}

struct Record {
  std::string_view kind, bytes;
};

/// The records of a file, up to the first that is not whole; and whether that is its end.
struct Records {
  std::vector<Record> list;
  bool is_whole = true, is_finished = false;
};

Records records_of(std::string_view text) {
  Records result;
  while (!text.empty()) {
    result.is_whole = false;
    const std::size_t line_end = text.find('\n');
    if (line_end == std::string_view::npos || !text.starts_with(magic)) return result;
    const std::string_view words = text.substr(magic.size(), line_end - magic.size());
    const std::size_t first = words.find(' '), second = words.find(' ', first + 1);
    if (first == std::string_view::npos || second == std::string_view::npos) return result;
    std::size_t size = 0;
    const auto [end, error] = std::from_chars(words.data() + first + 1, words.data() + second, size);
    if (error != std::errc() || end != words.data() + second) return result;
    if (text.size() < line_end + 1 || text.size() - line_end - 1 < size) return result;
    const std::string_view bytes = text.substr(line_end + 1, size);
    const bool is_right = text_sha256(bytes) == words.substr(second + 1);
    text.remove_prefix(std::min(line_end + 1 + size + 1, text.size()));
    // One in the middle costs itself alone: its length stands in its line.
    if (is_right) result.list.push_back({words.substr(0, first), bytes});
    result.is_whole = is_right || !text.empty();
    if (!is_right && !text.empty()) result.list.push_back({"corrupt", {}});
    result.is_finished = is_right && words.substr(0, first) == "end";
  }
  return result;
}

std::vector<fs::path> journals_in(const std::string& results) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator i(fs::path(results) / journal_folder, error), end; !error && i != end; i.increment(error))
    if (i->path().extension() == ending) paths.push_back(i->path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string text_of_journal(const fs::path& path) {
  try {
    return read_file(path, "a journal", UINT64_MAX);
  } catch (const InputError&) { // empty, or just removed by another program
    return {};
  }
}

void take_header(const std::string& path, std::string_view bytes, KnownResults& known) {
  const JsonDocument document(path, std::string(bytes));
  for (JsonIndex i = document[0].first_child; i; i = document[i].next) {
    if (document[i].key == "suite" && document[i].kind == JsonKind::string) known.suite = document[i].string;
    if (document[i].key == "names")
      for (JsonIndex j = document[i].first_child; j; j = document[j].next) known.names.emplace(document[j].string);
  }
}

/// Whether the program that wrote an unfinished journal has ended: known of this machine's alone.
bool writer_is_gone(const fs::path& path) {
  const std::string name = path.stem().string();
  const std::size_t at = name.rfind('-');
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data() + at + 1, name.data() + name.size(), process);
  if (error != std::errc() || process <= 0 || !name.substr(0, at).ends_with("-" + host_name())) return false;
  return kill(process, 0) != 0 && errno == ESRCH;
}

/// The processes that a journal names, if it was not finished and none of them lives: another one may have the number.
void take_processes(const fs::path& path, const Records& records, KnownResults& known) {
  if (records.is_finished || !writer_is_gone(path)) return;
  for (const Record& record : records.list) {
    int process = 0;
    if (record.kind != "process") continue;
    const auto [end, error] = std::from_chars(record.bytes.data(), record.bytes.data() + record.bytes.size(), process);
    if (error == std::errc() && process > 0 && kill(process, 0) != 0 && errno == ESRCH) known.gone.push_back(process);
  }
}

void take_records(const std::string& path, const Records& records, KnownResults& known) {
  std::size_t corrupt = records.is_whole ? 0 : 1;
  for (const Record& record : records.list) {
    try {
      if (record.kind == "corrupt") ++corrupt;
      if (record.kind == "run") take_header(path, record.bytes, known);
      if (record.kind != "result") continue;
      const JsonDocument document(path, std::string(record.bytes));
      if (std::optional<EntryResult> result = result_from(document, 0)) known.all.push_back(std::move(*result));
      else ++corrupt;
    } catch (const InputError&) {
      ++corrupt;
    }
  }
  if (corrupt > 0) known.notes.push_back(path + ": " + counted(corrupt, "record") + " cut off or corrupt, not used");
}

} // namespace

Journal::Journal(const std::string& results, const RunHeader& header) {
  const fs::path folder = fs::path(results) / journal_folder;
  std::error_code error;
  fs::create_directories(folder, error);
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  // In the order of their beginning, whoever looks at the folder.
  path_ = (folder / (format("%011lld.%09ld-", static_cast<long long>(now.tv_sec), now.tv_nsec) + host_name() + "-" +
                     std::to_string(getpid()) + std::string(ending)))
              .string();
  descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw OutputError(path_, std::strerror(errno));
  append("run", header_text(header));
  add_process(getpid());
  flush();
}

Journal::~Journal() {
  if (descriptor_ >= 0) close(descriptor_);
}

void Journal::append(std::string_view kind, std::string_view bytes) {
  std::string record(magic);
  record += kind;
  record += ' ' + std::to_string(bytes.size()) + ' ' + text_sha256(bytes) + '\n';
  record += bytes;
  record += '\n';
  std::string_view rest = record;
  while (!rest.empty()) {
    const ssize_t written = write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw OutputError(path_, std::strerror(written < 0 ? errno : ENOSPC));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

void Journal::flush() {
  if (fsync(descriptor_) != 0) throw OutputError(path_, std::strerror(errno));
  since_flush_ = Stopwatch();
}

void Journal::add(const EntryResult& result) {
  append("result", result_text(result));
  if (since_flush_.seconds() > seconds_between_flushes) flush();
}

void Journal::add_process(int process) {
  append("process", std::to_string(process));
}

void Journal::finish() {
  append("end", {});
  flush();
}

KnownResults read_journals(const std::string& results) {
  KnownResults known;
  for (const fs::path& path : journals_in(results)) {
    const std::string text = text_of_journal(path);
    known.sizes[path] = text.size();
    const Records records = records_of(text);
    take_records(path, records, known);
    take_processes(path, records, known);
  }
  // Journals are in the order of their beginning; where two programs worked at a time, of one entry the later result.
  for (const EntryResult& result : known.all) {
    EntryResult& there = known.latest[result.name];
    if (there.finished <= result.finished) there = result;
  }
  return known;
}

void remove_leftovers(const std::string& results, const std::vector<int>& gone) {
  if (gone.empty()) return;
  std::error_code error;
  for (fs::recursive_directory_iterator i(results, error), end; !error && i != end; i.increment(error)) {
    const std::string name = i->path().filename().string();
    std::error_code ignored;
    if (std::any_of(gone.begin(), gone.end(),
                    [&](int process) { return name.starts_with(temporary_name_prefix(process)); }))
      fs::remove(i->path(), ignored);
  }
}

void remove_superseded(const std::string& results, const std::string& own) {
  const auto names_of = [](const Records& records, const std::string& path) {
    KnownResults known;
    take_records(path, records, known);
    std::set<std::string> names;
    for (const EntryResult& result : known.all) names.insert(result.name);
    return names;
  };
  const std::string own_text = text_of_journal(own);
  const std::set<std::string> known = names_of(records_of(own_text), own);
  for (const fs::path& path : journals_in(results)) {
    if (path == own) continue;
    const std::string text = text_of_journal(path);
    const Records records = records_of(text);
    if (!records.is_finished && !writer_is_gone(path)) continue;
    const std::set<std::string> names = names_of(records, path);
    std::error_code ignored;
    if (std::includes(known.begin(), known.end(), names.begin(), names.end())) fs::remove(path, ignored);
  }
}

} // namespace refraster::suite
