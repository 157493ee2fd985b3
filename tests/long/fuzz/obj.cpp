#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/render_small.h"
#include "tests/long/fuzz/targets.h"

#include "tests/support/invariants.h"

#include <cstring>
#include <iterator>

namespace refraster::fuzz {
namespace {

template <class Vector>
bool same_bits(const Vector& a, const Vector& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

/// Whether vertex by vertex of every triangle, in order, both meshes hold the same bits.
bool same_triangles(const Mesh& a, const Mesh& b) {
  const auto corners = [](const Mesh& mesh, const auto& list) {
    std::remove_cvref_t<decltype(list)> result;
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t vertex : triangle)
        if (&list != static_cast<const void*>(&mesh.uvs) || has_uvs(mesh, triangle)) result.push_back(list[vertex]);
    return result;
  };
  return same_bits(corners(a, a.positions), corners(b, b.positions)) &&
         same_bits(corners(a, a.normals), corners(b, b.normals)) && same_bits(corners(a, a.uvs), corners(b, b.uvs));
}

} // namespace

void read_obj_bytes(Bytes bytes) {
  const std::string path = file_of("m.obj", bytes);
  // The last byte says which normals are wanted, so that each way meets every text.
  constexpr MeshNormals ways[] = {
      {}, {NormalsFrom::smooth}, {NormalsFrom::flat}, {NormalsFrom::crease, 30}, {NormalsFrom::crease, 180}};
  const MeshNormals normals = ways[bytes.empty() ? 0 : static_cast<std::size_t>(bytes.back()) % std::size(ways)];
  auto mesh = std::make_shared<Mesh>();
  NoteList notes;
  const PeakMemory peak;
  try {
    *mesh = read_obj(path, {normals, &notes});
  } catch (const InputError& error) {
    require(!error.faults().empty() && error.faults().size() <= 101, "a refusal has faults, not too many");
    require(notes.empty(), "a refusal has no notes");
    mesh.reset();
  }
  require_memory(peak, bytes.size(), 1 << 17, 100);
  if (!mesh) return;
  require(notes.notes().size() <= 20, "a note a kind");
  require_none(test::fault_of(*mesh), "an accepted mesh");
  render_small(showing(mesh, nullptr, TextureFilter::nearest), bytes.size());

  const std::string copy = file_of("copy.obj", {});
  write_obj(copy, *mesh);
  NoteList none;
  require(same_triangles(*mesh, read_obj(copy, {{}, &none})), "what write_obj wrote is read back");
}

} // namespace refraster::fuzz
