// Meshes that are kept: found by what is in their OBJ file, and believed only byte for byte.

#include <refraster/files.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>

#include "io/file/sha256.h"
#include "io/mesh/mesh_cache.h"
#include "tests/support/files/malformed_inputs.h"

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
  return a.positions == b.positions && a.normals == b.normals && a.uvs == b.uvs && a.colours == b.colours &&
         a.triangles == b.triangles;
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
  Mesh read() const { return read_obj_by_cache(obj, cache, {}, 0); }
  std::string key() const { return mesh_key(file_sha256(obj), {}); }
  fs::path cached() const {
    REQUIRE(files_in(cache).size() == 1);
    return files_in(cache).front();
  }
  void store_bytes(const std::string& bytes) const { std::ofstream(cached(), std::ios::binary) << bytes; }
  /// With the digest that makes these bytes look as if we had written them.
  void store_with_digest(std::string bytes) const {
    Sha256 digest;
    digest.add(key().data(), key().size());
    digest.add(bytes.data(), bytes.size());
    const auto result = digest.result();
    bytes.append(reinterpret_cast<const char*>(result.data()), result.size());
    store_bytes(bytes);
  }
};

constexpr std::size_t vertices_at = 24, uvs_at = 32, colours_at = 40, tangents_at = 48, triangles_at = 56,
                      header_bytes = 80; // in a file

} // namespace

TEST_CASE("a mesh comes out of the cache bit for bit") {
  const CacheFolder folder;
  CHECK(same(folder.read(), read_obj(folder.obj)));
  CHECK(cached_mesh(folder.cache, folder.key()));
  CHECK(same(folder.read(), read_obj(folder.obj)));
  // With texture coordinates for some vertices, or none.
  for (const std::size_t uvs : {folder.ball.uvs.size() / 2, std::size_t{0}}) {
    Mesh plain = folder.ball;
    plain.uvs.resize(uvs);
    store_mesh(folder.cache, "plain", {plain, {}});
    CHECK(same(cached_mesh(folder.cache, "plain")->mesh, plain));
  }
}

TEST_CASE("what was kept is read instead of the text, whatever the file's name; another text is another mesh") {
  const CacheFolder folder;
  store_mesh(folder.cache, folder.key(), {cube_mesh(), {}});
  CHECK(same(folder.read(), cube_mesh()));
  fs::copy_file(folder.obj, folder / "copy.obj");
  CHECK(same(read_obj_by_cache(folder / "copy.obj", folder.cache, {}, 0), cube_mesh()));
  std::ofstream(folder.obj, std::ios::app) << "# a line more\n";
  CHECK(same(folder.read(), folder.ball));
  CHECK(files_in(folder.cache).size() == 2);
}

TEST_CASE("other normals of the same bytes are another mesh") {
  const CacheFolder folder;
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 0 1\nf 1 2 3\nf 1 4 2\n";
  write_files(folder.path, {{"ball.obj", text}});
  std::size_t files = 0;
  for (const MeshNormals& normals : {MeshNormals{}, MeshNormals{NormalsFrom::smooth}, MeshNormals{NormalsFrom::flat},
                                     MeshNormals{NormalsFrom::crease, 30}, MeshNormals{NormalsFrom::crease, 30.5},
                                     MeshNormals{NormalsFrom::crease, 120}}) {
    const Mesh expected = read_obj(folder.obj, {normals, nullptr});
    for (int i = 0; i < 2; ++i)
      CHECK(same(read_obj_by_cache(folder.obj, folder.cache, {normals, nullptr}, 0), expected));
    CHECK(files_in(folder.cache).size() == ++files);
  }
}

TEST_CASE("colours come out of the cache as they are taken, each way its own file") {
  const CacheFolder folder;
  write_files(folder.path, {{"ball.obj", "v 0 0 0 0.5 0.25 1\nv 1 0 0\nv 1 1 0 0.1 0.2 0.3\nf 1 2 3\n"}});
  std::size_t files = 0;
  for (const auto& colours : EnumNames<VertexColours>::names) {
    CAPTURE(colours.second);
    const ObjOptions options{{}, nullptr, colours.first};
    const Mesh expected = read_obj(folder.obj, options);
    for (int i = 0; i < 2; ++i) CHECK(same(read_obj_by_cache(folder.obj, folder.cache, options, 0), expected));
    CHECK(files_in(folder.cache).size() == ++files);
  }
}

TEST_CASE("what there was to note comes out of the cache, under the name that the file has now") {
  const CacheFolder folder;
  const std::string text = "usemap red\nv 0 0 0\nv 1 0 0\nv 1 1 0\ns\nf 1// 2// 3//\n";
  write_files(folder.path, {{"ball.obj", text}, {"copy.obj", text}});
  const auto notes_of = [&](const std::string& path) {
    NoteList notes;
    read_obj_by_cache(path, folder.cache, {{}, &notes}, 0);
    std::vector<std::string> texts;
    for (const Note& note : notes.notes()) texts.push_back(note.text().substr(path.size()));
    return texts;
  };
  const std::vector<std::string> first = notes_of(folder.obj);
  REQUIRE(first.size() == 3);
  CHECK(first[2] == ":6: found the corner \"1//\", read without its empty part (3 times)");
  CHECK(notes_of(folder.obj) == first);
  CHECK(notes_of(folder / "copy.obj") == first);
  CHECK(files_in(folder.cache).size() == 1);
}

TEST_CASE("small files are not kept") {
  const CacheFolder folder;
  CHECK(same(read_obj_by_cache(folder.obj, folder.cache), folder.ball));
  CHECK(files_in(folder.cache).empty());
}

TEST_CASE("a kept file that is changed in any byte, cut or longer is not believed, and made again") {
  const CacheFolder folder;
  folder.read();
  const std::string sound = bytes_of(folder.cached()), key = folder.key();
  const auto check = [&](const std::string& bytes) {
    folder.store_bytes(bytes);
    CHECK_FALSE(cached_mesh(folder.cache, key));
    CHECK(same(folder.read(), folder.ball));
    CHECK(bytes_of(folder.cached()) == sound);
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
  const std::string whole = bytes_of(folder.cached()), sound = whole.substr(0, whole.size() - sha256_bytes);
  const std::string key = folder.key();
  folder.store_with_digest(sound);
  CHECK(cached_mesh(folder.cache, key)); // the digest is right here
  const auto check = [&](std::size_t at, auto value) {
    std::string changed = sound;
    std::memcpy(&changed[at], &value, sizeof value);
    folder.store_with_digest(changed);
    CHECK_FALSE(cached_mesh(folder.cache, key));
  };
  check(sound.size() - 4, static_cast<std::uint32_t>(folder.ball.positions.size())); // the last corner
  check(sound.size() - 4, 0xffffffffu);
  for (const std::uint64_t count : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 31, std::uint64_t{1} << 63,
                                    ~std::uint64_t{0}, (std::uint64_t{1} << 62) + folder.ball.positions.size()}) {
    check(vertices_at, count);
    check(triangles_at, count);
    check(uvs_at, count);
    if (count > 0) check(colours_at, count), check(tangents_at, count);
  }
  check(16, mesh_cache_version + 1);
  check(20, 1u);
  check(20, ~0u);
  // Notes that are none, in the room of some.
  write_files(folder.path, {{"ball.obj", "s\n" + bytes_of(fs::path(folder.obj))}});
  fs::remove_all(folder.cache);
  check_cache_folder(folder.cache);
  folder.read();
  const std::string noted = bytes_of(folder.cached());
  std::string lie = noted.substr(0, noted.size() - sha256_bytes);
  folder.store_with_digest(lie);
  CHECK(cached_mesh(folder.cache, folder.key())->notes.notes().size() == 1);
  lie[lie.rfind("\ts without") - 1] = 'x'; // no number
  folder.store_with_digest(lie);
  CHECK_FALSE(cached_mesh(folder.cache, folder.key()));
}

TEST_CASE("a kept file under another mesh's name is not believed") {
  const CacheFolder folder;
  store_mesh(folder.cache, "other", {cube_mesh(), {}});
  CHECK(same(cached_mesh(folder.cache, "other")->mesh, cube_mesh()));
  const fs::path other = folder.cached();
  folder.read();
  for (const fs::path& file : files_in(folder.cache))
    if (file != other) fs::copy_file(other, file, fs::copy_options::overwrite_existing);
  CHECK(same(folder.read(), folder.ball));
  CHECK(same(cached_mesh(folder.cache, folder.key())->mesh, folder.ball));
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
        if (j % 3 == 0) fs::remove_all(folder.cache + "/" + folder.key() + ".4.mesh", gone_already);
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(right == 80);
  folder.read();
  CHECK(files_in(folder.cache).size() == 1); // no temporary files
}

TEST_CASE("faults of the text are reported with a cache too, and nothing is kept") {
  const CacheFolder folder;
  write_files(folder.path, {{"bad.obj", "v 0 0 0\nf 1 2 3\n"}});
  CHECK_THROWS_AS(read_obj_by_cache(folder / "bad.obj", folder.cache, {}, 0), InputError);
  CHECK_THROWS_AS(read_obj_by_cache(folder / "none.obj", folder.cache, {}, 0), InputError);
  CHECK(files_in(folder.cache).empty());
}

TEST_CASE("a cache that cannot be written to is reported") {
  const CacheFolder folder;
  CHECK_THROWS_AS(check_cache_folder(folder.obj), OutputError);
  CHECK_THROWS_AS(check_cache_folder(folder.obj + "/below"), OutputError);
  CHECK_THROWS_AS(read_obj_by_cache(folder.obj, folder.obj, {}, 0), OutputError);
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
  store_mesh(folder.path, "m", {read_obj(folder / "m.obj"), {}});
  write_files(folder.path,
              {{"c.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 3\nv 4 0 3\nv 4 -4 -1\nv 0 -4 -1\nvt 0 1\n"
                         "f 1/1 2/1 3/1 3/1 4/1\nf 1 5 6 2\nf 1 8 7 2\nf 3 2 1\n"}});
  store_mesh(folder.path, "c", {read_obj(folder / "c.obj"), {}});
  CHECK(mesh_cache_version == 4);
  CHECK(file_sha256(folder / "m.4.mesh") == "1e3c78314a9bcbb76cde7c82f88e64d013f2ba4391e8ab39e991e83d486cbca8");
  CHECK(file_sha256(folder / "c.4.mesh") == "3e334f676c7fff6f90513b89fba530ef4a1fe27d7d219643913126f147b0da9d");
}

} // namespace refraster::test
