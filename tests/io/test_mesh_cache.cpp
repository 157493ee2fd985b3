// Meshes that are kept: found by what is in their OBJ file, and believed only byte for byte.

#include "io/input_error.h"
#include "io/mesh_cache.h"
#include "io/obj_file.h"
#include "io/sha256.h"
#include "raster/primitives.h"
#include "tests/io/malformed_inputs.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

namespace refraster::test {
namespace {

namespace fs = std::filesystem;

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.normals == b.normals && a.uvs == b.uvs && a.triangles == b.triangles;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  return {fs::directory_iterator(folder), {}};
}

/// A folder with ball.obj and an empty cache.
struct CacheFolder : TemporaryFolder {
  const std::string obj = *this / "ball.obj", cache = *this / "cache";
  Mesh ball;

  CacheFolder() {
    write_obj(obj, sphere_mesh(12, 6));
    ball = read_obj(obj);
    check_cache_folder(cache);
  }
  Mesh read() const { return read_obj_by_cache(obj, cache, 0); }
  fs::path kept() const {
    REQUIRE(files_in(cache).size() == 1);
    return files_in(cache).front();
  }
  void keep_bytes(const std::string& bytes) const { std::ofstream(kept(), std::ios::binary) << bytes; }
  /// With the digest that makes these bytes look as if we had written them.
  void keep_with_digest(std::string bytes) const {
    Sha256 digest;
    const std::string sha256 = file_sha256(obj);
    digest.add(sha256.data(), sha256.size());
    digest.add(bytes.data(), bytes.size());
    const auto result = digest.result();
    bytes.append(reinterpret_cast<const char*>(result.data()), result.size());
    keep_bytes(bytes);
  }
};

constexpr std::size_t vertices_at = 24, triangles_at = 32, header_bytes = 40; // in a file

} // namespace

TEST_CASE("a mesh comes out of the cache bit for bit") {
  const CacheFolder folder;
  CHECK(same(folder.read(), read_obj(folder.obj)));
  CHECK(kept_mesh(folder.cache, file_sha256(folder.obj)));
  CHECK(same(folder.read(), read_obj(folder.obj)));
  // Without texture coordinates.
  Mesh plain = folder.ball;
  plain.uvs.clear();
  keep_mesh(folder.cache, "plain", plain);
  CHECK(same(*kept_mesh(folder.cache, "plain"), plain));
}

TEST_CASE("what was kept is read instead of the text, whatever the file's name; another text is another mesh") {
  const CacheFolder folder;
  keep_mesh(folder.cache, file_sha256(folder.obj), cube_mesh());
  CHECK(same(folder.read(), cube_mesh()));
  fs::copy_file(folder.obj, folder / "copy.obj");
  CHECK(same(read_obj_by_cache(folder / "copy.obj", folder.cache, 0), cube_mesh()));
  std::ofstream(folder.obj, std::ios::app) << "# a line more\n";
  CHECK(same(folder.read(), folder.ball));
  CHECK(files_in(folder.cache).size() == 2);
}

TEST_CASE("small files are not kept") {
  const CacheFolder folder;
  CHECK(same(read_obj_by_cache(folder.obj, folder.cache), folder.ball));
  CHECK(files_in(folder.cache).empty());
}

TEST_CASE("a kept file that is changed in any byte, cut or longer is not believed, and made again") {
  const CacheFolder folder;
  folder.read();
  const std::string sound = bytes_of(folder.kept()), sha256 = file_sha256(folder.obj);
  const auto check = [&](const std::string& bytes) {
    folder.keep_bytes(bytes);
    CHECK_FALSE(kept_mesh(folder.cache, sha256));
    CHECK(same(folder.read(), folder.ball));
    CHECK(bytes_of(folder.kept()) == sound);
  };
  for (std::size_t at = 0; at < sound.size(); at += at < header_bytes ? 1 : 97) {
    std::string changed = sound;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    check(changed);
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, header_bytes, sound.size() - 32, sound.size() - 1})
    check(sound.substr(0, size));
  check(sound + "x");
  check(sound + sound);
}

TEST_CASE("a kept file that lies is not believed either") {
  const CacheFolder folder;
  folder.read();
  const std::string whole = bytes_of(folder.kept()), sound = whole.substr(0, whole.size() - sha256_bytes);
  const std::string sha256 = file_sha256(folder.obj);
  folder.keep_with_digest(sound);
  CHECK(kept_mesh(folder.cache, sha256)); // the digest is right here
  const auto check = [&](std::size_t at, auto value) {
    std::string changed = sound;
    std::memcpy(&changed[at], &value, sizeof value);
    folder.keep_with_digest(changed);
    CHECK_FALSE(kept_mesh(folder.cache, sha256));
  };
  check(sound.size() - 4, static_cast<std::uint32_t>(folder.ball.positions.size())); // the last corner
  check(sound.size() - 4, 0xffffffffu);
  for (const std::uint64_t count : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 31, std::uint64_t{1} << 63,
                                    ~std::uint64_t{0}, (std::uint64_t{1} << 62) + folder.ball.positions.size()}) {
    check(vertices_at, count);
    check(triangles_at, count);
  }
  check(16, mesh_cache_version + 1);
  check(20, 0u);
  check(20, 2u);
}

TEST_CASE("a kept file under another mesh's name is not believed") {
  const CacheFolder folder;
  keep_mesh(folder.cache, "other", cube_mesh());
  CHECK(same(*kept_mesh(folder.cache, "other"), cube_mesh()));
  const fs::path other = folder.kept();
  folder.read();
  for (const fs::path& file : files_in(folder.cache))
    if (file != other) fs::copy_file(other, file, fs::copy_options::overwrite_existing);
  CHECK(same(folder.read(), folder.ball));
  CHECK(same(*kept_mesh(folder.cache, file_sha256(folder.obj)), folder.ball));
}

TEST_CASE("several may read and keep at once") {
  const CacheFolder folder;
  std::atomic<int> right{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 20; ++j) {
        right += same(folder.read(), folder.ball);
        std::error_code gone_already;
        if (j % 3 == 0) fs::remove_all(folder.cache + "/" + file_sha256(folder.obj) + ".1.mesh", gone_already);
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(right == 80);
  folder.read();
  CHECK(files_in(folder.cache).size() == 1); // no temporary files
}

TEST_CASE("faults of the text are told with a cache too, and nothing is kept") {
  const CacheFolder folder;
  write_files(folder.path, {{"bad.obj", "v 0 0 0\nf 1 2 3\n"}});
  CHECK_THROWS_AS(read_obj_by_cache(folder / "bad.obj", folder.cache, 0), InputError);
  CHECK_THROWS_AS(read_obj_by_cache(folder / "none.obj", folder.cache, 0), InputError);
  CHECK(files_in(folder.cache).empty());
}

TEST_CASE("a cache that cannot be written to is told") {
  const CacheFolder folder;
  CHECK_THROWS_AS(check_cache_folder(folder.obj), OutputError);
  CHECK_THROWS_AS(check_cache_folder(folder.obj + "/below"), OutputError);
  CHECK_THROWS_AS(read_obj_by_cache(folder.obj, folder.obj, 0), OutputError);
  check_cache_folder(folder / "a/b/c");
  CHECK(fs::is_directory(folder / "a/b/c"));
  CHECK(files_in(folder / "a/b/c").empty());
}

TEST_CASE("mesh_cache_version is that of the meshes that are made today") {
  // Shared and flat corners, a concave polygon, missing normals and texture coordinates. If the digest below changes,
  // read_obj makes another mesh of the same text, and kept ones are old: raise mesh_cache_version.
  const TemporaryFolder folder;
  write_files(folder.path, {{"m.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nv 0 0 3\nvt 0.25 0.5\nvn 0 0 1\n"
                                      "s 1\nf 1/1 2/1 3/1 4/1 5/1\ns off\nf 1 6 2\nf 1//1 2//1 3//1\ns 2\nf 1 5 6\n"}});
  keep_mesh(folder.path, "m", read_obj(folder / "m.obj"));
  CHECK(mesh_cache_version == 2);
  CHECK(file_sha256(folder / "m.2.mesh") == "ed2e42f7e45e8bc956433245140173344b1643c41096b30602e385cb226ef0da");
}

} // namespace refraster::test
