#pragma once
// Normals of vertices: those of the faces around them, each weighted by the angle that the face takes there.

#include "io/mesh/obj_faces.h"

#include <span>

namespace refraster {

/// One for each number of `shared`, unit or 0, in the order of numbers. Faces are summed up in the order of the file,
/// whatever the number of threads.
void sum_normals(const ObjText& obj, std::span<const FaceNormal> normals, const SharedNormals& shared, int threads,
                 std::span<Float3> sums);

} // namespace refraster
