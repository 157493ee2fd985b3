// Without an OpenGL to compare with, the tests say so and are skipped (77, as ctest is told).

#define DOCTEST_CONFIG_IMPLEMENT
#include "gl/render_gl.h"

#include <doctest/doctest.h>

#include <cstdio>

int main(int argc, char** argv) {
  using namespace refraster;
  GlOptions options;
  options.width = options.height = 1;
  options.renderer = GlRenderer::llvmpipe;
  try {
    render_gl(Scene{}, options);
  } catch (const NoOpenGl& error) {
    std::printf("SKIPPED, not tested: %s\n", error.what());
    return 77;
  }
  return doctest::Context(argc, argv).run();
}
