// refraster mesh, refraster brdf

#include <refraster/files.h>
#include <refraster/mesh.h>

#include "tests/support/program/program.h"

#include <doctest/doctest.h>

using namespace refraster;

TEST_CASE("each shape is written as OBJ, and reads back as it was made") {
  const TemporaryFolder folder;
  const Finished run =
      run_program(folder.path, {"mesh", "sphere", "--segments", "12", "--rings", "6", "-o", "ball.obj"});
  CHECK(run.exit_code == 0);
  CHECK(run.out == "ball.obj\n");
  const Mesh made = sphere_mesh(12, 6), read = read_obj(folder / "ball.obj");
  REQUIRE(read.triangles.size() == made.triangles.size());
  for (std::size_t t = 0; t < made.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner)
      CHECK(read.positions[read.triangles[t][corner]] == made.positions[made.triangles[t][corner]]);

  for (const char* shape : {"cube", "plane", "torus"}) {
    CHECK(run_program(folder.path, {"mesh", shape}).out == std::string(shape) + ".obj\n");
    CHECK_FALSE(read_obj(folder / (std::string(shape) + ".obj")).triangles.empty());
  }
}

TEST_CASE("a mesh that cannot be written is exit code 4") {
  const TemporaryFolder folder;
  CHECK(run_program(folder.path, {"mesh", "cube", "-o", "none/cube.obj"}).exit_code == 4);
}

TEST_CASE("a table that is not one is exit code 3") {
  const TemporaryFolder folder;
  save_text(folder / "short.binary", "short");
  for (const char* file : {"short.binary", "none.binary", "."})
    CHECK(run_program(folder.path, {"brdf", "info", file}).exit_code == 3);
}

TEST_CASE("a synthetic table has the facts that its formula has" * doctest::test_suite("slow")) {
  const TemporaryFolder folder;
  const Finished made =
      run_program(folder.path, {"brdf", "synth", "lambert", "--albedo", "0.2,0.4,0.8", "-o", "l.binary"});
  CHECK(made.exit_code == 0);
  CHECK(made.out == "l.binary\n");
  CHECK(std::filesystem::file_size(folder / "l.binary") == 34'992'012); // 12 + 8 * 3 * 90 * 90 * 180
  const Finished info = run_program(folder.path, {"brdf", "info", "l.binary"});
  CHECK(info.exit_code == 0);
  CHECK(info.out.find("90 x 90 x 180") != std::string::npos);
  CHECK(info.out.find("not one of the 100") != std::string::npos);
  CHECK(info.out.find("  30 degrees              0.2          0.4          0.8") != std::string::npos);
}
