#pragma once
// What is known of a run while it goes on: a file to which each result is appended as soon as it is there. Each program
// has its own, so that several may share a folder; what another writes is never touched while it may still write.

#include "suite/entry/result.h"

#include "raster/stopwatch.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace refraster::suite {

/// What a run is about, at the beginning of its journal.
struct RunHeader {
  std::string suite;              // its file; empty: of the command line
  std::vector<std::string> names; // of all its entries, those of other shards too
};

/// Records are written as one line `refraster-journal KIND BYTES SHA256`, as many bytes, and a line end. One that is
/// cut off, by a full disk or the end of its program, is seen by its digest, and is no record. Nothing is ever changed
/// that stands there.
class Journal {
public:
  /// In the folder journal/ of the results, under a name that nothing else has. Throws OutputError.
  Journal(const std::string& results, const RunHeader& header);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Throws OutputError. What was added is on disk a second later at the latest, if anything else is added then.
  void add(const EntryResult& result);
  /// Notes that this process writes files too: what it leaves if it is killed can then be told from what others write.
  void add_process(int process);
  /// To be called once all are added: all of it is on disk, and others may do away with the file.
  void finish();

  const std::string& path() const { return path_; }

private:
  void append(std::string_view kind, std::string_view bytes);
  void flush();

  std::string path_;
  int descriptor_ = -1;
  Stopwatch since_flush_;
};

/// What the journals of a folder say.
struct KnownResults {
  std::map<std::string, EntryResult> latest;  // by name
  std::vector<EntryResult> all;               // those of every journal, in the order of their files
  std::set<std::string> names;                // of the entries of the suites that they are of
  std::string suite;                          // its file, of the last journal that says one
  std::vector<std::string> notes;             // on what cannot be read
  std::vector<int> gone;                      // processes that have ended without an end of their run: on this machine
  std::map<std::string, std::uint64_t> sizes; // of the files that were read, in bytes: whether anything came since
};

/// Total: what is not there, cut off or corrupt is left out, and noted where it is no usual end. Of several results of
/// one entry the last counts.
KnownResults read_journals(const std::string& results);

/// Removes journals that are finished, or whose program has ended on this machine, and of which every entry is in
/// `own`, but for that one: what they say is known.
void remove_superseded(const std::string& results, const std::string& own);

/// Removes what processes that are gone have left amid writing a file (AtomicFile), in this folder and those below.
void remove_leftovers(const std::string& results, const std::vector<int>& gone);

inline constexpr const char* journal_folder = "journal";

} // namespace refraster::suite
