#include "raster/vertex/transform.h"

#include "math/elementary.h"
#include "math/precisions.h"
#include "raster/lanes.h"
#include "raster/parallel.h"
#include "raster/vertex/outside.h"
#include "raster/vertex/vertex_stage.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

namespace refraster {

namespace {

// A rotation by `degrees` in the plane of axes i and j, turning i toward j.
Double3x3 rotation(double degrees, int i, int j) {
  Double3x3 m(1);
  const double c = cos_degrees(degrees), s = sin_degrees(degrees);
  m[i][i] = c, m[i][j] = s; // m[column][row]
  m[j][i] = -s, m[j][j] = c;
  return m;
}

Double3x3 linear_part(const Object& object) {
  const Double3& r = object.rotate_degrees;
  const Double3x3 rotated = rotation(r.x, 1, 2) * rotation(r.y, 2, 0) * rotation(r.z, 0, 1);
  return {rotated[0] * object.scale.x, rotated[1] * object.scale.y, rotated[2] * object.scale.z};
}

// The inverse transpose is cofactors / determinant; normals need only its direction, so the division, which a flattened
// scale would make impossible, is left out and the sign kept. det = 0 counts as positive.
Double3x3 normal_matrix(const Double3x3& m) {
  // A common factor changes no direction, and a power of two no digit. With columns m_k = u_k / s_k, each u_k of about
  // unit size, the cofactors (u_i x u_j) / (s_i s_j) are s_k (u_i x u_j) times a common factor: no product leaves the
  // range of double, whatever the scales.
  constexpr double below_one = 0.25; // so that s_k (u_i x u_j) stays finite for the largest s_k
  const auto size = [&](int k) { return below_one * reciprocal_binade(m[k]); };
  const Double3 u0 = m[0] * size(0), u1 = m[1] * size(1), u2 = m[2] * size(2);
  const Double3x3 cofactors(cross(u1, u2) * size(0), cross(u2, u0) * size(1), cross(u0, u1) * size(2));
  const double sign = dot(u0, cofactors[0]) < 0 ? -1 : 1;
  double largest = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = max(abs(cofactors[column][row]), largest);
  return cofactors * (sign * reciprocal_binade(largest));
}

} // namespace

Double4x4 view_from_world(const Camera& camera) {
  const Double3 back = normalize(camera.position - camera.target);
  const Double3 right = normalize(cross(camera.up, back));
  const Double3 up = cross(back, right);
  const Double3& eye = camera.position;
  Double4x4 view(1);
  for (int axis = 0; axis < 3; ++axis) {
    view[axis][0] = right[axis];
    view[axis][1] = up[axis];
    view[axis][2] = back[axis];
  }
  view[3] = {-dot(right, eye), -dot(up, eye), -dot(back, eye), 1};
  return view;
}

Double4x4 clip_from_view(const Camera& camera, double aspect) {
  const double cotangent = 1 / tan_degrees(camera.fov_y_degrees / 2);
  const double depth = camera.near - camera.far;
  Double4x4 projection(0);
  projection[0][0] = cotangent / aspect;
  projection[1][1] = cotangent;
  projection[2][2] = (camera.far + camera.near) / depth;
  projection[2][3] = -1;
  projection[3][2] = 2 * camera.near * camera.far / depth;
  return projection;
}

Double4x4 clip_from_world(const Camera& camera, double aspect) {
  return clip_from_view(camera, aspect) * view_from_world(camera);
}

bool is_mirrored(const Object& object) {
  const Double3& s = object.scale; // of which the product may underflow
  return s.x != 0 && s.y != 0 && s.z != 0 && (s.x < 0) != ((s.y < 0) != (s.z < 0));
}

Viewpoint camera_viewpoint(const Scene& scene, const RenderOptions& options) {
  const double aspect = static_cast<double>(options.width) / options.height;
  return {clip_from_world(scene.camera, aspect), scene.camera.near};
}

ObjectTransform object_transform(const Object& object, const Double4x4& clip_from_world) {
  const Double3x3 linear = linear_part(object);
  Double4x4 model(linear);
  model[3] = {object.position.x, object.position.y, object.position.z, 1};
  return {clip_from_world * model, model, normal_matrix(linear), is_mirrored(object) ? -1.0 : 1.0};
}

Double4 clip_position(const ObjectTransform& transform, const Float3& position) {
  return transform.clip_from_object * Double4(position.x, position.y, position.z, 1.0);
}

namespace {

// Mesh data enters lane by lane: lane k is component c of at[k].
template <class T>
T component(const Float3* at, int c) {
  if constexpr (NumberTraits<T>::lanes == 1) {
    return static_cast<T>((*at)[c]);
  } else {
    constexpr int lanes = NumberTraits<T>::lanes;
    return [&]<int... lane>(std::integer_sequence<int, lane...>) {
      const VectorOf<float, lanes> narrow{at[lane][c]...};
      return T(__builtin_convertvector(narrow, VectorOf<double, lanes>));
    }
    (std::make_integer_sequence<int, lanes>{});
  }
}

// at[stride k], at[stride k + 1] become lane k of a and of b.
template <class T>
void store_pairs(double* at, std::size_t stride, const T& a, const T& b) {
  if constexpr (NumberTraits<T>::lanes == 1) {
    store_lanes(at, a); // at may stand for other members than numbers
    store_lanes(at + 1, b);
  } else {
    constexpr int lanes = NumberTraits<T>::lanes;
    [&]<int... lane>(std::integer_sequence<int, lane...>) {
      const auto store = [&](std::size_t k, VectorOf<double, 2> pair) { store_lanes(at + stride * k, pair); };
      (store(lane, __builtin_shufflevector(a.v, b.v, lane, lane + lanes)), ...);
    }
    (std::make_integer_sequence<int, lanes>{});
  }
}

// Matrices as T has them, and the image: what an object's vertices have in common.
template <class T>
struct VertexStage {
  const ObjectTransform& matrices;
  int width, height;

  // As many vertices as T has lanes.
  static Vec3<T> read(const Float3* at) { return {component<T>(at, 0), component<T>(at, 1), component<T>(at, 2)}; }

  // What becomes of them in the window, with 1 / w where inverse_w is not null.
  void place(const Vec3<T>& p, PlacedVertex* placed, double* inverse_w) const {
    const auto clip = [&](int row) { return homogeneous(matrices.clip_from_object, row, p); };
    const WindowLanes<T> v = window_lanes(Vec4<T>(clip(0), clip(1), clip(2), clip(3)), width, height);
    // The integers of PlacedVertex, two in the bits of one double.
    static_assert(std::endian::native == std::endian::little);
    const LaneBits<T> x_sides = whole_bits(v.x * T(64.0) + v.sides) & 0xffffffff;
    const LaneBits<T> y_state = whole_bits(v.y * T(64.0) + v.not_finite + v.unsnapped * T(2.0)) << 32;
    store_pairs(reinterpret_cast<double*>(placed), sizeof *placed / sizeof(double), from_bits<T>(x_sides | y_state),
                v.z);
    if (inverse_w) store_lanes(inverse_w, v.inverse_w);
  }

  // The same in the world.
  void to_world(const Vec3<T>& p, const Vec3<T>& n, WorldVertex* world) const {
    const Vec3<T> position = world_position(matrices.world_from_object, p);
    const Vec3<T> normal = world_normal(matrices.world_from_normal, n);
    double* const at = &world->position.x;
    constexpr std::size_t stride = sizeof *world / sizeof(double);
    store_pairs(at, stride, position.x, position.y);
    store_pairs(at + 2, stride, position.z, normal.x);
    store_pairs(at + 4, stride, normal.y, normal.z);
  }
};

using Row = Native<double>;
constexpr std::size_t lanes = NumberTraits<Row>::lanes;

// Calls run(stage, index) so that all of [begin, end) are gone through: registers of them, then one by one.
void for_vertices(const ObjectTransform& matrices, int width, int height, std::size_t begin, std::size_t end,
                  auto&& run) {
  std::size_t v = begin;
  for (; v + lanes <= end; v += lanes) run(VertexStage<Row>{matrices, width, height}, v);
  for (; v < end; ++v) run(VertexStage<double>{matrices, width, height}, v);
}

// Vertices [begin, end) of an object's mesh become vertices `first` onward.
void transform_vertices(const Mesh& mesh, const ObjectTransform& matrices, int width, int height, std::size_t begin,
                        std::size_t end, std::size_t first, Geometry& vertices) {
  const auto place = [&](const auto& stage, const auto& p, std::size_t v) {
    stage.place(p, &vertices.window.placed[first + v], &vertices.window.inverse_w[first + v]);
  };
  if (!vertices.world_stored)
    return for_vertices(matrices, width, height, begin, end,
                        [&](const auto& stage, std::size_t v) { place(stage, stage.read(&mesh.positions[v]), v); });
  for_vertices(matrices, width, height, begin, end, [&](const auto& stage, std::size_t v) {
    const auto p = stage.read(&mesh.positions[v]), n = stage.read(&mesh.normals[v]);
    place(stage, p, v);
    stage.to_world(p, n, &vertices.world[first + v]);
  });
}

// Those of the mesh that stand in a list become vertices `first` onward.
void transform_some(const Mesh& mesh, const ObjectTransform& matrices, int width, int height,
                    std::span<const std::uint32_t> list, std::size_t first, Vertices& vertices) {
  std::array<Float3, lanes> positions, normals;
  for_vertices(matrices, width, height, 0, list.size(), [&]<class T>(const VertexStage<T>& stage, std::size_t i) {
    for (std::size_t lane = 0; lane < std::size_t{NumberTraits<T>::lanes}; ++lane)
      positions[lane] = mesh.positions[list[i + lane]], normals[lane] = mesh.normals[list[i + lane]];
    const auto p = stage.read(positions.data()), n = stage.read(normals.data());
    stage.place(p, &vertices.window.placed[first + i], &vertices.window.inverse_w[first + i]);
    stage.to_world(p, n, &vertices.world[first + i]);
  });
}

// Matrices, and where triangles begin.
void place_objects(const FrameInput& input, Geometry& geometry) {
  const Scene& scene = input.scene;
  geometry.scene = &scene;
  geometry.width = input.options.width, geometry.height = input.options.height;
  geometry.transforms.clear();
  geometry.first_triangle.assign(1, 0);
  for (const Object& object : scene.objects) {
    assert(object.mesh->triangles.size() <= INT32_MAX - geometry.first_triangle.back());
    geometry.transforms.push_back(object_transform(object, input.viewpoint.clip_from_world));
    geometry.first_triangle.push_back(geometry.first_triangle.back() +
                                      static_cast<std::uint32_t>(object.mesh->triangles.size()));
  }
}

// Where vertices begin.
void number_vertices(Geometry& geometry) {
  geometry.first_vertex.assign(1, 0);
  for (std::uint32_t o = 0; o < geometry.scene->objects.size(); ++o) {
    const std::size_t count =
        geometry.storage_of(o) == Storage::stored ? geometry.scene->objects[o].mesh->positions.size() : 0;
    assert(count <= INT32_MAX - geometry.first_vertex.back());
    geometry.first_vertex.push_back(geometry.first_vertex.back() + static_cast<std::uint32_t>(count));
  }
}

} // namespace

void lay_out(const FrameInput& input, Geometry& geometry, const StorageLimits& limits) {
  place_objects(input, geometry);
  const std::vector<Object>& objects = geometry.scene->objects;
  std::vector<Storage>& storage = geometry.storage;
  storage.assign(objects.size(), Storage::stored);
  find_outside(input, geometry.transforms, storage);
  std::size_t vertices = 0;
  for (std::size_t o = 0; o < objects.size(); ++o)
    if (storage[o] == Storage::stored) vertices += objects[o].mesh->positions.size();
  if (vertices > limits.stored)
    for (std::size_t o = 0; o < objects.size(); ++o)
      if (storage[o] == Storage::stored && objects[o].mesh->positions.size() <= limits.on_demand)
        storage[o] = Storage::on_demand;
  if (std::all_of(storage.begin(), storage.end(), [](Storage of) { return of == Storage::stored; })) storage.clear();
  number_vertices(geometry);
  const double pixels = static_cast<double>(input.region.width) * input.region.height;
  geometry.world_stored = input.options.samples > 1 || geometry.first_vertex.back() <= pixels * limits.world;
}

void transform(const FrameInput& input, Geometry& geometry) {
  place_objects(input, geometry);
  geometry.storage.clear();
  geometry.world_stored = true;
  number_vertices(geometry);
  transform_stored(input, geometry);
}

std::size_t vertex_piece(std::size_t vertices, int threads) {
  constexpr std::size_t pieces_of_thread = 4, min_piece = 256, max_piece = 2048;
  const std::size_t wanted = vertices / (static_cast<std::size_t>(threads) * pieces_of_thread);
  return std::clamp(wanted / lanes * lanes, min_piece, max_piece);
}

void transform_stored(const FrameInput& input, Geometry& geometry) {
  const std::size_t vertices = geometry.first_vertex.back();
  geometry.window.resize_uninitialized(vertices);
  geometry.world.resize_uninitialized(geometry.world_stored ? vertices : 0);
  const std::vector<Object>& objects = geometry.scene->objects;
  // Pieces of all vertices, whatever the objects are: there may be thousands of these, or one.
  const std::size_t piece = vertex_piece(vertices, input.threads);
  parallel_for(input.threads, (vertices + piece - 1) / piece, [&](std::size_t index, int) {
    const std::size_t begin = index * piece, end = std::min(vertices, begin + piece);
    const auto after = std::upper_bound(geometry.first_vertex.begin(), geometry.first_vertex.end(), begin);
    for (auto o = static_cast<std::size_t>(after - geometry.first_vertex.begin()) - 1;
         o < objects.size() && geometry.first_vertex[o] < end; ++o) {
      const std::size_t first = geometry.first_vertex[o], last = geometry.first_vertex[o + 1];
      if (first == last) continue; // none is stored of it
      transform_vertices(*objects[o].mesh, geometry.transforms[o], geometry.width, geometry.height,
                         std::max(begin, first) - first, std::min(end, last) - first, first, geometry);
    }
  });
}

void place_vertices(const Geometry& geometry, std::uint32_t object, Buffer<PlacedVertex>& placed) {
  const Mesh& mesh = *geometry.scene->objects[object].mesh;
  placed.resize_uninitialized(mesh.positions.size());
  for_vertices(
      geometry.transforms[object], geometry.width, geometry.height, 0, mesh.positions.size(),
      [&](const auto& stage, std::size_t v) { stage.place(stage.read(&mesh.positions[v]), &placed[v], nullptr); });
}

std::array<WindowVertex, 3> window_corners_on_demand(const Geometry& geometry, const TriangleRef& ref) {
  const Mesh& mesh = *geometry.scene->objects[ref.object].mesh;
  const VertexStage<double> stage{geometry.transforms[ref.object], geometry.width, geometry.height};
  std::array<WindowVertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    PlacedVertex placed;
    double inverse_w = 0;
    stage.place(stage.read(&mesh.positions[ref.vertex[k]]), &placed, &inverse_w);
    corners[k] = {placed.x(), placed.y(), placed.z, inverse_w, placed.outcode()};
  }
  return corners;
}

std::array<WorldVertex, 3> world_corners(const Geometry& geometry, const TriangleRef& ref) {
  std::array<WorldVertex, 3> corners;
  const bool stored = geometry.storage_of(ref.object) == Storage::stored;
  const std::uint32_t first = stored ? geometry.first_vertex[ref.object] : 0;
  const Mesh& mesh = *geometry.scene->objects[ref.object].mesh;
  const VertexStage<double> stage{geometry.transforms[ref.object], geometry.width, geometry.height};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = ref.vertex[k] - first;
    if (stored && geometry.world_stored) corners[k] = geometry.world[ref.vertex[k]];
    else stage.to_world(stage.read(&mesh.positions[v]), stage.read(&mesh.normals[v]), &corners[k]);
  }
  return corners;
}

void gather_vertices(const Geometry& geometry, std::span<const TriangleRef> triangles, Vertices& vertices) {
  vertices.resize_uninitialized(3 * triangles.size());
  std::array<std::uint32_t, 192> list; // of the mesh; triangles of an object follow one another
  for (std::size_t i = 0; i < triangles.size();) {
    const std::size_t first = 3 * i;
    const std::uint32_t object = triangles[i].object;
    const bool stored = geometry.storage_of(object) == Storage::stored, copied = stored && geometry.world_stored;
    const std::uint32_t first_in_mesh = stored && !copied ? geometry.first_vertex[object] : 0;
    std::size_t listed = 0;
    for (; i < triangles.size() && triangles[i].object == object && listed < list.size(); ++i)
      for (const std::uint32_t vertex : triangles[i].vertex) list[listed++] = vertex - first_in_mesh;
    if (!copied) {
      transform_some(*geometry.scene->objects[object].mesh, geometry.transforms[object], geometry.width,
                     geometry.height, {list.data(), listed}, first, vertices);
      continue;
    }
    for (std::size_t k = 0; k < listed; ++k) {
      vertices.window.placed[first + k] = geometry.window.placed[list[k]];
      vertices.window.inverse_w[first + k] = geometry.window.inverse_w[list[k]];
      vertices.world[first + k] = geometry.world[list[k]];
    }
  }
}

void TriangleFinder::find(std::uint32_t triangle) {
  const auto after = std::upper_bound(geometry_.first_triangle.begin(), geometry_.first_triangle.end(), triangle);
  object_ = static_cast<std::uint32_t>(after - geometry_.first_triangle.begin()) - 1;
  first_ = geometry_.first_triangle[object_], last_ = geometry_.first_triangle[object_ + 1];
  first_vertex_ = geometry_.storage_of(object_) == Storage::stored ? geometry_.first_vertex[object_] : 0;
  triangles_ = scene_.objects[object_].mesh->triangles.data();
}

} // namespace refraster
