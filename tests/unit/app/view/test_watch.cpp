// Files that may change.

#include "app/view/watch.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {
namespace fs = std::filesystem;

struct Watched {
  TemporaryFolder folder;
  std::string scene = folder.path / "scene.json", mesh = folder.path / "mesh.obj";
  FileWatch watch;

  Watched() {
    save_text(scene, "one");
    watch.set({scene, mesh}); // the mesh is not there
  }
};

} // namespace

TEST_CASE("a file that nobody touches has not changed") {
  Watched w;
  for (int i = 0; i < 10; ++i) CHECK_FALSE(w.watch.has_changed(i));
}

TEST_CASE("a change is reported once, when it has been quiet for a moment") {
  Watched w;
  save_text(w.scene, "another text");
  CHECK_FALSE(w.watch.has_changed(1));
  save_text(w.scene, "and another one");
  CHECK_FALSE(w.watch.has_changed(1.2));
  CHECK_FALSE(w.watch.has_changed(1.4)); // 0.2 s after the second
  CHECK(w.watch.has_changed(1.2 + quiet_seconds));
  CHECK_FALSE(w.watch.has_changed(5));
}

TEST_CASE("a file that comes, goes, or is replaced by one of the same size has changed") {
  Watched w;
  save_text(w.mesh, "v");
  CHECK_FALSE(w.watch.has_changed(1));
  CHECK(w.watch.has_changed(2));
  save_text(w.scene + ".new", "two"); // as editors and our own writers do
  fs::rename(w.scene + ".new", w.scene);
  CHECK_FALSE(w.watch.has_changed(3));
  CHECK(w.watch.has_changed(4));
  fs::remove(w.mesh);
  CHECK_FALSE(w.watch.has_changed(5));
  CHECK(w.watch.has_changed(6));
}

TEST_CASE("what changes while files are read is seen afterwards") {
  Watched w;
  save_text(w.scene, "while it is read");
  w.watch.set({w.scene, w.mesh}); // as after reading
  CHECK_FALSE(w.watch.has_changed(1));
  CHECK(w.watch.has_changed(2));
}
