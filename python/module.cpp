// import refraster

#include "io/file/build_info.h"
#include "python/bindings.h"

PYBIND11_MODULE(refraster, module) {
  using namespace refraster::python;
  module.doc() =
      "A reference for images of triangles: renders, compares and explains them, without a GPU. docs/python.md";
  module.attr("__version__") = refraster::this_build().version;
  bind_errors(module);
  bind_meshes(module);
  bind_textures(module);
  bind_fragment_functions(module);
  bind_lights(module);
  bind_scenes(module);
  bind_frames(module);
  bind_reports(module);
  bind_brdf(module);
  bind_bench(module);
}
