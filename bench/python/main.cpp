// python_other_side SEGMENTS WIDTH HEIGHT: what bench/python/run does from Python, in C++. For each line that it reads
// it makes a mesh of plain arrays, renders it, and says how long both took, in milliseconds.

#include <refraster/mesh.h>
#include <refraster/render.h>
#include <refraster/scene.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

namespace {

using namespace refraster;

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("python_other_side SEGMENTS WIDTH HEIGHT\n", stderr);
    return 2;
  }
  const int segments = std::atoi(words[1]);
  const Mesh arrays = sphere_mesh(segments, segments / 2);
  Scene scene;
  scene.camera = {.position = {0, 0, 3}, .target = {0, 0, 0}, .near = 1, .far = 10};
  scene.direction_lights.push_back({.direction = {0, 0, -1}});
  scene.objects.resize(1);
  scene.objects.front().material.fragment_function = BlinnPhong{};
  RenderOptions options;
  options.width = std::atoi(words[2]), options.height = std::atoi(words[3]);
  options.want_radiance = true;
  for (std::string line; std::getline(std::cin, line);) {
    const double begin = now_ms();
    const auto mesh = std::make_shared<Mesh>();
    mesh->positions = arrays.positions, mesh->normals = arrays.normals;
    mesh->triangles = arrays.triangles;
    scene.objects.front().mesh = mesh;
    const double made = now_ms();
    const Frame frame = render(scene, options);
    const double rendered = now_ms();
    std::printf("%.6f %.6f %llu\n", made - begin, rendered - made,
                static_cast<unsigned long long>(frame.counts.shaded));
    std::fflush(stdout);
  }
}
