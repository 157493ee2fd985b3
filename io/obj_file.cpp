#include "io/obj_file.h"

#include "io/input_file.h"
#include "io/limits.h"
#include "io/obj_faces.h"
#include "io/triple_index.h"

#include <tiny_obj_loader.h>

#include <cassert>
#include <istream>
#include <streambuf>

namespace refraster {
namespace {

/// A string as a stream, without a copy of it.
class StringBuffer : public std::streambuf {
public:
  explicit StringBuffer(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

/// What tinyobjloader meets, face by face: with its callbacks it keeps nothing itself, and a face may have any size.
struct FaceCollector {
  ObjFaces faces{{}, {0}};
  std::int32_t v = 0, vt = 0, vn = 0; // given so far

  /// From 1 or negative, counted back from the last one given, to an index from 0; 0, which means none, becomes -1.
  static std::int32_t from_zero(int index, std::int32_t given) { return index < 0 ? given + index : index - 1; }

  static FaceCollector& of(void* user) { return *static_cast<FaceCollector*>(user); }

  static void face(void* user, tinyobj::index_t* indices, int count) {
    FaceCollector& self = of(user);
    for (const tinyobj::index_t& index : std::span(indices, static_cast<std::size_t>(count)))
      self.faces.corners.push_back({from_zero(index.vertex_index, self.v), from_zero(index.texcoord_index, self.vt),
                                    from_zero(index.normal_index, self.vn)});
    self.faces.begin.push_back(static_cast<std::uint32_t>(self.faces.corners.size()));
  }
};

ObjFaces parse_faces(ObjText& obj) {
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* user, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
    ++FaceCollector::of(user).v;
  };
  calls.texcoord_cb = [](void* user, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
    ++FaceCollector::of(user).vt;
  };
  calls.normal_cb = [](void* user, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) { ++FaceCollector::of(user).vn; };
  calls.index_cb = FaceCollector::face;
  FaceCollector collector;
  StringBuffer buffer(obj.text);
  std::istream stream(&buffer);
  tinyobj::LoadObjWithCallback(stream, calls, &collector);
  assert(collector.faces.count() == obj.smoothing.size());
  return std::move(collector.faces);
}

/// Steps that all polygons of a file together may take to be cut, beyond what is in proportion to the file: some five
/// seconds. Any polygon of 10,000 corners keeps within them.
constexpr std::uint64_t most_steps = std::uint64_t{1} << 29;

InputError too_intricate(const std::string& path, std::size_t face, std::size_t corners) {
  return InputError(InputFault{path, 0, 0, "face " + std::to_string(face + 1),
                               "a polygon of " + std::to_string(corners) + " corners that takes too long to cut",
                               "simpler polygons, or triangles"});
}

} // namespace

Mesh read_obj(const std::string& path) {
  return mesh_of_obj(path, read_file(path, "an OBJ file", limit::obj_bytes.value));
}

Mesh mesh_of_obj(const std::string& path, std::string text) {
  ObjText obj = check_obj(path, std::move(text));
  ObjFaces faces = parse_faces(obj);
  obj.text = {};
  // Before the triangles are made: a polygon of n corners becomes n - 2. There are no more vertices than corners.
  if (const std::uint64_t triangles = faces.corners.size() - 2 * faces.count(); triangles > limit::triangles.value)
    throw InputError(InputFault{path, 0, 0, "", found_of(limit::triangles, triangles), at_most(limit::triangles)});
  add_missing_normals(obj, faces);

  Mesh mesh;
  TripleIndex vertices(faces.corners.size());
  std::vector<Float3> polygon;
  std::vector<std::uint32_t> names;
  std::uint64_t steps_left = most_steps;
  for (std::size_t f = 0; f < faces.count(); ++f) {
    polygon.clear();
    names.clear();
    for (const ObjCorner& corner : faces.face(f)) {
      polygon.push_back(obj.v[static_cast<std::size_t>(corner.v)]);
      names.push_back(static_cast<std::uint32_t>(vertices({corner.v, corner.vt, corner.vn})));
    }
    if (polygon.size() == 3) {
      mesh.triangles.push_back({names[0], names[1], names[2]});
      continue;
    }
    const auto triangles = triangulate(polygon, steps_left);
    if (triangles.empty()) throw too_intricate(path, f, polygon.size());
    for (const auto& [a, b, c] : triangles) mesh.triangles.push_back({names[a], names[b], names[c]});
  }
  mesh.positions.reserve(vertices.size());
  mesh.normals.reserve(vertices.size());
  if (!obj.vt.empty()) mesh.uvs.reserve(vertices.size());
  for (const auto& [v, vt, vn] : vertices.triples()) {
    mesh.positions.push_back(obj.v[static_cast<std::size_t>(v)]);
    mesh.normals.push_back(obj.vn[static_cast<std::size_t>(vn)]);
    if (!obj.vt.empty()) mesh.uvs.push_back(vt < 0 ? Float2(0.0f) : obj.vt[static_cast<std::size_t>(vt)]);
  }
  return mesh;
}

} // namespace refraster
