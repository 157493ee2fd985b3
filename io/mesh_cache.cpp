#include "io/mesh_cache.h"

#include "io/atomic_file.h"
#include "io/input_file.h"
#include "io/limits.h"
#include "io/obj_file.h"
#include "io/sha256.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <type_traits>

namespace refraster {
namespace {
namespace fs = std::filesystem;

// A file: Header, positions, normals, uvs if there are any, triangles, and the sha256 of what it is found by and all
// that: under another name it is not believed.
static_assert(std::endian::native == std::endian::little);
constexpr std::array<char, 16> magic = {'r', 'e', 'f', 'r', 'a', 's', 't',  'e',
                                        'r', ' ', 'm', 'e', 's', 'h', '\r', '\n'};
struct Header {
  std::array<char, 16> magic;
  std::uint32_t version, has_uvs;
  std::uint64_t vertices, triangles;
};
static_assert(std::has_unique_object_representations_v<Header> && sizeof(Header) == 40);

std::string file_of(const std::string& folder, const std::string& sha256) {
  return (fs::path(folder) / (sha256 + "." + std::to_string(mesh_cache_version) + ".mesh")).string();
}

/// body(array of the mesh) for each that is stored.
template <class AnyMesh, class Body>
void for_each_array(AnyMesh& mesh, const Body& body) {
  body(mesh.positions);
  body(mesh.normals);
  body(mesh.uvs);
  body(mesh.triangles);
}

template <class Array>
std::size_t bytes_of(const Array& array) {
  static_assert(std::is_trivially_copyable_v<typename Array::value_type>);
  return array.size() * sizeof(typename Array::value_type);
}

/// Whether a mesh of these counts makes a file of this size.
bool has_size(const Header& header, std::uint64_t file_bytes) {
  constexpr std::uint64_t most = std::uint64_t{1} << 32; // the products below stay far from overflow
  if (header.vertices >= most || header.triangles >= most || header.has_uvs > 1) return false;
  const std::uint64_t vertex_bytes = sizeof(Float3) * 2 + (header.has_uvs ? sizeof(Float2) : 0);
  const std::uint64_t triangle_bytes = sizeof(std::array<std::uint32_t, 3>);
  return file_bytes ==
         sizeof header + header.vertices * vertex_bytes + header.triangles * triangle_bytes + sha256_bytes;
}

} // namespace

std::optional<Mesh> kept_mesh(const std::string& folder, const std::string& sha256) try {
  const std::string path = file_of(folder, sha256);
  constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max(); // the header says which
  const InputFile file(path, "a kept mesh", any_size);
  const std::uint64_t size = file.size_bytes();
  if (size < sizeof(Header)) return {};
  Sha256 digest;
  digest.add(sha256.data(), sha256.size());
  std::uint64_t position = 0;
  const auto read = [&](void* to, std::size_t bytes) {
    file.read(position, to, bytes);
    digest.add(to, bytes);
    position += bytes;
  };
  Header header{};
  read(&header, sizeof header);
  if (header.magic != magic || header.version != mesh_cache_version || !has_size(header, size)) return {};

  Mesh mesh;
  mesh.positions.resize(header.vertices);
  mesh.normals.resize(header.vertices);
  mesh.uvs.resize(header.has_uvs ? header.vertices : 0);
  mesh.triangles.resize(header.triangles);
  for_each_array(mesh, [&](auto& array) { read(array.data(), bytes_of(array)); });
  std::array<unsigned char, sha256_bytes> expected{};
  file.read(position, expected.data(), sha256_bytes);
  if (digest.result() != expected) return {};
  for (const auto& triangle : mesh.triangles)
    if (*std::max_element(triangle.begin(), triangle.end()) >= header.vertices) return {};
  return mesh;
} catch (const InputError&) { // there is none, or it cannot be read
  return {};
}

void keep_mesh(const std::string& folder, const std::string& sha256, const Mesh& mesh) {
  AtomicFile file(file_of(folder, sha256));
  Sha256 digest;
  digest.add(sha256.data(), sha256.size());
  const auto write = [&](const void* from, std::size_t bytes) {
    file.write(from, bytes);
    digest.add(from, bytes);
  };
  const Header header{magic, mesh_cache_version, mesh.uvs.empty() ? 0u : 1u, mesh.positions.size(),
                      mesh.triangles.size()};
  write(&header, sizeof header);
  for_each_array(mesh, [&](const auto& array) { write(array.data(), bytes_of(array)); });
  const auto result = digest.result();
  file.write(result.data(), result.size());
  file.commit();
}

void check_cache_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder, error)) throw OutputError(folder, "it is no folder, and none can be made there");
  AtomicFile trial((fs::path(folder) / "trial").string()); // leaves nothing
}

Mesh read_obj_by_cache(const std::string& path, const std::string& folder, std::uint64_t least_bytes) {
  if (file_fault(path, "an OBJ file", limit::obj_bytes.value) || file_size_bytes(path) < least_bytes)
    return read_obj(path);
  if (std::optional<Mesh> mesh = kept_mesh(folder, file_sha256(path))) return std::move(*mesh);
  // Read once more: what is kept is the mesh of the very bytes that it is found by, also if the file changes meanwhile.
  std::string text = read_file(path, "an OBJ file", limit::obj_bytes.value);
  const std::string sha256 = text_sha256(text);
  Mesh mesh = mesh_of_obj(path, std::move(text));
  keep_mesh(folder, sha256, mesh);
  return mesh;
}

} // namespace refraster
