// GLSL that a scene brings along.

#include <refraster/compare.h>
#include <refraster/notes.h>

#include "gl/glsl/own_glsl.h"
#include "gl/program/program.h"
#include "gl/render_gl.h"
#include "scenes/synthesis/merl_synthesis.h"
#include "tests/support/program/program.h"
#include "tests/system/gl/small_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <locale>

using namespace refraster;

namespace {

const std::string lecture = std::string(REFRASTER_SOURCE_DIR) + "/scenes/lecture/shader/";

GlFrame through_gl(const Scene& scene) {
  GlOptions options;
  options.width = 160;
  options.height = 120;
  options.renderer = GlRenderer::llvmpipe;
  options.want_radiance = true;
  return render_gl(scene, options);
}

/// A scene whose fragment shader is this text, drawn; the file is gone afterwards.
GlFrame with_fragment_shader(Scene scene, const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder / "custom_fs.glsl";
  save_text(path, text);
  scene.objects[0].fragment_shader_path = path;
  return through_gl(scene);
}

double largest_difference(const GlFrame& a, const GlFrame& b) {
  return compare(a.radiance, b.radiance, CompareUnit::values, {}).max;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

bool any_holds(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("the lecture's shaders and ours give the same image") {
  Scene scene = ball(Phong{});
  const GlFrame ours = through_gl(scene);
  scene.objects[0].vertex_shader_path = lecture + "vertex.glsl";
  scene.objects[0].fragment_shader_path = lecture + "phong_fs.glsl";
  const GlFrame theirs = through_gl(scene);
  CHECK(theirs.warnings.empty());
  CHECK(any_holds(theirs.shaders, "phong_fs.glsl"));
  // Matrices multiplied in float a vertex instead of in double an object: a few roundings of 2^-24 in a position, which
  // the silhouette's slope and the highlight's exponent of 8 turn into no more than 2^-24 times some hundred.
  CHECK(largest_difference(ours, theirs) < 1e-4);
}

TEST_CASE("either shader may be the scene's, the other one is ours") {
  Scene scene = ball(Phong{});
  const GlFrame ours = through_gl(scene);
  for (const bool vertex : {true, false}) {
    Scene mixed = scene;
    (vertex ? mixed.objects[0].vertex_shader_path : mixed.objects[0].fragment_shader_path) =
        lecture + (vertex ? "vertex.glsl" : "phong_fs.glsl");
    const GlFrame frame = through_gl(mixed);
    CHECK(largest_difference(ours, frame) < 1e-4);
    CHECK(any_holds(frame.shaders, "ours (the scene names none)"));
  }
}

TEST_CASE("a shader that is named and not there is replaced by ours, and the line says so") {
  Scene scene = ball(Phong{});
  scene.objects[0].fragment_shader_path = "nowhere/phong_fs.glsl";
  const GlFrame frame = through_gl(scene);
  REQUIRE(frame.shaders.size() == 1);
  CHECK(frame.shaders[0] ==
        "ball: vertex shader ours (the scene names none), fragment shader of phong ours (there is no "
        "nowhere/phong_fs.glsl)");
}

TEST_CASE("a uniform that a shader declares and nobody sets is a warning with its name and type") {
  const std::string text =
      replaced(text_of(lecture + "phong_fs.glsl"), "uniform vec3 ka;", "uniform vec4 tint;\nuniform vec3 ka;");
  const GlFrame frame = with_fragment_shader(ball(Phong{}), replaced(text, "vec4(sum, 1.0)", "vec4(sum, 1.0) + tint"));
  REQUIRE(frame.warnings.size() == 1);
  CHECK(frame.warnings[0] == "ball: uniform vec4 tint is not one that refraster sets: it stays 0");
}

TEST_CASE("a uniform of another type than it should be is a warning, and is not set") {
  const std::string text =
      replaced(text_of(lecture + "phong_fs.glsl"), "uniform float glossiness;", "uniform int glossiness;");
  const GlFrame frame = with_fragment_shader(ball(Phong{}), replaced(text, "glossiness == 0.0", "glossiness == 0"));
  REQUIRE(frame.warnings.size() == 1);
  CHECK(frame.warnings[0] == "ball: uniform glossiness: found int, expected float: it stays 0");
}

TEST_CASE("a shader that needs none of the uniforms is drawn without a warning") {
  const GlFrame frame =
      with_fragment_shader(ball(Phong{}), "#version 330 core\n"
                                          "in VS_OUT { vec3 FragPos; vec3 Normal; vec2 TexCoord; } fs_in;\n"
                                          "out vec4 FragColor;\n"
                                          "void main() { FragColor = vec4(fs_in.TexCoord, 0.25, 1.0); }\n");
  CHECK(frame.warnings.empty());
  CHECK(frame.radiance.at(80, 60)[2] == 0.25f);
}

TEST_CASE("a shader for a newer GLSL than the driver has is tried with the driver's, and a line says so") {
  const std::string body = "out vec4 FragColor;\nvoid main() { FragColor = vec4(0.25, 0.5, 0.75, 1.0); }\n";
  const auto said = [&](const std::string& first_lines) {
    const GlFrame frame = with_fragment_shader(ball(Phong{}), first_lines + body);
    std::string text;
    for (const std::string& line : frame.shaders) text += line + "\n";
    return text;
  };
  for (const char* const line : {"#version 990 core\n", " \t# version\t 990\n", "// a comment\n#version 990\r\n"}) {
    CAPTURE(line);
    CHECK(said(line).find(" (#version 990 taken as ") != std::string::npos);
  }
  for (const char* const line : {"#version 330 core\n", "// #version 990\n#version 330\n"}) {
    CAPTURE(line);
    CHECK(said(line).find(" taken as ") == std::string::npos);
  }
}

TEST_CASE("an array of lights that is too short is a warning, and no light is read beyond its end") {
  Scene scene = ball(Phong{});
  const GlFrame two_lights_of_three = [&] {
    Scene fewer = scene;
    fewer.point_lights = {scene.point_lights[0], scene.point_lights[0]};
    return through_gl(fewer);
  }();
  scene.point_lights = {scene.point_lights[0], scene.point_lights[0], scene.point_lights[0]};
  const GlFrame frame = with_fragment_shader(
      scene, replaced(text_of(lecture + "phong_fs.glsl"), "#define MAX_LIGHTS 64", "#define MAX_LIGHTS 2"));
  REQUIRE(frame.warnings.size() == 1);
  CHECK(frame.warnings[0] == "ball: pointLights has room for 2 of the scene's 3 point lights: the others are left out");
  CHECK(largest_difference(two_lights_of_three, frame) < 1e-4);
}

TEST_CASE("an error in GLSL is reported with file, line and column") {
  const TemporaryFolder folder;
  const std::string path = folder / "broken_fs.glsl";
  save_text(path, "#version 330 core\nout vec4 FragColor;\nvoid main() {\n    FragColor = vec4(1.0)\n}\n");
  Scene scene = ball(Phong{});
  scene.objects[0].fragment_shader_path = path;
  try {
    through_gl(scene);
    FAIL("compiled");
  } catch (const InputError& error) {
    REQUIRE(!error.faults().empty());
    CHECK(error.faults()[0].file == path);
    CHECK(error.faults()[0].line == 5);
    CHECK(error.faults()[0].column == 1);
    CHECK(std::string(error.what()).find("syntax error") != std::string::npos);
  }
}

TEST_CASE("the logs of other compilers are understood") {
  const auto place = [](const std::string& line) {
    const LogLine parsed = parse_log_line(line);
    return std::tuple(parsed.line, parsed.column, parsed.message);
  };
  CHECK(place("0:12(5): error: syntax error") == std::tuple(12, 5, "syntax error"));
  CHECK(place("0(7) : error C0000: syntax error") == std::tuple(7, 0, "error C0000: syntax error"));
  CHECK(place("ERROR: 0:31: 'x' : undeclared identifier") == std::tuple(31, 0, "'x' : undeclared identifier"));
  CHECK(place("internal error") == std::tuple(0, 0, "internal error"));
}

TEST_CASE("shaders that do not fit each other are reported with both names") {
  const TemporaryFolder folder;
  const std::string path = folder / "other_fs.glsl";
  save_text(path,
            "#version 330 core\nin VS_OUT { vec3 FragPos; vec2 Normal; vec2 TexCoord; } fs_in;\nout vec4 FragColor;\n"
            "void main() { FragColor = vec4(fs_in.Normal, 0.0, 1.0); }\n");
  Scene scene = ball(Phong{});
  scene.objects[0].fragment_shader_path = path;
  CHECK_THROWS_WITH_AS(through_gl(scene), doctest::Contains(("our vertex shader + " + path).c_str()), InputError);
}

TEST_CASE("our GLSL does not depend on the locale") {
  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
  };
  Scene scene = ball(Merl{});
  scene.point_lights.resize(12);
  const auto text = [&] {
    return own_fragment_glsl(scene, *scene.objects[0].mesh, scene.objects[0].material, TwoSided::no, MerlFilter::manual,
                             GlslDialect::core_330);
  };
  const std::string before = text();
  const std::locale usual = std::locale::global(std::locale(std::locale::classic(), new Commas));
  const std::string with_commas = text();
  std::locale::global(usual);
  CHECK(before == with_commas);
}

TEST_CASE("our GLSL knows every type of light, texture slot and vertex attribute") {
  const Scene none;
  for_each_light_list(none, []<class Light>(const std::vector<Light>&) {
    CHECK_MESSAGE(has_own_glsl(Light::names), "gl/glsl/surface.glsl has no arriving() of " << Light::names.words);
  });
  for (const TextureSlot& slot : texture_slots)
    CHECK_MESSAGE(has_own_glsl(slot), "gl/glsl/phong.glsl does not read the sampler " << slot.sampler);
  for_each_vertex_attribute([](const auto& attribute) {
    CHECK_MESSAGE(has_own_glsl(attribute.varying), "no file of gl/glsl reads fs_in(" << attribute.varying << ")");
  });
}

TEST_CASE("an entry of a declared list without GLSL of ours is not left out silently") {
  CHECK_FALSE(has_own_glsl(LightNames{"laser_lights", "laser lights", "laserLights"}));
  CHECK_FALSE(has_own_glsl(TextureSlot{.sampler = "furTex"}));
  CHECK_FALSE(has_own_glsl("Fur"));
  CHECK(without_glsl(ball(Phong{}), ball(Phong{}).objects[0]).empty());
}

TEST_CASE("our GLSL compiles for every fragment function, lookup, angle method and filter") {
  const std::shared_ptr<const MerlTable> table(new MerlTable(merl_table_from(Lambert{})));
  for (const auto& lookup : EnumNames<MerlLookup>::names)
    for (const auto& angles : EnumNames<MerlAngles>::names)
      for (const auto& filter : EnumNames<MerlFilter>::names) {
        Merl function;
        function.table = table;
        function.lookup = lookup.first;
        function.angles = angles.first;
        GlOptions options;
        options.width = options.height = 32;
        options.renderer = GlRenderer::llvmpipe;
        options.merl_filter = filter.first;
        options.want_radiance = true;
        Scene scene = ball(function);
        scene.direction_lights.clear();
        const GlFrame frame = render_gl(scene, options);
        INFO(name_of(function.lookup) << ", " << name_of(function.angles) << ", " << name_of(options.merl_filter));
        CHECK(frame.warnings.empty());
        CHECK(frame.radiance.at(14, 14)[0] > 0.05f); // lit
      }
}
