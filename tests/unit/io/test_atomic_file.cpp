#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/image/image_formats.h"
#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <unistd.h>

namespace refraster::test {
namespace fs = std::filesystem;
namespace {
std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()));
}
} // namespace

TEST_CASE("a file is there whole after commit, and not at all before") {
  const TemporaryFolder folder;
  AtomicFile file(folder / "f");
  file.write("hello ");
  file.write("world");
  file.seek(6);
  file.write("W");
  CHECK_FALSE(fs::exists(folder / "f"));
  file.commit();
  CHECK(read_file(folder / "f", "", 100) == "hello World");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("without commit nothing is left, and an older file is as it was") {
  const TemporaryFolder folder;
  write_file(folder / "f", "old");
  { AtomicFile(folder / "f").write("new"); }
  CHECK(read_file(folder / "f", "", 100) == "old");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a file that is replaced keeps its permissions, a symbolic link its target") {
  const TemporaryFolder folder;
  write_file(folder / "f", "old");
  fs::permissions(folder / "f", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("f", folder / "link");
  write_file(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_file(folder / "f", "", 100) == "new");
  CHECK((fs::status(folder / "f").permissions() & fs::perms::all) == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("a symbolic link to where nothing is yet stays one") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "inside");
  fs::create_symlink("inside/second", folder / "first");
  fs::create_symlink("f", folder / "inside/second");
  write_file(folder / "first", "new");
  CHECK(fs::is_symlink(folder / "first"));
  CHECK(fs::is_symlink(folder / "inside/second"));
  CHECK(read_file(folder / "inside/f", "", 100) == "new");
  CHECK(files_in(folder) == 2);
}

TEST_CASE("a symbolic link to itself cannot be written") {
  const TemporaryFolder folder;
  fs::create_symlink("f", folder / "f");
  CHECK_THROWS_AS(write_file(folder / "f", "new"), OutputError);
  CHECK(fs::is_symlink(folder / "f"));
}

TEST_CASE("a full device, a folder, and a folder that is not there cannot be written") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(write_file("/dev/full", "x"), "/dev/full: cannot write: No space left on device", OutputError);
  CHECK(fs::is_character_file("/dev/full"));
  CHECK_THROWS_AS(write_file(folder.path.string(), "x"), OutputError);
  CHECK_THROWS_AS(write_file(folder / "none/f", "x"), OutputError);
  CHECK(files_in(folder) == 0);
}

TEST_CASE("every format tells of a full device") {
  const TemporaryFolder folder;
  for (const ImageFormat& format : image_formats) {
    if (format.writes == ChannelCounts{}) continue;
    const std::string path = folder / "i." + std::string(format.extensions[0]);
    fs::create_symlink("/dev/full", path);
    if (can_write(format, rgb8_image)) CHECK_THROWS_AS(write_image(path, Image<std::uint8_t>(64, 64, 3)), OutputError);
    if (can_write(format, float_rgb_image))
      CHECK_THROWS_AS(write_image(path, Image<float>(64, 64, 3, 0.5f)), OutputError);
  }
}

TEST_CASE("a read-only folder cannot be written" * doctest::skip(geteuid() == 0)) { // root may write everywhere
  const TemporaryFolder folder;
  fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
  CHECK_THROWS_AS(write_file(folder / "f", "x"), OutputError);
  fs::permissions(folder.path, fs::perms::owner_all);
}

} // namespace refraster::test
