// What gl finds out about programs and drivers, part by part.

#include <refraster/notes.h>

#include "gl/context/context.h"
#include "gl/context/driver_environment.h"
#include "gl/context/target.h"
#include "gl/draw/drawing.h"
#include "gl/program/glsl_types.h"
#include "gl/program/program.h"
#include "gl/warning_list.h"
#include "scenes/synthesis/merl_synthesis.h"
#include "tests/support/program/program.h"
#include "tests/system/gl/small_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace refraster;

namespace {

GlOptions small_image() {
  GlOptions options;
  options.width = 64, options.height = 48;
  options.renderer = GlRenderer::llvmpipe;
  options.want_rgb8 = false;
  options.want_radiance = true;
  return options;
}

/// A quad that fills the window whatever the camera, with this fragment shader.
struct FullWindow {
  TemporaryFolder folder;
  Scene scene;

  explicit FullWindow(const std::string& fragment, FragmentFunction function = Phong{}) {
    save_text(folder / "vs.glsl", "#version 330 core\nlayout(location = 0) in vec3 vPos;\n"
                                  "void main() { gl_Position = vec4(vPos.xz, 0.0, 1.0); }\n");
    save_text(folder / "fs.glsl", "#version 330 core\nout vec4 FragColor;\n" + fragment);
    Object object;
    object.name = "quad";
    object.mesh = std::make_shared<const Mesh>(plane_mesh(1));
    object.material.fragment_function = std::move(function);
    object.vertex_shader_path = folder / "vs.glsl";
    object.fragment_shader_path = folder / "fs.glsl";
    scene.objects = {object};
  }
};

std::vector<std::string> messages(const std::string& log) {
  std::vector<std::string> found;
  for (const LogLine& line : parse_log(log)) found.push_back(line.message);
  return found;
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("NaN and infinite pixels are counted, each once, and the first of each is named") {
  // 16 columns of NaN, 16 of infinity, in one and in all channels, and 32 of numbers; all rows alike.
  const FullWindow window(
      "uniform float zero;\n"
      "void main() {\n"
      "    float column = floor(gl_FragCoord.x);\n"
      "    if (column < 16.0) FragColor = vec4(0.0, 0.0, zero / zero, 1.0);\n"
      "    else if (column < 32.0) FragColor = vec4(1.0 / zero);\n"
      "    else FragColor = vec4(1e30, 0.0, 0.5, zero / zero);\n" // alpha is no channel of the image
      "}\n");
  for (const bool wanted : {true, false}) {
    GlOptions options = small_image();
    options.want_radiance = wanted;
    const GlFrame frame = render_gl(window.scene, options);
    CHECK(frame.non_finite.nan == 16 * 48);
    CHECK(frame.non_finite.infinite == 16 * 48);
    CHECK(frame.non_finite.infinite_x == 16);
    CHECK(frame.non_finite.infinite_y == 0);
    CHECK(frame.radiance.values.empty() == !wanted);
    REQUIRE(frame.warnings.size() == 3);
    CHECK(frame.warnings[1] ==
          "768 pixels are NaN, the first at 0,0 from the top left: what 8 bits show there is the driver's choice");
  }
}

TEST_CASE("what one object is given does not reach the next one that has the same shaders") {
  const std::string shader =
      "uniform vec3 kd;\nuniform sampler3D merlBrdf;\n"
      "void main() { FragColor = vec4(kd, 1.0) + vec4(texture(merlBrdf, vec3(0.5, 0.2, 0.1)).rgb, 0.0); }\n";
  const FullWindow window(shader);
  Scene scene = window.scene;
  Phong bright;
  bright.kd = Double3(1);
  scene.objects[0].material.fragment_function = bright;
  scene.objects[0].name = "bright";
  Merl measured;
  measured.table.reset(new MerlTable(merl_table_from(Lambert{Double3(1)})));
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].material.fragment_function = measured;
  scene.objects[1].name = "measured";
  std::swap(scene.objects[0], scene.objects[1]); // depth LESS: the first one is seen
  const GlFrame first = render_gl(scene, small_image());
  std::swap(scene.objects[0], scene.objects[1]);
  const GlFrame second = render_gl(scene, small_image());
  CHECK(second.radiance.at(3, 3)[0] == 1);
  // Lambert's f is 1/pi, in 1/sr and not in units of a file of measurements; the table holds floats.
  CHECK(first.radiance.at(3, 3)[0] == doctest::Approx(std::numbers::inv_pi).epsilon(4 * 0x1p-24));
  CHECK(first.warnings ==
        Lines{"measured: uniform vec3 kd is not set for the fragment function merl: it stays 0",
              "bright: uniform sampler3D merlBrdf is not set for the fragment function phong: it reads "
              "(0, 0, 0, 1)"});
}

TEST_CASE("what is to be said of several objects is said once, with their names") {
  // Whatever is in `a`, the colour is a number: of NaN there would be more to say.
  const FullWindow window("uniform vec4 tint;\nvoid main() { vec3 a; FragColor = tint + vec4(a.x > 0.0); }\n");
  Scene scene = window.scene;
  for (const char* const name : {"second", "third"}) {
    scene.objects.push_back(scene.objects[0]);
    scene.objects.back().name = name;
  }
  GlOptions options = small_image();
  options.want_ids = true; // links the vertex shader again
  CHECK(render_gl(scene, options).warnings ==
        Lines{(window.folder / "fs.glsl") + ":4:47: the compiler warns: `a' used uninitialized",
              "quad, second, third: uniform vec4 tint is not one that refraster sets: it stays 0"});

  WarningList list;
  for (const char* const name : {"a", "b", "c", "d", "e"}) list.add(name, "text");
  list.add("text of none");
  list.add("text of none");
  CHECK(list.lines() == Lines{"a and 4 more: text", "text of none"});
}

TEST_CASE("an object that another one hides, or that is out of view, is no fault of its shaders") {
  const FullWindow window("void main() { FragColor = vec4(1.0); }\n");
  Scene scene = window.scene;
  scene.objects.push_back(scene.objects[0]); // the same depth: not one sample of it is LESS
  const GlFrame hidden = render_gl(scene, small_image());
  CHECK(hidden.warnings.empty());
  CHECK(hidden.samples_passed == 64 * 48);

  Scene away = ball(Phong{});
  away.objects[0].position = {0, 0, 1000};
  const GlFrame nothing = render_gl(away, small_image());
  CHECK(nothing.samples_passed == 0);
  CHECK(
      nothing.warnings ==
      Lines{"nothing is drawn: no sample of any object passes the depth test, with our shaders neither; all are out of "
            "view or face away"});
  CHECK(render_gl(ball(Phong{}), small_image()).warnings.empty());
}

TEST_CASE("asking why nothing is drawn leaves the image as it was") {
  // Nothing of the second one is seen, by its own fault; the first one must still be there.
  const FullWindow white("void main() { FragColor = vec4(1.0); }\n"), none("void main() { discard; }\n");
  Scene scene = white.scene;
  scene.objects.push_back(none.scene.objects[0]);
  scene.objects[1].name = "none";
  scene.camera.position = {0, 5, 0.1}; // so that ours would show it: a plane from above
  GlOptions options = small_image();
  options.want_rgb8 = true;
  const GlFrame frame = render_gl(scene, options);
  CHECK(std::all_of(frame.rgb8.values.begin(), frame.rgb8.values.end(), [](int value) { return value == 255; }));
  CHECK(frame.samples_passed == 64 * 48);
  CHECK(std::any_of(frame.warnings.begin(), frame.warnings.end(),
                    [](const std::string& line) { return line.starts_with("none: its shaders draw nothing"); }));
}

TEST_CASE("an error that OpenGL reports of a draw is bad input and names object and shaders; any other is no OpenGL") {
  static int calls_until_error = 0;
  static GLenum next_error = GL_NO_ERROR;
  static PFNGLDRAWELEMENTSPROC draw = nullptr;
  const GlContext context(GlRenderer::llvmpipe);
  GlApi gl = context.gl();
  draw = gl.DrawElements;
  gl.DrawElements = [](GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (--calls_until_error == 0) next_error = GL_INVALID_OPERATION;
    draw(mode, count, type, indices);
  };
  gl.GetError = []() { return std::exchange(next_error, GLenum{GL_NO_ERROR}); };

  const FullWindow window("void main() { FragColor = vec4(1.0); }\n");
  const GlOptions options = small_image();
  make_target(gl, GL_RGBA8, options);
  GlDrawing drawing(gl, window.scene, options);
  calls_until_error = 1;
  const std::string files = (window.folder / "vs.glsl") + " + " + (window.folder / "fs.glsl");
  CHECK_THROWS_WITH_AS(drawing.draw_checked(),
                       doctest::Contains((files + ": found GL_INVALID_OPERATION when quad is drawn with them").c_str()),
                       InputError);
  next_error = GL_OUT_OF_MEMORY;
  CHECK_THROWS_WITH_AS(GlDrawing(gl, window.scene, options),
                       doctest::Contains("OpenGL reports GL_OUT_OF_MEMORY while "), NoOpenGl);
}

TEST_CASE("a linker's log is taken apart, each message once") {
  CHECK(messages("warning: a\n.warning: a\n.warning: a\n.") == Lines{"a"});
  CHECK(messages("error: count > MAX(5 > 4)error: Too many\nerror: Too many\n") ==
        Lines{"count > MAX(5 > 4)", "Too many"});
  CHECK(messages("0:4(36): warning: `a' used\n0:5(36): warning: `a' used\n") == Lines{"`a' used", "`a' used"});
  CHECK(messages("0(12) : warning C7050: \"x\" might be used\n") == Lines{"warning C7050: \"x\" might be used"});
  CHECK(messages("\n.\n  \n").empty());
}

TEST_CASE("variables that choose a driver are found by name, and those that do not are not") {
  const char* const environment[] = {
      "HOME=/root",       "MESA_GL_VERSION_OVERRIDE=2.1",          "LIBGL_DEBUG=", "GALLIUM_DRIVER=zink", "XMESA_X=1",
      "EGL_PLATFORM=x11", "__EGL_VENDOR_LIBRARY_FILENAMES=a.json", nullptr};
  CHECK(driver_variables(environment, {}) == Lines{"EGL_PLATFORM=x11", "GALLIUM_DRIVER=zink",
                                                   "MESA_GL_VERSION_OVERRIDE=2.1",
                                                   "__EGL_VENDOR_LIBRARY_FILENAMES=a.json"});
  CHECK(driver_variables(environment, {"GALLIUM_DRIVER", "EGL_PLATFORM"}).size() == 2);
  CHECK(driver_variables(nullptr, {}).empty());
  CHECK(advice({}).find("Debian packages libegl1 and libgl1-mesa-dri") != std::string::npos);
  CHECK(advice({"A=1", "B=2"}) == "the environment chooses the driver: try again with these unset: A=1, B=2");
}

TEST_CASE("types have the names that GLSL gives them") {
  const std::pair<GLenum, const char*> names[] = {{GL_FLOAT, "float"},
                                                  {GL_BOOL_VEC3, "bvec3"},
                                                  {GL_FLOAT_MAT3, "mat3"},
                                                  {GL_FLOAT_MAT2x4, "mat2x4"},
                                                  {GL_DOUBLE_MAT4x3, "dmat4x3"},
                                                  {GL_SAMPLER_2D_ARRAY_SHADOW, "sampler2DArrayShadow"},
                                                  {GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "usampler2DMSArray"},
                                                  {GL_INT_IMAGE_2D_RECT, "iimage2DRect"},
                                                  {0x1234, "type 0x1234"}};
  for (const auto& [type, name] : names) CHECK(glsl_type(type).name == name);
  CHECK(declaration("a[0]", GL_FLOAT_VEC4, 8) == "vec4 a[8]");
  CHECK(declaration("a[0]", GL_FLOAT_VEC4, 1) == "vec4 a[1]");
  CHECK(declaration("a", GL_FLOAT_VEC4, 1) == "vec4 a");
}
