// refraster brdf: what its commands write, and what is said of bad input.

#include <refraster/files.h>

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace refraster;
using namespace refraster::test;

namespace {

using Words = std::vector<std::string>;

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

} // namespace

TEST_CASE("models are looked into by name") {
  const TemporaryFolder folder;
  const Finished run = run_program(folder.path, {"brdf", "eval", "diffuse:albedo=.5", "--angles", "30,40,50", "--half",
                                                 "0,30,0", "--directions", "-1,0,1,0,0,2"});
  CHECK(run.exit_code == 0);
  CHECK(first_line(run.out) == "theta_in,theta_out,dphi,theta_h,theta_d,phi_d,r,g,b");
  CHECK(run.out.find(",0.15915494309189535,0.15915494309189535,0.15915494309189535\n") != std::string::npos);
  CHECK(std::count(run.out.begin(), run.out.end(), '\n') == 4);
  const Finished json =
      run_program(folder.path, {"brdf", "eval", "blinn_phong:ks=.5,glossiness=32", "--half", "0,30,0", "--json", "-"});
  CHECK(json.out.find("\"brdf\": \"blinn_phong:ks=.5,glossiness=32\"") != std::string::npos);
}

TEST_CASE("values come back through a file: eval, and eval of what it wrote") {
  const TemporaryFolder folder;
  save_text(folder / "p.csv", "theta_h,theta_d,phi_d\n0,10,0\n20,30,40\n");
  CHECK(run_program(folder.path, {"brdf", "eval", "phong", "--points", "p.csv", "-o", "a.csv"}).exit_code == 0);
  CHECK(run_program(folder.path, {"brdf", "eval", "phong", "--points", "a.csv", "-o", "b.csv"}).exit_code == 0);
  CHECK(std::filesystem::exists(folder / "b.csv"));
}

TEST_CASE("what is wrong with a model or its directions is exit code 2, with what was found and expected") {
  const TemporaryFolder folder;
  const auto said_of = [&](const Words& words) {
    const Finished run = run_program(folder.path, words);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    return first_line(run.err);
  };
  CHECK(said_of({"brdf", "info", "phong:gloss=3"}) ==
        "refraster: phong: found \"gloss\", expected one of ka, kd, ks, glossiness, specular_gate; did you mean "
        "glossiness?");
  CHECK(said_of({"brdf", "info", "phong:ks=-1"}) ==
        "refraster: phong:ks: found \"-1\", expected a number >= 0, or three, with commas between them");
  CHECK(said_of({"brdf", "compare", "phong", "phog:ks=1"})
            .starts_with("refraster: B: found \"phog\", expected one of lambert"));
  CHECK(said_of({"brdf", "eval", "phong"}) ==
        "refraster: brdf eval: found nothing, expected one of --angles, --half, --directions, --points");
  CHECK(said_of({"brdf", "eval", "phong", "--angles", "30,91,0"}) ==
        "refraster: --angles: found \"30,91,0\", expected three angles in degrees, the first two from 0 to 90");
  CHECK(said_of({"brdf", "eval", "phong", "--directions", "0,0,0,0,0,1"}).find("two vectors that are not 0") !=
        std::string::npos);
  CHECK(said_of({"brdf", "compare", "phong", "phong", "--max-rms", "-1"}).find("a number >= 0") != std::string::npos);
  CHECK(said_of({"brdf", "plot", "phong", "-o", "x.png"}).find("a name ending in .html") != std::string::npos);
  CHECK(said_of({"brdf", "fit", "phong"}).starts_with("refraster: brdf fit: found nothing, expected --to"));
  CHECK(said_of({"brdf", "fit", "phong", "--to", "ward"})
            .starts_with("refraster: --to: found \"ward\", expected one of phong"));
  CHECK(said_of({"brdf", "fit", "phong", "--to", "phong", "--lobes", "4"}).find("one of 1, 2, 3") != std::string::npos);
  CHECK(said_of({"brdf", "fit", "phong", "--to", "ggx-conductor", "-o", "-"}).find("a table is written beside it") !=
        std::string::npos);
  CHECK(said_of({"merl"}) == "refraster: found \"merl\", expected brdf, as it is called now");
  CHECK(said_of({"merl", "info", "x.binary"}) == "refraster: found \"merl\", expected brdf, as it is called now");
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("what is wrong with a file is exit code 3") {
  const TemporaryFolder folder;
  save_text(folder / "t.csv", "theta_in,theta_out,dphi\n1,2\n");
  save_text(folder / "n.csv", "theta_in,theta_out,dphi,r,g,b\n0,0,0,-1,0,0\n10,0,0,.1,.1,.1\n");
  save_text(folder / "short.binary", "short");
  const auto said_of = [&](const Words& words) {
    const Finished run = run_program(folder.path, words);
    CHECK(run.exit_code == 3);
    return first_line(run.err);
  };
  CHECK(said_of({"brdf", "info", "phongg"}).ends_with("; did you mean phong?"));
  CHECK(said_of({"brdf", "info", "phongg"})
            .starts_with("refraster: phongg: found no such file, expected a MERL table, or one of"));
  CHECK(said_of({"brdf", "info", "./phong"}).find("a MERL table") != std::string::npos);
  CHECK(said_of({"brdf", "compare", "phong", "short.binary"}).starts_with("refraster: short.binary: "));
  CHECK(said_of({"brdf", "eval", "phong", "--points", "t.csv"}) ==
        "refraster: t.csv:2: found 2 cells, expected 3, as the first line has");
  CHECK(said_of({"brdf", "import", "t.csv"}) == "refraster: t.csv:2: found 2 cells, expected 3, as the first line has");
  CHECK(said_of({"brdf", "import", "none.csv"}).find("a table of numbers") != std::string::npos);
  CHECK(said_of({"brdf", "import", "n.csv", "--strict"}).find("n.csv:2: ") != std::string::npos);
}

TEST_CASE("what cannot be written is exit code 4, before anything is computed") {
  const TemporaryFolder folder;
  for (const Words& words : std::vector<Words>{{"brdf", "plot", "phong", "-o", "none/x.html"},
                                               {"brdf", "fit", "phong", "--to", "phong", "--json", "none/x.json"},
                                               {"brdf", "compare", "phong", "phong", "--json", "none/x.json"},
                                               {"brdf", "eval", "phong", "--half", "0,0,0", "-o", "none/x.csv"}})
    CHECK(run_program(folder.path, words).exit_code == 4);
}

TEST_CASE("comparing says by its exit code whether two are the same within limits" * doctest::test_suite("slow")) {
  const TemporaryFolder folder;
  const auto code = [&](Words words) {
    words.insert(words.begin(), {"brdf", "compare"});
    return run_program(folder.path, words).exit_code;
  };
  CHECK(code({"lambert", "diffuse", "-q"}) == 0);
  CHECK(code({"lambert", "lambert:albedo=.6", "-q"}) == 1);
  CHECK(code({"lambert", "lambert:albedo=.6", "--max-rms", "0.04"}) == 0);
  CHECK(code({"lambert", "lambert:albedo=.6", "--max-rms", "0.04", "--max-log-rms", "0.001"}) == 1);
}

TEST_CASE("a fit is a material that render takes" * doctest::test_suite("slow")) {
  const TemporaryFolder folder;
  const Finished fit =
      run_program(folder.path, {"brdf", "fit", "blinn_phong:kd=.2,ks=.5,glossiness=40", "--to", "blinn_phong", "-o",
                                "m.json", "--json", "f.json", "--html", "f.html"});
  CHECK(fit.exit_code == 0);
  CHECK(fit.out.find("as a model       blinn_phong:kd=") != std::string::npos);
  const std::string material = text_of(folder / "m.json");
  save_text(folder / "s.json", R"({"scene": {"camera": {"position": [0, 0, 4], "target": [0, 0, 0], "fov_y": 40},
    "point_lights": [], "direction_lights": [{"direction": [0, 0, -1], "radiance": [1, 1, 1]}],
    "objects": [{"mesh": {"sphere": {}}, "position": [0, 0, 0], "rotate_x": 0, "rotate_y": 0, "rotate_z": 0,
      "scale": [1, 1, 1], )" + material.substr(1, material.rfind('}') - 1) +
                                   "}]}}");
  const Finished run = run_program(folder.path, {"render", "s.json", "-o", "s.png", "--size", "16x16"});
  CHECK_MESSAGE(run.exit_code == 0, run.err);
  const Finished table =
      run_program(folder.path, {"brdf", "fit", "brass-like", "--to", "ggx-conductor", "-o", "g.json"});
  CHECK(table.exit_code == 0);
  CHECK(std::filesystem::file_size(folder / "g.binary") == 34'992'012);
  CHECK(text_of(folder / "g.json").find("\"brdf_file_path\": \"g.binary\"") != std::string::npos);
}

TEST_CASE("pictures are written, one by one or as a page" * doctest::test_suite("slow")) {
  const TemporaryFolder folder;
  CHECK(run_program(folder.path, {"brdf", "plot", "lambert", "brass-like", "--svg", "figures"}).exit_code == 0);
  for (const char* const name : {"slices", "profile", "lobes", "albedo"})
    CHECK(text_of(folder / ("figures/" + std::string(name) + ".svg")).starts_with("<svg"));
  CHECK_FALSE(std::filesystem::exists(folder / "brdf.html"));
  CHECK(run_program(folder.path, {"brdf", "plot", "lambert"}).exit_code == 0);
  CHECK(text_of(folder / "brdf.html").starts_with("<!doctype html>"));
}

TEST_CASE("a table is made of a CSV file" * doctest::test_suite("slow")) {
  const TemporaryFolder folder;
  save_text(folder / "m.csv", "theta_in,theta_out,dphi,r,g,b\n0,10,0,.1,.1,.1\n10,0,0,.2,.1,.1\n30,30,180,.2,.2,.2\n");
  const Finished run = run_program(folder.path, {"brdf", "import", "m.csv", "-o", "m.binary"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.find("note: m.csv:2: found 1 pair of rows that differ by up to 0.5") != std::string::npos);
  CHECK(run.out.starts_with("m.binary\n3 rows in 2 of "));
  CHECK(std::filesystem::file_size(folder / "m.binary") == 34'992'012);
}
