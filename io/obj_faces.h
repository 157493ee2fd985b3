#pragma once
// The faces of an OBJ file, and what the file leaves to the reader: normals and triangles.

#include "io/obj_text.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// Indices from 0; -1: not given.
struct ObjCorner {
  std::int32_t v, vt, vn;
};

struct ObjFaces {
  std::vector<ObjCorner> corners;   // of all faces, one after the other
  std::vector<std::uint32_t> begin; // of each face its first corner; then the number of corners

  std::size_t count() const { return begin.size() - 1; }
  std::span<ObjCorner> face(std::size_t i) { return std::span(corners).subspan(begin[i], begin[i + 1] - begin[i]); }
};

/// Gives a normal to every corner without one: appended to obj.vn, zero where no face around has an area. See read_obj.
void add_missing_normals(ObjText& obj, ObjFaces& faces);

/// Cuts a polygon of n >= 3 corners into n - 2 triangles of its winding, indices into `polygon`: ears are clipped, in
/// the plane of two axes that it covers most. A convex polygon becomes the fan of its first corner. Every corner is a
/// corner of some triangle, also one on a straight edge. Total: what intersects itself or has no area is cut somehow.
/// O(n log n) where ears are small, O(n^2) at worst; of such steps 64 a corner are free, others are taken from
/// `steps_left`. Where that is not enough, the result is empty, and so is `steps_left`.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Float3> polygon, std::uint64_t& steps_left);

/// The same for one polygon of any size, however long it takes.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Float3> polygon);

/// The area vector of a polygon by Newell's sum: along its normal, and twice its area long.
Double3 area_vector(std::span<const Float3> polygon);

} // namespace refraster
