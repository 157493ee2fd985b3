#include "io/mesh/mesh_cache.h"

#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/mesh/mesh_normals.h"
#include "io/mesh/obj_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace refraster {
namespace {
namespace fs = std::filesystem;

// A file: Header, the vertex attributes in the order of their list, triangles, runs of materials, notes as text, names
// of materials and their libraries likewise, and the sha256 of what it is found by and all that: under another name it
// is not believed.
static_assert(std::endian::native == std::endian::little);
constexpr std::array<char, 16> magic = {'r', 'e', 'f', 'r', 'a', 's', 't',  'e',
                                        'r', ' ', 'm', 'e', 's', 'h', '\r', '\n'};
constexpr std::size_t optional_attributes = std::apply(
    [](const auto&... attribute) { return (std::size_t{attribute.need == Need::optional} + ...); }, vertex_attributes);
struct Header {
  std::array<char, 16> magic;
  std::uint32_t version, notes_bytes;
  std::uint64_t vertices;
  std::array<std::uint64_t, optional_attributes> values; // of each optional attribute, in the order of the list
  std::uint64_t triangles, material_runs, names_bytes;
};
static_assert(std::has_unique_object_representations_v<Header> && sizeof(Header) == 56 + 8 * optional_attributes);
/// A list of other attributes makes other files.
constexpr std::uint32_t version_of_header = mesh_cache_version + 256 * (optional_attributes - 1);

std::string file_of(const std::string& folder, const std::string& key) {
  return (fs::path(folder) / (key + "." + std::to_string(mesh_cache_version) + ".mesh")).string();
}

/// body(array of the mesh) for each that is stored.
template <class AnyMesh, class Body>
void for_each_array(AnyMesh& mesh, const Body& body) {
  for_each_vertex_attribute([&](const auto& attribute) { body(mesh.*attribute.values); });
  body(mesh.triangles);
  body(mesh.material_runs);
}

/// body(attribute, its count) for each attribute; optional ones have counts of their own.
template <class AnyHeader, class Body>
void for_each_count(AnyHeader& header, const Body& body) {
  std::size_t i = 0;
  for_each_vertex_attribute([&](const auto& attribute) {
    body(attribute, attribute.need == Need::required ? header.vertices : header.values[i++]);
  });
}

template <class Array>
std::size_t bytes_of(const Array& array) {
  static_assert(std::is_trivially_copyable_v<typename Array::value_type>);
  return array.size() * sizeof(typename Array::value_type);
}

/// Whether a mesh of these counts makes a file of this size.
bool has_size(const Header& header, std::uint64_t file_bytes) {
  constexpr std::uint64_t most = std::uint64_t{1} << 32; // the products below stay far from overflow
  if (header.vertices >= most || header.triangles >= most || header.material_runs > header.triangles ||
      header.names_bytes >= most)
    return false;
  std::uint64_t bytes = sizeof header + header.triangles * sizeof(std::array<std::uint32_t, 3>) +
                        header.material_runs * sizeof(TriangleRun) + header.notes_bytes + header.names_bytes;
  bool are_within = true;
  for_each_count(header, [&]<class Value>(const VertexAttribute<Value>&, std::uint64_t count) {
    are_within &= count <= header.vertices;
    bytes += count * sizeof(Value);
  });
  return are_within && file_bytes == bytes + sha256_bytes;
}

/// A line a note: its line, its count, what was found, what is done about it, with tabs between.
std::string notes_text(const NoteList& notes) {
  std::string text;
  for (const Note& note : notes.notes())
    text += std::to_string(note.line) + '\t' + std::to_string(note.count) + '\t' + one_line(note.found) + '\t' +
            one_line(note.consequence) + '\n';
  return text;
}

/// Up to `end`, which goes too.
std::string_view take(std::string_view& text, char end) {
  const std::size_t size = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  return part;
}

bool read_whole(std::string_view part, auto& value) {
  const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  return error == std::errc() && stop == part.data() + part.size();
}

std::optional<NoteList> notes_of(std::string_view text) {
  NoteList notes;
  while (!text.empty()) {
    Note note;
    if (!read_whole(take(text, '\t'), note.line) || !read_whole(take(text, '\t'), note.count)) return {};
    note.found = take(text, '\t');
    note.consequence = take(text, '\n');
    notes.add(std::move(note));
  }
  return notes;
}

/// A line a library, its number in the file and what it says, with a tab between; then a line a material. None of them
/// has a line end in it: each has been a line.
std::string names_text(const Mesh& mesh) {
  std::string text;
  for (const MaterialLibrary& library : mesh.material_libraries)
    text += std::to_string(library.line) + '\t' + library.text + '\n';
  for (const MeshMaterial& material : mesh.materials) text += '\t' + material.name + '\n';
  return text;
}

bool read_names(std::string_view text, Mesh& mesh) {
  while (!text.empty()) {
    const std::string_view line = take(text, '\t');
    const std::string name(take(text, '\n'));
    if (line.empty()) mesh.materials.emplace_back().name = name;
    else if (MaterialLibrary& library = mesh.material_libraries.emplace_back(MaterialLibrary{name, 0});
             !read_whole(line, library.line))
      return false;
  }
  return true;
}

/// Runs that are what they should be: in order, within the mesh, each of a material that is there.
bool has_good_runs(const Mesh& mesh) {
  std::uint64_t next = 0;
  for (const TriangleRun& run : mesh.material_runs) {
    if (run.first_triangle < next || run.first_triangle >= mesh.triangles.size()) return false;
    if (run.material != no_material && run.material >= mesh.materials.size()) return false;
    next = std::uint64_t{run.first_triangle} + 1;
  }
  return true;
}

} // namespace

std::string mesh_key(const std::string& sha256, const ObjOptions& options) {
  return sha256 + "." + name_of(options);
}

std::optional<KeptMesh> cached_mesh(const std::string& folder, const std::string& key) try {
  const std::string path = file_of(folder, key);
  constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max(); // the header says which
  const InputFile file(path, "a cached mesh", any_size);
  const std::uint64_t size = file.size_bytes();
  if (size < sizeof(Header)) return {};
  Sha256 digest;
  digest.add(key.data(), key.size());
  std::uint64_t position = 0;
  const auto read = [&](void* to, std::size_t bytes) {
    file.read(position, to, bytes);
    digest.add(to, bytes);
    position += bytes;
  };
  Header header{};
  read(&header, sizeof header);
  if (header.magic != magic || header.version != version_of_header || !has_size(header, size)) return {};

  KeptMesh kept;
  Mesh& mesh = kept.mesh;
  for_each_count(header, [&](const auto& attribute, std::uint64_t count) { (mesh.*attribute.values).resize(count); });
  mesh.triangles.resize(header.triangles);
  mesh.material_runs.resize(header.material_runs);
  for_each_array(mesh, [&](auto& array) { read(array.data(), bytes_of(array)); });
  std::string text(header.notes_bytes, '\0');
  read(text.data(), text.size());
  std::string names(header.names_bytes, '\0');
  read(names.data(), names.size());
  std::array<unsigned char, sha256_bytes> expected{};
  file.read(position, expected.data(), sha256_bytes);
  if (digest.result() != expected) return {};
  for (const auto& triangle : mesh.triangles)
    if (*std::max_element(triangle.begin(), triangle.end()) >= header.vertices) return {};
  std::optional<NoteList> notes = notes_of(text);
  if (!notes || !read_names(names, mesh) || !has_good_runs(mesh)) return {};
  kept.notes = std::move(*notes);
  return kept;
} catch (const InputError&) { // there is none, or it cannot be read
  return {};
}

void store_mesh(const std::string& folder, const std::string& key, const KeptMesh& kept) {
  const Mesh& mesh = kept.mesh;
  AtomicFile file(file_of(folder, key));
  Sha256 digest;
  digest.add(key.data(), key.size());
  const auto write = [&](const void* from, std::size_t bytes) {
    file.write(from, bytes);
    digest.add(from, bytes);
  };
  const std::string notes = notes_text(kept.notes), names = names_text(mesh);
  Header header{magic,
                version_of_header,
                static_cast<std::uint32_t>(notes.size()),
                mesh.positions.size(),
                {},
                mesh.triangles.size(),
                mesh.material_runs.size(),
                names.size()};
  std::size_t i = 0;
  for_each_vertex_attribute([&](const auto& attribute) {
    if (attribute.need == Need::optional) header.values[i++] = (mesh.*attribute.values).size();
  });
  write(&header, sizeof header);
  for_each_array(mesh, [&](const auto& array) { write(array.data(), bytes_of(array)); });
  write(notes.data(), notes.size());
  write(names.data(), names.size());
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

Mesh read_obj_by_cache(const std::string& path, const std::string& folder, const ObjOptions& options,
                       std::uint64_t min_bytes) {
  if (file_fault(path, "an OBJ file", limit::obj_bytes.value) || file_size_bytes(path) < min_bytes)
    return read_obj(path, options);
  const auto with_notes = [&](KeptMesh kept) {
    for (Note note : kept.notes.notes()) {
      note.file = path;
      if (options.notes) options.notes->add(std::move(note));
    }
    return std::move(kept.mesh);
  };
  if (std::optional<KeptMesh> kept = cached_mesh(folder, mesh_key(file_sha256(path), options)))
    return with_notes(std::move(*kept));
  // Read once more: what is kept is the mesh of the very bytes that it is found by, also if the file changes meanwhile.
  std::string text = read_file(path, "an OBJ file", limit::obj_bytes.value);
  const std::string key = mesh_key(text_sha256(text), options);
  KeptMesh kept;
  NoteList notes;
  kept.mesh = mesh_of_obj(path, std::move(text), {options.normals, &notes, options.colours, options.threads});
  for (Note note : notes.notes()) {
    note.file.clear(); // the same bytes may have another name
    kept.notes.add(std::move(note));
  }
  store_mesh(folder, key, kept);
  return with_notes(std::move(kept));
}

} // namespace refraster
