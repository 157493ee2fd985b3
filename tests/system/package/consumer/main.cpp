// A sphere in ten lines, with the installed library.
#include <refraster/mesh.h>
#include <refraster/render.h>

int main() {
  using namespace refraster;
  Scene scene;
  scene.camera.position = {0, 0, 4};
  scene.direction_lights.push_back({.direction = {-1, -1, -1}});
  Object ball;
  ball.mesh = std::make_shared<Mesh>(sphere_mesh(32, 16));
  ball.material.fragment_function = BlinnPhong{};
  scene.objects.push_back(ball);
  const Frame frame = render(scene, {.width = 64, .height = 64});
  return frame.rgb8.at(32, 32)[0] > 0 && frame.rgb8.at(0, 0)[0] == 0 ? 0 : 1;
}
