// Models that OpenGL draws: by the same scene, at the same place, and right in every pixel.

#include "tests/support/program/program.h"

#include <doctest/doctest.h>

using namespace refraster;

TEST_CASE("gl draws a model as render does, and verify finds nothing unexplained") {
  const TemporaryFolder folder;
  save_text(folder / "house.obj",
            "mtllib house.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nv 0 2 0\n"
            "usemtl the wall\nf 4 3 7 8\nf 3 2 6 7\nf 2 1 5 6\nf 1 4 8 5\nusemtl the roof\nf 8 7 9\nf 7 6 9\nf 6 5 9\n"
            "f 5 8 9\n");
  save_text(folder / "house.mtl", "newmtl the wall\nKd 0.9 0.9 0.8\nnewmtl the roof\nKd 0.8 0.1 0.05\nKs 0.2 0.2 0.2\n");
  for (const char* const samples : {"1", "4"}) {
    CAPTURE(samples);
    const Finished verdict = run_program(
        folder.path, {"verify", "house.obj", "--gl", "--size", "160x120", "--samples", samples, "--renderer", "llvmpipe"});
    CHECK_MESSAGE(verdict.exit_code == 0, verdict.out + verdict.err);
  }
  const Finished drawn =
      run_program(folder.path, {"gl", "house.obj", "--size", "160x120", "--samples", "1", "--renderer", "llvmpipe"});
  CHECK_MESSAGE(drawn.exit_code == 0, drawn.err);
  CHECK(drawn.out == "house.gl.png\n");
  run_program(folder.path, {"render", "house.obj", "--size", "160x120", "--samples", "1"});
  // Both have the sRGB curve, of values that differ by rounding.
  const Finished compared = run_program(folder.path, {"compare", "house.png", "house.gl.png", "--max-abs", "1",
                                                      "--max-count", "20"});
  CHECK_MESSAGE(compared.exit_code == 0, compared.out);
  // The file is judged by the scene's picture too; that of another curve is not right.
  const std::vector<std::string> verify = {"verify", "house.obj", "house.gl.png", "--samples", "1", "-q", "--device",
                                           "llvmpipe"};
  CHECK(run_program(folder.path, verify).exit_code == 0);
  std::vector<std::string> linear = verify;
  linear.push_back("--linear");
  CHECK(run_program(folder.path, linear).exit_code == 1);
}
