#include "io/mesh/mesh_normals.h"
#include "io/mesh/obj/normal_sums.h"
#include "io/mesh/obj/polygon_batch.h"
#include "io/mesh/obj_faces.h"
#include "io/parallel/pieces.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace refraster {
namespace {

constexpr std::size_t block = 4096; // faces that a thread takes at a time

/// Calls body(first, last) for blocks of faces.
void for_faces(const ObjFaces& faces, int threads, const std::function<void(std::size_t, std::size_t)>& body) {
  for_pieces(threads, (faces.count() + block - 1) / block,
             [&](std::size_t b, int) { body(b * block, std::min((b + 1) * block, faces.count())); });
}

bool lacks_vn(const ObjCorner& corner) {
  return corner.vn < 0;
}

/// Of faces from `first` to `last`: those of which any corner lacks a vn; 0 of the others.
void find_normals(const ObjText& obj, std::size_t first, std::size_t last, RawVector<FaceNormal>& normals) {
  PolygonBatch batch;
  const auto flush = [&] {
    if (batch.count() == 0) return;
    batch.load();
    const auto found = face_normal(batch.points(), batch.roundings());
    for (int lane = 0; lane < batch.count(); ++lane)
      normals[batch.face(lane)] = {
          {found.n.x[lane], found.n.y[lane], found.n.z[lane]}, found.error[lane], found.arithmetic_error[lane]};
    batch.clear();
  };
  std::vector<Double3> polygon;
  std::vector<double> roundings;
  for (std::size_t f = first; f < last; ++f) {
    const auto corners = obj.faces.face(f);
    if (std::none_of(corners.begin(), corners.end(), lacks_vn)) {
      normals[f] = {Double3(0.0), 0, 0};
      continue;
    }
    if (!batch.takes(corners.size())) flush();
    if (batch.takes(corners.size())) {
      batch.add(f, corners, obj.v);
      continue;
    }
    polygon.clear(), roundings.clear();
    for (const ObjCorner& corner : corners) {
      polygon.emplace_back(obj.v[static_cast<std::size_t>(corner.v)]);
      roundings.push_back(rounding_of(polygon.back()));
    }
    normals[f] = face_normal(std::span<const Double3>(polygon), std::span<const double>(roundings));
  }
  flush();
}

} // namespace

bool add_missing_normals(ObjText& obj, const MeshNormals& wanted, int threads, std::uint64_t& steps_left) {
  ObjFaces& faces = obj.faces;
  if (wanted.from != NormalsFrom::file) {
    for (ObjCorner& corner : faces.corners) corner.vn = -1;
    obj.vn.clear();
  }
  if (std::none_of(faces.corners.begin(), faces.corners.end(), lacks_vn)) return true;

  RawVector<FaceNormal> normals(faces.count());
  for_faces(faces, threads, [&](std::size_t first, std::size_t last) { find_normals(obj, first, last, normals); });

  const bool by_file = wanted.from == NormalsFrom::file;
  if (wanted.from == NormalsFrom::flat) obj.smoothing.assign(faces.count(), smoothing_off);
  if (wanted.from == NormalsFrom::smooth) obj.smoothing.assign(faces.count(), 1);
  const bool by_crease = wanted.from == NormalsFrom::crease || (by_file && !obj.has_smoothing);
  const SharedNormals shared =
      by_crease ? shared_by_crease(faces, normals, obj.v.size(),
                                   by_file ? crease_degrees_of_files : wanted.crease_degrees, threads, steps_left)
                : shared_by_group(faces, obj.smoothing);
  if (shared.count == 0) return false;

  const std::size_t given = obj.vn.size();
  obj.vn.resize(given + static_cast<std::size_t>(shared.count));
  sum_normals(obj, normals, shared, threads, std::span(obj.vn).subspan(given));
  for_faces(faces, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      for (std::size_t i = faces.begin[f]; i < faces.begin[f + 1]; ++i) {
        const std::int32_t number = shared.number[i];
        if (number < 0) continue;
        faces.corners[i].vn = static_cast<std::int32_t>(given) + number;
        // Of a flat face there is nothing to be summed up.
        if (!by_crease && obj.smoothing[f] == smoothing_off)
          obj.vn[given + static_cast<std::size_t>(number)] = Float3(normals[f].n);
      }
  });
  return true;
}

} // namespace refraster
