#include "suite/references/update.h"

#include "io/file/atomic_file.h"
#include "io/file/text.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace refraster::suite {
namespace {
namespace fs = std::filesystem;

std::string pixels_text(const Reference& reference) {
  return format("%dx%d", reference.width, reference.height);
}

std::string change_text(const UpdatedReference& one) {
  if (one.change == Change::added) return "new, " + pixels_text(one.now);
  if (one.before.kind != one.now.kind)
    return "was " + std::string(name_of(one.before.kind)) + ", is " + std::string(name_of(one.now.kind));
  if (one.before.width != one.now.width || one.before.height != one.now.height)
    return "was " + pixels_text(one.before) + ", is " + pixels_text(one.now);
  if (one.now.kind == ReferenceKind::digest) return "other bits; no image of the old ones is kept";
  return format("%s, by at most %.3g levels", counted(one.pixels_over, "pixel").c_str(), one.max_levels) + " differ";
}
} // namespace

void store_references(const References& old, const std::vector<UpdatedReference>& updated) {
  std::map<std::string, Reference> all = old.all();
  for (const UpdatedReference& one : updated)
    if (one.change != Change::same) all[one.name] = one.now;
  const fs::path folder = old.folder();
  write_file(folder / references_file, references_json(all)); // from here on the new ones count
  std::error_code error;
  for (const UpdatedReference& one : updated) {
    if (one.change == Change::same) continue;
    const fs::path image = folder / (one.name + ".png");
    if (one.now.kind == ReferenceKind::image) fs::rename(folder / waiting_name(one.name, one.now.sha256), image, error);
    else fs::remove(image, error);
    // What cannot be renamed is found where it is.
  }
}

void remove_waiting(const std::string& folder, const std::map<std::string, Reference>& all) {
  std::set<std::string> named;
  for (const auto& [name, reference] : all) named.insert(waiting_name(name, reference.sha256));
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const std::string name = i->path().filename();
    std::error_code ignored;
    if (name.ends_with(".new.png") && !named.contains(name)) fs::remove(i->path(), ignored);
  }
}

std::string update_text(const std::vector<UpdatedReference>& updated, const std::string& folder) {
  std::string text;
  std::size_t added = 0, changed = 0;
  for (const UpdatedReference& one : updated) {
    if (one.change == Change::same) continue;
    ++(one.change == Change::added ? added : changed);
    text += one.name + ": " + change_text(one) + "\n";
  }
  const std::size_t same = updated.size() - added - changed;
  return text + format("%zu added, %zu changed, %zu as before in %s\n", added, changed, same, folder.c_str());
}

} // namespace refraster::suite
