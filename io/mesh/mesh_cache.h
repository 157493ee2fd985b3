#pragma once
// Meshes of OBJ files that were read before. Text is slow to read: a million triangles are 80 MB of it.

#include <refraster/files.h>

#include <cstdint>
#include <optional>
#include <string>

namespace refraster {

/// read_obj(path, options), by way of a folder: a large file is found there by the sha256 of its bytes and by the
/// normals that are wanted, whatever its name and date; if it is not there, it is read and put there, with what there
/// is to note. Smaller files than this are read at once. Throws InputError as read_obj does, and OutputError if the
/// folder lets nothing be written to it.
Mesh read_obj_by_cache(const std::string& path, const std::string& folder, const ObjOptions& options = {},
                       std::uint64_t min_bytes = std::uint64_t{1} << 20);

/// Part of what a mesh is found by. To be raised when read_obj makes another mesh of the same bytes, or when the format
/// below changes: a test says when.
inline constexpr std::uint32_t mesh_cache_version = 4;

/// What a mesh is found by: different for different bytes, and for different normals of the same bytes.
std::string mesh_key(const std::string& sha256, const ObjOptions& options);

/// A mesh, and what there was to note of its file: notes without a file's name.
struct KeptMesh {
  Mesh mesh;
  NoteList notes;
};

/// What was kept under a key; nothing if nothing was, or if what is there is not, byte for byte, what was written under
/// that key: another length, another digest at its end. A file is not believed beyond that: an index out of range is no
/// mesh either.
std::optional<KeptMesh> cached_mesh(const std::string& folder, const std::string& key);

/// Keeps a mesh, whole or not at all. Throws OutputError.
void store_mesh(const std::string& folder, const std::string& key, const KeptMesh& kept);

/// Makes the folder if need be. Throws OutputError unless files can be written to it.
void check_cache_folder(const std::string& folder);

} // namespace refraster
