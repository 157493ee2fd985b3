// guard_frames SCENES_FOLDER: small frames of the workloads of bench/scenes, each in every precision, one after the
// other in one thread. bench/guard/run counts their instructions. Prints "scene precision" for each, in order.

#include <refraster/files.h>
#include <refraster/render.h>

#include "math/precisions.h"
#include "scenes/synthesis/waves.h"

#include <exception>
#include <iostream>
#include <map>
#include <tuple>

/// What is counted: callgrind is told this name, and counts nothing outside.
extern "C" [[gnu::noinline]] void refraster_guarded_frame(refraster::Renderer* renderer, const refraster::Scene* scene,
                                                          const refraster::RenderOptions* options,
                                                          refraster::Frame* frame) {
  renderer->render(*scene, *options, *frame);
}

namespace refraster {
namespace {

/// The tables' numbers do not matter to the number of instructions, so that these need no file and no formula.
std::shared_ptr<const MerlTable> any_table() {
  PaddedVector<double> rgb(3 * MerlTable::samples);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = 1.0 / static_cast<double>(1 + i % 1000);
  return std::make_shared<const MerlTable>(std::move(rgb));
}

struct Workload {
  Scene scene;
  int samples = 1; // a pixel
};

/// The workloads without what scripts/make_bench_assets makes, which takes long to read where every instruction is
/// counted: the measured table is another, and of the million triangles there are as many as fit the smaller frame.
std::map<std::string, Workload> workloads(const std::string& folder) {
  std::map<std::string, Scene> scenes;
  for (const char* name : {"sphere_blinn_phong", "sphere_back_faces", "textured", "sixteen_lights",
                           "layers_back_to_front", "layers_front_to_back"})
    scenes[name] = read_scene(folder + "/" + name + ".json");

  Scene& measured = scenes["merl"] = scenes["sphere_blinn_phong"];
  measured.direction_lights = scenes["sphere_back_faces"].direction_lights;
  Merl merl;
  merl.table = any_table();
  measured.objects[0].material.fragment_function = merl;

  Scene& tiny = scenes["tiny_triangles"] = scenes["sphere_back_faces"];
  tiny.point_lights.clear();
  tiny.camera.position = {0, 0, 3};
  tiny.camera.fov_y_degrees = 45;
  tiny.objects[0].mesh = std::make_shared<const Mesh>(waves({250, 125}));

  std::map<std::string, Workload> result;
  for (const auto& [name, scene] : scenes) result[name] = {scene};
  for (const char* name : {"sphere_blinn_phong", "textured", "tiny_triangles"})
    result[name + std::string("_4_samples")] = {scenes[name], 4};
  return result;
}

void draw_all(const std::string& folder) {
  RenderOptions options;
  options.width = 320, options.height = 180;
  options.threads = 1;
  for (const auto& [name, workload] : workloads(folder)) {
    const Scene& scene = workload.scene;
    options.samples = workload.samples;
    std::apply(
        [&](auto... precision) {
          const auto draw = [&](Precision one) {
            options.precision = one;
            Renderer renderer;
            Frame frame;
            renderer.render(scene, options, frame); // what is done once and kept
            refraster_guarded_frame(&renderer, &scene, &options, &frame);
            std::cout << name << " " << name_of(one) << std::endl;
          };
          (draw(decltype(precision)::id), ...);
        },
        LanePrecisions{});
  }
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: guard_frames SCENES_FOLDER\n";
    return 2;
  }
  try {
    refraster::draw_all(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "guard_frames: " << error.what() << "\n";
    return 3;
  }
}
