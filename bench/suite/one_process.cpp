// one_process REFERENCES WIDTH HEIGHT SCENE…: the work of a suite's entries in this process, one after the other,
// without workers, journal, cache, pages.

#include "suite/actions/run_entry.h"
#include "suite/file/suite_reader.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace refraster::suite;
  if (argc < 5) return 2;
  Entry common;
  common.size = PixelSize{std::atoi(argv[2]), std::atoi(argv[3])};
  const Suite suite = suite_of_scenes({argv + 4, argv + argc}, common);
  const References references(argv[1]);
  Workplace workplace;
  workplace.references = &references;
  for (const Entry& entry : suite.entries)
    if (const EntryResult result = run_entry(entry, workplace); result.state != State::equal) {
      std::fprintf(stderr, "%s: %s\n", entry.name.c_str(), result.message.c_str());
      return 1;
    }
}
