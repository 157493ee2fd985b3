#include "bench/workloads/built_in.h"

#include <refraster/mesh.h>

namespace refraster::bench {

Scene built_in_scene() {
  Scene scene;
  scene.camera.position = {0, 0, 1.3};
  scene.camera.target = {0, 0, 0};
  scene.camera.fov_y_degrees = 60;
  scene.camera.far = 10;
  scene.point_lights.push_back({.position = {1.5, 2, 2.5}, .radiance = Double3(1)});
  Object& ball = scene.objects.emplace_back();
  ball.name = "ball";
  ball.mesh = std::make_shared<Mesh>(sphere_mesh(100, 101));
  BlinnPhong plastic;
  plastic.ka = Double3(0.1), plastic.kd = {0.8, 0.3, 0.2}, plastic.ks = Double3(0.5), plastic.glossiness = 32;
  ball.material.fragment_function = plastic;
  return scene;
}

} // namespace refraster::bench
