// refraster_micro: how long the parts of a frame take, each by itself. bench/micro/run.

#include "bench/micro/micro.h"

int main(int argc, char** argv) {
  using namespace refraster::micro;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  add_elementary();
  add_fragment_functions();
  add_measured_brdf();
  add_textures();
  add_triangles();
  benchmark::RunSpecifiedBenchmarks();
}
