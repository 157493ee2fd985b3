#pragma once
// What an OBJ file leaves to the reader: normals and triangles.

#include <refraster/files.h>

#include "io/mesh/obj/polygon.h"
#include "io/mesh/obj_text.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

using FaceNormal = FaceNormalOf<double>;

/// Which corners share a normal that is to be computed.
struct SharedNormals {
  RawVector<std::int32_t> number; // of each corner: counted from 0 in the order of the file; -1 where it has a vn
  std::int32_t count = 0;
};

/// By smoothing groups: the corners of one vertex in one group. `smoothing`: of each face; smoothing_off makes it flat.
SharedNormals shared_by_group(const ObjFaces& faces, std::span<const std::int32_t> smoothing);

/// By crease: at one vertex, the corners of faces that share an edge there and whose normals are no farther apart than
/// the angle; and of faces that so belong to a third one. Faces without a normal stay alone. `vertices`: how many v
/// there are. O(n) steps where few faces share an edge; of such steps 64 a corner are free, others are taken from
/// `steps_left`. Where that is not enough, the result is empty, and so is `steps_left`.
SharedNormals shared_by_crease(const ObjFaces& faces, std::span<const FaceNormal> normals, std::size_t vertices,
                               double crease_degrees, int threads, std::uint64_t& steps_left);

/// Gives a normal to every corner without one, or, unless they are to come from the file, to every corner: appended to
/// obj.vn, zero where the faces around have none or cancel. See read_obj. False if shared_by_crease ran out of steps.
[[nodiscard]] bool add_missing_normals(ObjText& obj, const MeshNormals& wanted, int threads, std::uint64_t& steps_left);

/// Cuts a polygon of n >= 3 corners into n - 2 triangles of its winding, indices into `polygon`: ears are clipped, in
/// the plane of two axes that it covers most. A convex polygon becomes the fan of its first corner. Every corner is a
/// corner of some triangle, also one on a straight edge. Total: what intersects itself or has no area is cut somehow.
/// O(n log n) where ears are small, O(n^2) at worst; of such steps 64 a corner are free, others are taken from
/// `steps_left`. Where that is not enough, the result is empty, and so is `steps_left`.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Float3> polygon, std::uint64_t& steps_left);

/// The same for one polygon of any size, however long it takes.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Float3> polygon);

/// Whether triangulate makes a polygon the fan of its first corner, told without its lists: false for one of more than
/// eight corners, and where it is not plain to see.
bool is_fan(std::span<const Float3> polygon);

} // namespace refraster
