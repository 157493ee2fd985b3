#pragma once
// The vertex stage, in double: object space to world space, clip space and window.

#include <refraster/scene.h>

#include "raster/buffer.h"
#include "raster/frame_context.h"
#include "raster/vertex/subpixel.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// The matrices of the lecture's vertex shader for one object.
struct ObjectTransform {
  Double4x4 clip_from_object;  // projection . view . model
  Double4x4 world_from_object; // model = T . Rx . Ry . Rz . S
  /// Cofactors of the model's 3x3 part, times the sign of its determinant, times a power of two.
  Double3x3 world_from_normal;
  double handedness = 1; // of frames: -1 where the model mirrors
};

/// The camera's own space: x to the right, y up, z toward the viewer.
Double4x4 view_from_world(const Camera& camera);

/// The projection to OpenGL's clip space, -w <= x, y, z <= w inside. `aspect` is width / height.
Double4x4 clip_from_view(const Camera& camera, double aspect);

/// projection . view.
Double4x4 clip_from_world(const Camera& camera, double aspect);

/// Defined for every scale: a mirrored one keeps outward normals outward, a flattened one gives the plane's normal.
ObjectTransform object_transform(const Object& object, const Double4x4& clip_from_world);

/// Whether the model matrix mirrors: its determinant, which has the sign of the product of the scales, is below 0.
bool is_mirrored(const Object& object);

/// Which of the six clip half-spaces a vertex lies outside of, and two states. Comparisons of exact doubles.
namespace outcode {
inline constexpr std::uint8_t left = 1, right = 2, bottom = 4, top = 8, near = 16, far = 32;
inline constexpr std::uint8_t sides = 63;
inline constexpr std::uint8_t not_finite = 64; // a clip coordinate is NaN or infinite
inline constexpr std::uint8_t unsnapped = 128; // w <= 0, or beyond the guard band: has no place on the lattice
} // namespace outcode

/// A vertex as the rasterizer sees it.
struct WindowVertex {
  std::int32_t x = 0, y = 0; // subpixels; 0 if unsnapped
  double z = 0;              // z / w, in [-1, 1] between the depth planes
  double inverse_w = 0;      // 1 / w > 0
  std::uint8_t outcode = 0;
};

/// The same as set-up reads it, by the million, in 16 bytes.
struct PlacedVertex {
  std::int32_t x_sides = 0; // 64 x + (outcode & 63)
  std::int32_t y_state = 0; // 64 y + (outcode >> 6)
  double z = 0;

  static PlacedVertex of(const WindowVertex& v) {
    return {64 * v.x + (v.outcode & 63), 64 * v.y + (v.outcode >> 6), v.z};
  }

  std::int32_t x() const { return x_sides >> 6; }
  std::int32_t y() const { return y_state >> 6; }
  std::uint8_t outcode() const { return static_cast<std::uint8_t>((x_sides & 63) | (y_state & 3) << 6); }
};

/// Vertices in the window, apart from what only shading reads of them.
struct WindowVertices {
  Buffer<PlacedVertex> placed;
  Buffer<double> inverse_w;

  std::size_t size() const { return placed.size(); }
  void resize_uninitialized(std::size_t size) {
    placed.resize_uninitialized(size);
    inverse_w.resize_uninitialized(size);
  }
  WindowVertex operator[](std::size_t i) const {
    const PlacedVertex& v = placed[i];
    return {v.x(), v.y(), v.z, inverse_w[i], v.outcode()};
  }
};

/// A vertex as shading sees it.
struct WorldVertex {
  Double3 position; // coordinates within 2^1022, so that no difference overflows
  Double3 normal;   // any length
};

Double4 clip_position(const ObjectTransform& transform, const Float3& position);

/// Vertices as both see them.
struct Vertices {
  WindowVertices window;
  Buffer<WorldVertex> world;

  void resize_uninitialized(std::size_t size) {
    window.resize_uninitialized(size);
    world.resize_uninitialized(size);
  }
};

/// What a frame keeps of an object's vertices.
enum class Storage : std::uint8_t {
  stored,    // all of them, transformed once
  on_demand, // none: binning transforms them, an object at a time, and shading those of triangles that are seen
  outside    // none: the object lies outside the view, and is not drawn
};

/// Vertices of the objects that are stored, one object's after the other's, and where each object's vertices and
/// triangles begin.
struct Geometry : Vertices {
  std::vector<ObjectTransform> transforms;
  std::vector<std::uint32_t> first_vertex;   // objects + 1 entries; of stored ones
  std::vector<std::uint32_t> first_triangle; // objects + 1 entries; of all
  std::vector<Storage> storage = {};         // of each object; empty where all are stored
  // Whether they are stored as shading sees them, too. Where there are many for each pixel, most are never asked for.
  bool world_stored = true;
  // What the vertices of others are made from. The scene outlives the frame.
  const Scene* scene = nullptr;
  int width = 0, height = 0;

  std::uint32_t triangles() const { return first_triangle.back(); }
  bool all_stored() const { return storage.empty(); }
  Storage storage_of(std::uint32_t object) const { return all_stored() ? Storage::stored : storage[object]; }
};

/// Transforms each unique vertex once and stores all. The scene may have up to 2^31 - 1 vertices and as many triangles
/// in all (assert). `geometry` may be that of another frame: its memory is used again.
void transform(const FrameInput& input, Geometry& geometry);

/// From how many vertices on they are not stored.
struct StorageLimits {
  /// In all, 144 MiB. A frame of more has several vertices for each of its pixels, most of which no sample needs.
  std::size_t stored = std::size_t{1} << 21;
  /// Of an object on demand: a thread bins it as a whole, so that larger ones would be work for one thread alone.
  std::size_t on_demand = std::size_t{1} << 20;
  /// In the world, for each pixel of a frame of one sample a pixel: tiny triangles, which have more vertices than that,
  /// are shaded from the mesh anyway (raster/shade/tiny/vertex_data.h).
  double world = 0.25;
};

/// The same in two steps, for what only draws. First matrices, and what is to be stored: nothing of objects that lie
/// outside the view as a whole (raster/vertex/outside.h); and where the others have more than `limits.stored` vertices
/// in all, nothing of those objects that have at most `limits.on_demand`.
void lay_out(const FrameInput& input, Geometry& geometry, const StorageLimits& limits = {});
/// How many vertices a thread takes at a time: a few pieces for each thread, but for the least a piece of 256, which
/// takes about a microsecond.
std::size_t vertex_piece(std::size_t vertices, int threads);
/// Then the vertices of those that are stored.
void transform_stored(const FrameInput& input, Geometry& geometry);

/// Vertices of an object's whole mesh in the window: what binning needs of one that is on demand.
void place_vertices(const Geometry& geometry, std::uint32_t object, Buffer<PlacedVertex>& placed);

/// A triangle by its number in the frame: object, corner indices into Geometry's arrays and into the mesh.
struct TriangleRef {
  std::uint32_t object = 0, triangle = 0; // triangle: in the object's mesh
  std::uint32_t vertex[3] = {};           // in Geometry::window and ::world; in the mesh of an object on demand
};

/// Corner k of triangles[i] becomes vertex 3 i + k, stored or not.
void gather_vertices(const Geometry& geometry, std::span<const TriangleRef> triangles, Vertices& vertices);

/// Finds triangles by their numbers, in any order: quickest where neighbours are of one object.
class TriangleFinder {
public:
  TriangleFinder(const Scene& scene, const Geometry& geometry) : scene_(scene), geometry_(geometry) {}

  TriangleRef at(std::uint32_t triangle) {
    if (triangle < first_ || triangle >= last_) [[unlikely]]
      find(triangle);
    const std::array<std::uint32_t, 3>& corners = triangles_[triangle - first_];
    return {object_,
            triangle - first_,
            {first_vertex_ + corners[0], first_vertex_ + corners[1], first_vertex_ + corners[2]}};
  }

  /// Asks for the memory that at() reads, of a triangle of the object that was asked for last.
  void ask_for(std::uint32_t triangle) const {
    if (triangle >= first_ && triangle < last_) __builtin_prefetch(&triangles_[triangle - first_]);
  }

private:
  void find(std::uint32_t triangle);

  const Scene& scene_;
  const Geometry& geometry_;
  std::uint32_t object_ = 0, first_ = 0, last_ = 0, first_vertex_ = 0; // of the object; its triangles [first, last)
  const std::array<std::uint32_t, 3>* triangles_ = nullptr;
};

/// Its corners in the window, stored or not.
std::array<WindowVertex, 3> window_corners_on_demand(const Geometry& geometry, const TriangleRef& ref);
inline std::array<WindowVertex, 3> window_corners(const Geometry& geometry, const TriangleRef& ref) {
  if (geometry.storage_of(ref.object) != Storage::stored) [[unlikely]]
    return window_corners_on_demand(geometry, ref);
  return {geometry.window[ref.vertex[0]], geometry.window[ref.vertex[1]], geometry.window[ref.vertex[2]]};
}

/// Its corners in the world, stored or not.
std::array<WorldVertex, 3> world_corners(const Geometry& geometry, const TriangleRef& ref);

} // namespace refraster
