#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "suite/file/suite_reader.h"
#include "suite/references/references.h"
#include "suite/results/journal.h"
#include "suite/results/results_folder.h"
#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include <filesystem>

namespace refraster::fuzz {

namespace fs = std::filesystem;

void read_suite_bytes(Bytes bytes) {
  const std::string path = file_of("suite.json", bytes);
  const PeakMemory peak;
  try {
    const JsonDocument document(path, read_file(path, "a suite file", JsonDocument::max_bytes));
    for (const suite::EntryText& entry : suite::suite_text(document).entries) {
      require(!entry.scenes.empty(), "an accepted entry has a scene");
      for (const suite::PixelSize& size : entry.sizes) require(size.width > 0 && size.height > 0, "a size has pixels");
      require(entry.common.timeout_seconds > 0, "a time is above 0");
    }
  } catch (const InputError& error) {
    require(!error.faults().empty(), "a refusal has faults");
  }
  // Each entry, 13 bytes to write, has a copy of the defaults' lists: eight of 256 values of 32 bytes.
  require_memory(peak, bytes.size(), 1 << 17, 8192);
}

void read_references_bytes(Bytes bytes) {
  const fs::path path = file_of(suite::references_file, bytes);
  const PeakMemory peak;
  try {
    const suite::References references(path.parent_path());
    for (const auto& [name, reference] : references.all())
      require(reference.sha256.size() == 64, "an accepted digest has 64 digits");
  } catch (const InputError& error) {
    require(!error.faults().empty(), "a refusal has faults");
  }
  require_memory(peak, bytes.size(), 1 << 17, 100);
}

void read_journal_bytes(Bytes bytes) {
  const fs::path folder = fs::path(file_of("other", bytes)).parent_path() / "results";
  suite::prepare_results(folder);
  const fs::path journal = folder / suite::journal_folder / "1-x-1.journal";
  fs::copy_file(file_of("j", bytes), journal, fs::copy_options::overwrite_existing);
  const PeakMemory peak;
  for (const auto& [name, result] : suite::read_journals(folder).latest) {
    require(name == result.name && !name.empty(), "a result has a name");
    require(result.seconds >= 0 && result.severity >= 0, "numbers are not below 0");
  }
  require_memory(peak, bytes.size(), 1 << 17, 200);
}

} // namespace refraster::fuzz
