// refraster gl, as a user runs it; and compare, which must find what is wrong with a shader.

#include <refraster/files.h>

#include "io/file/limits.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/program/program.h"
#include "tests/support/program/terminal.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

using namespace refraster;

namespace {

/// A variable of the environment, as long as this lives.
class Environment {
public:
  /// No value: it is not set.
  Environment(const char* name, const std::optional<std::string>& value) : name_(name) {
    if (const char* const old = std::getenv(name)) before_ = old;
    had_ = std::getenv(name) != nullptr;
    if (value) setenv(name, value->c_str(), 1);
    else unsetenv(name);
  }
  ~Environment() {
    if (had_) setenv(name_, before_.c_str(), 1);
    else unsetenv(name_);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  std::string before_;
  bool had_ = false;
};

/// A stretched ball; `material` has its fragment function, its shaders and its material.
std::string scene_with(const std::string& material) {
  return R"({"scene": {
  "camera": {"position": "0 0 5"}, "background": "0.1 0.2 0.3",
  "point_lights": [{"position": "-3 4 5", "radiance": "1 1 1", "constant": 1, "linear": 0, "quadratic": 0}],
  "direction_lights": [{"direction": "0 -1 -0.2", "radiance": "0.2 0.25 0.3"}],
  "objects": [{"mesh": {"sphere": {"segments": 48, "rings": 24}}, "name": "ball", "position": "0 0 0",
    "rotate_x": 10, "rotate_y": 25, "rotate_z": 0, "scale": "1.6 1 0.7", )" +
         material + "}]\n}}\n";
}

const std::string plastic =
    R"("material": {"ka": "0.05 0.05 0.05", "kd": "0.6 0.3 0.2", "ks": "0.5 0.5 0.5", "glossiness": 40})";
const std::string lecture_shaders = std::string(REFRASTER_SOURCE_DIR) + "/scenes/lecture/shader/";
/// Scenes of the same ball whose GLSL has one fault each; docs/lab-case.md is about them.
const std::string wrong_shaders = std::string(REFRASTER_SOURCE_DIR) + "/tests/system/gl/wrong_shaders/";

/// What `compare` says of our image of the scene and OpenGL's: allowed is what the filters of 8-bit images and edges of
/// a lattice step cost, an off-by-one anywhere and three pixels of anything.
Finished compared_file(const TemporaryFolder& folder, const std::string& scene) {
  const Finished ours =
      run_program(folder.path, {"render", scene, "-o", "ours.png", "--size", "320x240", "-q", "--allow-outside"});
  REQUIRE_MESSAGE(ours.exit_code == 0, ours.err);
  const Finished theirs = run_program(
      folder.path, {"gl", scene, "-o", "gl.png", "--size", "320x240", "--renderer", "llvmpipe", "--allow-outside"});
  REQUIRE_MESSAGE(theirs.exit_code == 0, theirs.err);
  return run_program(folder.path, {"compare", "ours.png", "gl.png", "--max-abs", "1", "--max-count", "3"});
}
Finished compared(const TemporaryFolder& folder, const std::string& scene) {
  save_text(folder / "scene.json", scene);
  return compared_file(folder, "scene.json");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

} // namespace

TEST_CASE("render and gl agree where nothing is wrong") {
  const TemporaryFolder folder;
  for (const char* const function : {"phong", "blinn_phong"}) {
    const Finished found =
        compared(folder, scene_with("\"fragment_function\": \"" + std::string(function) + "\", " + plastic));
    CHECK_MESSAGE(found.exit_code == 0, found.out);
  }
}

TEST_CASE("the example of docs/glsl-interface.md draws what render draws, without a warning") {
  const TemporaryFolder folder;
  std::string page = text_of(std::string(REFRASTER_SOURCE_DIR) + "/docs/glsl-interface.md");
  const auto next_block = [&](const std::string& language, const std::string& file) {
    const std::string opening = "\n```" + language + "\n", closing = "\n```\n";
    const std::size_t begin = page.find(opening) + opening.size(), end = page.find(closing, begin);
    REQUIRE(begin < end);
    save_text(folder / file, page.substr(begin, end + 1 - begin));
    page.erase(0, end + closing.size());
  };
  page.erase(0, page.find("## A complete example"));
  next_block("glsl", "vertex.glsl");
  next_block("glsl", "diffuse.glsl");
  next_block("json", "scene.json");
  CHECK(text_of(folder / "vertex.glsl") == text_of(lecture_shaders + "vertex.glsl"));
  const Finished run =
      run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--size", "32x24", "--renderer", "llvmpipe"});
  CHECK(run.err == "torus: vertex shader vertex.glsl, fragment shader of phong diffuse.glsl\n");
  const Finished found = compared_file(folder, "scene.json");
  CHECK_MESSAGE(found.exit_code == 0, found.out);
}

TEST_CASE("GLSL beyond the limit of its size is bad input") {
  const TemporaryFolder folder;
  save_text(folder / "f.glsl", "");
  std::filesystem::resize_file(folder / "f.glsl", limit::glsl_bytes.value + 1);
  save_text(folder / "scene.json",
            scene_with(R"("fragment_function": "phong", "fragment_shader_file_path": "f.glsl", )" + plastic));
  const Finished run = run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--size", "8x8"});
  CHECK(run.exit_code == 3);
  CHECK(run.err == "refraster: f.glsl: found 1048577 bytes, expected at most 1048576 bytes\n");
}

TEST_CASE("compare finds Phong where Blinn-Phong is asked for") {
  const TemporaryFolder folder;
  const Finished found = compared_file(folder, wrong_shaders + "highlight.json");
  CHECK_MESSAGE(found.exit_code == 1, found.out);
  const Finished none = compared(folder, scene_with(R"("fragment_function": "phong", "fragment_shader_file_path": ")" +
                                                    lecture_shaders + "phong_fs.glsl\", " + plastic));
  CHECK_MESSAGE(none.exit_code == 0, none.out);
}

TEST_CASE("compare finds normals that are transformed like positions, on an object that is stretched") {
  const TemporaryFolder folder;
  const std::string right = text_of(lecture_shaders + "vertex.glsl");
  REQUIRE(replaced(right, "mat3(transpose(inverse(model)))", "mat3(model)") ==
          text_of(wrong_shaders + "normals_vs.glsl"));
  const Finished found = compared_file(folder, wrong_shaders + "normals.json");
  CHECK_MESSAGE(found.exit_code == 1, found.out);
  save_text(folder / "vertex.glsl", right);
  const Finished none = compared(
      folder, scene_with(R"("fragment_function": "phong", "vertex_shader_file_path": "vertex.glsl", )" + plastic));
  CHECK_MESSAGE(none.exit_code == 0, none.out);
}

TEST_CASE("compare finds a measured BRDF that is cut off at phi_d = 0 instead of going on at pi") {
  const TemporaryFolder folder;
  const std::string right = text_of(std::string(REFRASTER_SOURCE_DIR) + "/tests/system/gl/merl_fs.glsl");
  REQUIRE(replaced(right, "if (phi_d < 0.0) phi_d += pi;", "phi_d = max(phi_d, 0.0);") ==
          text_of(wrong_shaders + "phi_d_fs.glsl"));
  const Finished found = compared_file(folder, wrong_shaders + "phi_d.json");
  CHECK_MESSAGE(found.exit_code == 1, found.out);
  REQUIRE(run_program(folder.path, {"brdf", "synth", "brass-like", "-o", "brass.binary"}).exit_code == 0);
  save_text(folder / "merl_fs.glsl", right);
  const Finished none =
      compared(folder, scene_with(R"("fragment_function": "merl", "fragment_shader_file_path": "merl_fs.glsl",
    "material": {"brdf_file_path": "brass.binary"})"));
  CHECK_MESSAGE(none.exit_code == 0, none.out);
}

TEST_CASE("compare finds a light's sign, an attenuation left out and a texture turned over, each the only fault") {
  struct Fault {
    std::string name, right, wrong;
  };
  const std::vector<Fault> faults = {
      {"light_sign", "normalize(-light.direction)", "normalize(light.direction)"},
      {"attenuation", "1.0 / (light.constant + light.linear * d + light.quadratic * d * d)", "1.0"},
      {"texture", "texture(tex, fs_in.TexCoord)", "texture(tex, vec2(fs_in.TexCoord.x, 1.0 - fs_in.TexCoord.y))"}};
  const std::string root = "../../../../", lecture = text_of(lecture_shaders + "phong_fs.glsl");
  for (const Fault& fault : faults) {
    CAPTURE(fault.name);
    REQUIRE(replaced(lecture, fault.right, fault.wrong) == text_of(wrong_shaders + fault.name + "_fs.glsl"));
    const TemporaryFolder folder;
    const Finished found = compared_file(folder, wrong_shaders + fault.name + ".json");
    CHECK_MESSAGE(found.exit_code == 1, found.out);
    std::string scene = replaced(text_of(wrong_shaders + fault.name + ".json"), fault.name + "_fs.glsl",
                                 lecture_shaders + "phong_fs.glsl");
    if (holds(scene, root)) scene = replaced(scene, root, std::string(REFRASTER_SOURCE_DIR) + "/");
    const Finished none = compared(folder, scene);
    CHECK_MESSAGE(none.exit_code == 0, none.out);
  }
}

TEST_CASE("compare finds no fault in face normals by derivatives, and one where dFdy has the wrong sign") {
  const TemporaryFolder folder;
  const std::string lecture = text_of(lecture_shaders + "phong_fs.glsl");
  const std::string cube =
      replaced(scene_with(R"("fragment_function": "phong", "fragment_shader_file_path": "face_fs.glsl", )" + plastic),
               R"("sphere": {"segments": 48, "rings": 24})", R"("cube": {})");
  for (const bool right : {true, false}) {
    const std::string normal =
        right ? "cross(dFdx(fs_in.FragPos), dFdy(fs_in.FragPos))" : "cross(dFdx(fs_in.FragPos), -dFdy(fs_in.FragPos))";
    save_text(folder / "face_fs.glsl", replaced(lecture, "fs_in.Normal)", normal + ")"));
    const Finished found = compared(folder, cube);
    CHECK_MESSAGE(found.exit_code == (right ? 0 : 1), found.out);
  }
}

TEST_CASE("a line for each object says whose shaders draw it") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  const Finished run =
      run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--size", "32x24", "--renderer", "llvmpipe"});
  CHECK(run.exit_code == 0);
  CHECK(run.out == "gl.png\n");
  CHECK(run.err ==
        "ball: vertex shader ours (the scene names none), fragment shader of phong ours (the scene names none)\n");
}

TEST_CASE("an error in a shader is bad input, told with file and line") {
  const TemporaryFolder folder;
  save_text(folder / "fs.glsl",
            "#version 330 core\nout vec4 FragColor;\nvoid main() { FragColor = vec4(colour, 1.0); }\n");
  save_text(folder / "scene.json",
            scene_with(R"("fragment_function": "phong", "fragment_shader_file_path": "fs.glsl", )" + plastic));
  const Finished run = run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--renderer", "llvmpipe"});
  CHECK(run.exit_code == 3);
  CHECK_MESSAGE(holds(run.err, "fs.glsl:3:"), run.err);
  CHECK_MESSAGE(holds(run.err, "`colour' undeclared"), run.err);
  CHECK_FALSE(std::filesystem::exists(folder / "gl.png"));
}

TEST_CASE("a scene that is not there is bad input") {
  const TemporaryFolder folder;
  const Finished run = run_program(folder.path, {"gl", "nowhere.json", "-o", "gl.png"});
  CHECK(run.exit_code == 3);
  CHECK_MESSAGE(holds(run.err, "nowhere.json"), run.err);
}

TEST_CASE("an unknown renderer is wrong usage, and the message names those there are") {
  const TemporaryFolder folder;
  const Finished run = run_program(folder.path, {"gl", "scene.json", "--renderer", "voodoo"});
  CHECK(run.exit_code == 2);
  CHECK_MESSAGE(holds(run.err, "found \"voodoo\", expected one of default, llvmpipe, softpipe"), run.err);
}

TEST_CASE("file names must end in a format that holds what is asked for") {
  const TemporaryFolder folder;
  CHECK(run_program(folder.path, {"gl", "scene.json", "-o", "gl.exr"}).exit_code == 2);
  CHECK(run_program(folder.path, {"gl", "scene.json", "--float", "gl.png"}).exit_code == 2);
  CHECK(run_program(folder.path, {"gl", "scene.json", "--depth", "gl.hdr"}).exit_code == 2);
  CHECK(run_program(folder.path, {"gl", "scene.json", "--ids", "gl.hdr"}).exit_code == 2); // which rounds to 8 bits
  CHECK(run_program(folder.path, {"gl", "scene.json", "-o", "nowhere/gl.png"}).exit_code == 4);
}

TEST_CASE("without an EGL library gl says what to install, and everything else works") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  std::filesystem::create_directory(folder / "libraries");
  save_text(folder / "libraries/libEGL.so.1", "not a library");
  const Environment path("LD_LIBRARY_PATH", folder / "libraries");
  const Finished run = run_program(folder.path, {"gl", "scene.json", "-o", "gl.png"});
  CHECK(run.exit_code == 5);
  CHECK_MESSAGE(holds(run.err, "no EGL library"), run.err);
  CHECK_MESSAGE(holds(run.err, "libegl1 and libgl1-mesa-dri"), run.err);
  CHECK(run_program(folder.path, {"render", "scene.json", "-o", "ours.png", "--size", "16x12"}).exit_code == 0);
}

TEST_CASE("where a variable of the environment keeps the driver from starting, it is named") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  // What this process has been told by a test.
  const Environment driver("GALLIUM_DRIVER", std::nullopt), software("LIBGL_ALWAYS_SOFTWARE", std::nullopt);
  const std::pair<const char*, std::string> variables[] = {
      {"GALLIUM_DRIVER", "bogus"},
      {"MESA_GL_VERSION_OVERRIDE", "2.1"},
      {"MESA_GLSL_VERSION_OVERRIDE", "130"},
      {"LIBGL_DRIVERS_PATH", folder.path},
      {"__EGL_VENDOR_LIBRARY_DIRS", folder.path}, // glvnd finds no vendor there
      {"__EGL_VENDOR_LIBRARY_FILENAMES", folder / "none.json"},
  };
  for (const auto& variable : variables) {
    const std::string name = variable.first, value = variable.second; // clang++ 14 captures no bindings
    INFO(name);
    const Environment set(variable.first, value);
    const Finished run = run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--size", "8x8"});
    CHECK(run.exit_code == 5);
    CHECK_MESSAGE(
        holds(run.err, "; the environment chooses the driver: try again with this unset: " + name + "=" + value + "\n"),
        run.err);
    CHECK_FALSE(holds(run.err, "install"));
  }
}

TEST_CASE("a variable that gl itself sets is not blamed") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  const Environment driver("GALLIUM_DRIVER", "bogus"), version("MESA_GL_VERSION_OVERRIDE", "2.1");
  const Finished run =
      run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--size", "8x8", "--renderer", "llvmpipe"});
  CHECK(run.exit_code == 5);
  CHECK_MESSAGE(holds(run.err, "with this unset: MESA_GL_VERSION_OVERRIDE=2.1\n"), run.err);
}

TEST_CASE("on a terminal gl says that it is drawing, and with -q nothing") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  // Far more than a second's work on any machine; it is given up when it has said what it does.
  const OnTerminal found = interrupt_on_terminal(
      folder.path, {"gl", "scene.json", "--renderer", "softpipe", "--frames", "1000000", "-o", "gl.png"},
      "drawing scene.json");
  CHECK(found.exit_code == 130);
  CHECK(found.exit_code_quietly == 130);
  CHECK(!holds(found.shown_quietly, "scene.json"));
}

TEST_CASE("NaN and infinity are counted where only 8 bits are asked for, and in the report") {
  const TemporaryFolder folder;
  save_text(folder / "fs.glsl", "#version 330 core\nout vec4 FragColor;\nuniform float zero;\n"
                                "void main() { FragColor = vec4(0.5, zero / zero, 0.5, 1.0); }\n");
  save_text(folder / "scene.json",
            scene_with(R"("cull": "back", "fragment_function": "phong", "fragment_shader_file_path": "fs.glsl", )" +
                       plastic));
  const Finished run = run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--json", "report.json", "--size",
                                                 "64x48", "--renderer", "llvmpipe"});
  CHECK(run.exit_code == 0);
  const std::string report = text_of(folder / "report.json");
  const std::size_t begin = report.find("\"samples_passed\": ") + 18;
  const std::string samples = report.substr(begin, report.find(',', begin) - begin); // one sample a pixel, each once
  REQUIRE(std::stoi(samples) > 100);
  CHECK_MESSAGE(holds(report, "\"nan_pixels\": " + samples + ","), report);
  CHECK(holds(report, "\"infinite_pixels\": 0,"));
  CHECK_MESSAGE(holds(run.err, "warning: " + samples + " pixels are NaN, the first at "), run.err);
  const Finished quiet = run_program(folder.path, {"gl", "scene.json", "-q", "--size", "64x48"});
  CHECK(quiet.err.empty());
}

TEST_CASE("times of frames and the driver's words are on standard output as JSON, and nothing else is") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  const Finished run = run_program(
      folder.path, {"gl", "scene.json", "--frames", "3", "--json", "-", "--size", "64x48", "--renderer", "softpipe"});
  CHECK(run.exit_code == 0);
  CHECK(run.out.front() == '{');
  for (const char* const words : {"\"renderer\": \"softpipe\"", "\"frames\": 3", "\"frame_ms\": {",
                                  "\"median\": ", "\"cpu_ms\": {", "\"samples_passed\": "})
    CHECK_MESSAGE(holds(run.out, words), words);
  CHECK(files_in(folder) == std::vector<std::string>{"scene.json"});
}

TEST_CASE("depth is that of render") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  REQUIRE(run_program(folder.path, {"gl", "scene.json", "--depth", "gl.pfm", "--float", "gl.exr", "--size", "160x120",
                                    "--renderer", "llvmpipe"})
              .exit_code == 0);
  REQUIRE(run_program(folder.path, {"render", "scene.json", "-o", "ours.exr", "--aov", "depth", "--size", "160x120"})
              .exit_code == 0);
  // Window depth is interpolated from 24-bit corners: 2^-24, and the slope of the ball's side times the half lattice
  // step of our snapping. Three pixels may lie on an edge.
  const Finished found = run_program(folder.path, {"compare", "ours.depth.exr", "gl.pfm", "--unit", "values",
                                                   "--max-abs", "1e-4", "--max-count", "3"});
  CHECK_MESSAGE(found.exit_code == 0, found.out);
}

TEST_CASE("one run gives the 8-bit and the float image, depth and ids, which are those of render's AOVs") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  const Finished run =
      run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--float", "gl.exr", "--depth", "depth.pfm",
                                "--ids", "ids.exr", "--size", "160x120", "--renderer", "llvmpipe"});
  REQUIRE_MESSAGE(run.exit_code == 0, run.err);
  CHECK(run.out == "gl.png\ngl.exr\ndepth.pfm\nids.exr\n");
  CHECK_FALSE(holds(run.err, "warning"));
  REQUIRE(
      run_program(folder.path, {"gl", "scene.json", "--ids", "ids.pfm", "--size", "160x120", "--renderer", "llvmpipe"})
          .out == "ids.pfm\n");
  REQUIRE(run_program(folder.path,
                      {"render", "scene.json", "-o", "ours.exr", "--aov", "object,triangle", "--size", "160x120"})
              .exit_code == 0);
  const ImageFile ids = read_image(folder / "ids.exr"), padded = read_image(folder / "ids.pfm");
  CHECK(ids.channels == std::vector<std::string>{"object", "triangle"});
  const Image<float> objects = read_image(folder / "ours.object.exr").values,
                     triangles = read_image(folder / "ours.triangle.exr").values,
                     depth = read_image(folder / "depth.pfm").values;
  int differ = 0, drawn = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      const float* const here = ids.values.at(x, y);
      differ += here[0] != *objects.at(x, y) || here[1] != *triangles.at(x, y);
      drawn += here[0] != 0;
      REQUIRE((here[0] != 0) == (*depth.at(x, y) < 1));
      for (int c = 0; c < 3; ++c) REQUIRE(padded.values.at(x, y)[c] == (c < 2 ? here[c] : 0));
    }
  CHECK(drawn > 1000);
  CHECK(differ <= drawn / 100); // edges within a lattice step
}

TEST_CASE("with --samples the report says where they lie, and a number that the driver does not have is told") {
  const TemporaryFolder folder;
  save_text(folder / "scene.json", scene_with(R"("fragment_function": "phong", )" + plastic));
  const auto drawn = [&](const std::string& samples) {
    return run_program(folder.path, {"gl", "scene.json", "-o", "gl.png", "--json", "-", "--size", "64x48", "--renderer",
                                     "llvmpipe", "--samples", samples});
  };
  const Finished four = drawn("4");
  CHECK(four.exit_code == 0);
  CHECK_MESSAGE(holds(four.out, "\"samples\": 4,\n"), four.out);
  CHECK_MESSAGE(holds(four.out, "\"sample_positions\": ["), four.out);
  const Finished eight = drawn("8");
  CHECK(eight.exit_code == 5);
  CHECK_MESSAGE(holds(eight.err, "does not draw 8 samples a pixel, but 1 or 4"), eight.err);
  CHECK(drawn("3").exit_code == 2);
}

TEST_CASE("a model's own number of samples becomes one that the driver has, with a note") {
  const TemporaryFolder folder;
  save_text(folder / "model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto run = [&](const char* command, const std::string& renderer, std::vector<std::string> more) {
    std::vector<std::string> words{command, "model.obj", "--size", "64x48", "--renderer", renderer, "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder.path, words);
  };
  const struct {
    std::string renderer, samples, said;
  } drivers[] = {{"llvmpipe", "4", "does not draw 8 samples a pixel, but 1 or 4: drawn with 4"},
                 {"softpipe", "1", "does not draw 8 samples a pixel, but 1: drawn with 1"}};
  for (const auto& driver : drivers) {
    CAPTURE(driver.renderer);
    const Finished drawn = run("gl", driver.renderer, {"-o", "gl.png"});
    CHECK(drawn.exit_code == 0);
    CHECK_MESSAGE(holds(drawn.out, "\"samples\": " + driver.samples + ",\n"), drawn.out);
    CHECK_MESSAGE(holds(drawn.err, driver.said), drawn.err);
    const Finished judged = run("verify", driver.renderer, {"--gl"});
    CHECK_MESSAGE(judged.exit_code == 0, judged.err);
    CHECK_MESSAGE(holds(judged.err, driver.said), judged.err);
    CHECK_MESSAGE(holds(judged.out, "\"samples\": " + driver.samples + ","), judged.out);
    CHECK(run("gl", driver.renderer, {"-o", "gl.png", "--samples", "8"}).exit_code == 5);
  }
}
