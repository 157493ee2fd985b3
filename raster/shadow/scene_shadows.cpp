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
  has_exact_ = false;
  used_maps_ = 0;
  for_each_light_list(frame.scene, [&](const auto& lights) {
    for (const auto& light : lights) {
      if (light.shadow == Shadow::none) continue;
      ShadowedLight& added = lights_.emplace_back(ShadowedLight{light.shadow.kind, place_of(light), 0});
      if (light.shadow == Shadow::map) added.map = used_maps_++;
      else has_exact_ = true;
    }
  });
  if (has_exact_) build_tree(frame, geometry);
  if (used_maps_ > 0) draw_maps(frame);
}

void SceneShadows::build_tree(const FrameInput& frame, const Geometry& geometry) {
  std::size_t vertices = 0;
  for (const Object& object : frame.scene.objects) vertices += object.mesh->positions.size();
  const std::uint64_t triangles = geometry.triangles();
  const std::uint64_t wanted = WorldMesh::bytes(vertices, triangles) + TriangleTree::bytes_to_build(triangles);
  const std::uint64_t held = WorldMesh::bytes(mesh_.position.size(), mesh_.triangle.size()) + tree_.bytes_held();
  if (wanted > held) frame.options.memory.need(wanted - held, "the shadows");
  fill(frame, geometry, vertices, mesh_);
  tree_.build(mesh_, frame.threads);
}

void SceneShadows::draw_maps(const FrameInput& frame) {
  if (maps_.size() < used_maps_) maps_.resize(used_maps_);
  const std::vector<LightView> views = light_views(frame.scene, frame.threads);
  std::uint64_t wanted = 0, held = 0;
  for (const LightView& view : views) wanted += DepthMap::bytes(view);
  for (const DepthMap& map : maps_) held += map.bytes_held();
  if (wanted > held) frame.options.memory.need(wanted - held, "the shadow maps");
  const Scene casters = casters_of(frame.scene);
  for (std::size_t i = 0; i < views.size(); ++i) maps_[i].draw(frame, casters, views[i], scratch_);
}

} // namespace refraster
