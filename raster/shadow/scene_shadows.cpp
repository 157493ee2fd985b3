#include "raster/shadow/scene_shadows.h"

#include "raster/parallel.h"
#include "raster/vertex/vertex_stage.h"

#include <algorithm>

namespace refraster {
namespace {

LightPlace place_of(const PointLight& light) {
  return {LightPlace::Kind::point, light.position};
}
LightPlace place_of(const DirectionLight& light) {
  return {LightPlace::Kind::direction, -light.direction};
}

/// All vertices of a scene as shading sees them, and all triangles.
void fill(const FrameInput& frame, const Geometry& geometry, std::size_t vertices, WorldMesh& mesh) {
  mesh.position.resize_uninitialized(vertices);
  mesh.triangle.resize_uninitialized(geometry.triangles());
  constexpr std::size_t piece = 1 << 14;
  std::size_t first_vertex = 0;
  for (std::size_t o = 0; o < frame.scene.objects.size(); ++o) {
    const Mesh& of = *frame.scene.objects[o].mesh;
    const Double4x4& world_from_object = geometry.transforms[o].world_from_object;
    const std::size_t first_triangle = geometry.first_triangle[o];
    const auto for_pieces = [&](std::size_t count, const auto& body) {
      parallel_for(frame.threads, (count + piece - 1) / piece, [&](std::size_t p, int) {
        for (std::size_t i = p * piece; i < std::min(count, (p + 1) * piece); ++i) body(i);
      });
    };
    for_pieces(of.positions.size(), [&](std::size_t i) {
      mesh.position[first_vertex + i] = world_position<double>(world_from_object, Double3(of.positions[i]));
    });
    for_pieces(of.triangles.size(), [&](std::size_t i) {
      for (std::size_t k = 0; k < 3; ++k)
        mesh.triangle[first_triangle + i][k] = static_cast<std::uint32_t>(first_vertex) + of.triangles[i][k];
    });
    first_vertex += of.positions.size();
  }
}

} // namespace

void SceneShadows::build(const FrameInput& frame, const Geometry& geometry) {
  lights_.clear();
  for_each_light_list(frame.scene, [&](const auto& lights) {
    for (const auto& light : lights)
      if (light.shadow != Shadow::none) lights_.push_back(place_of(light));
  });
  std::size_t vertices = 0;
  for (const Object& object : frame.scene.objects) vertices += object.mesh->positions.size();
  const std::uint64_t triangles = geometry.triangles();
  const std::uint64_t wanted = WorldMesh::bytes(vertices, triangles) + TriangleTree::bytes_to_build(triangles);
  const std::uint64_t held = WorldMesh::bytes(mesh_.position.size(), mesh_.triangle.size()) + tree_.bytes_held();
  if (wanted > held) frame.options.memory.need(wanted - held, "the shadows");
  fill(frame, geometry, vertices, mesh_);
  tree_.build(mesh_, frame.threads);
}

} // namespace refraster
