// OpenGL's window has y up, as an application has it: what shaders are given of it, and which way up the images are.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "tests/support/gl/device_images.h"
#include "tests/system/gl/window_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace refraster;

namespace {

Scene of(Object object) {
  Scene scene = scene_before_the_eye();
  scene.objects = {std::move(object)};
  return scene;
}

/// All of the window, in clip space; depth rises from 0 at the bottom to 1 at the top.
Scene whole_window() {
  std::vector<Float3> corners = rectangle(-1, -1, 1, 1, 0);
  for (Float3& corner : corners) corner.z = corner.y;
  return of(shining(corners));
}

/// The value of the pixel at window (x, y), y counted from the bottom: row 0 of an image is the top one.
template <class Value>
const Value* at_window(const Image<Value>& image, int x, int y) {
  return image.at(x, image.height - 1 - y);
}

/// The numbers of the objects that render() shows.
Image<float> objects_here(const Scene& scene, WindowSize size) {
  RenderOptions options;
  options.width = size.width, options.height = size.height;
  options.aovs = {Aov::object};
  return std::move(render(scene, options).aovs[0]);
}

template <class Visit>
void for_renderers_and_sizes(Visit&& visit) {
  for (const GlRenderer renderer : software_renderers)
    for (const WindowSize size : window_sizes) {
      CAPTURE(name_of(renderer));
      CAPTURE(size.width);
      CAPTURE(size.height);
      visit(renderer, size);
    }
}

} // namespace

TEST_CASE("gl_FragCoord is (0.5, 0.5) in the lower left pixel, and the first row of an image is the top one") {
  for_renderers_and_sizes([](GlRenderer renderer, WindowSize size) {
    // In 8 bits too: 255 times the colour is x and y, counted from 0.
    const GlFrame coloured = drawn_with(whole_window(), clip_space_vertex_shader,
                                        writing("(gl_FragCoord.xy - 0.5) / 255.0, 0.0"), size, renderer);
    const GlFrame frame =
        drawn_with(whole_window(), clip_space_vertex_shader, writing("gl_FragCoord.xyz"), size, renderer);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        REQUIRE(at_window(frame.radiance, x, y)[0] == static_cast<float>(x) + 0.5f);
        REQUIRE(at_window(frame.radiance, x, y)[1] == static_cast<float>(y) + 0.5f);
        REQUIRE(at_window(coloured.rgb8, x, y)[0] == x);
        REQUIRE(at_window(coloured.rgb8, x, y)[1] == y);
        // A plane from 0 to 1, from corners in clip space that are exact: a few roundings of numbers up to 1.
        const double depth = (y + 0.5) / size.height;
        REQUIRE(std::abs(static_cast<double>(*at_window(frame.depth, x, y)) - depth) <= 8 * float_rounding);
        REQUIRE(std::abs(static_cast<double>(at_window(frame.radiance, x, y)[2]) - depth) <= 8 * float_rounding);
      }
  });
}

TEST_CASE("ids are the right way up") {
  Scene scene = of(shining(rectangle(-1, -1, 1, 0.25f, 0)));           // the lower five eighths
  scene.objects.push_back(shining(rectangle(-1, 0.25f, 0.25f, 1, 0))); // above, the left five eighths
  for (const GlRenderer renderer : software_renderers)
    for (const WindowSize size : {WindowSize{16, 8}, WindowSize{17, 9}, WindowSize{1, 3}, WindowSize{3, 1}}) {
      const GlFrame frame = drawn_with(scene, clip_space_vertex_shader, writing("vec3(1.0)"), size, renderer);
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
          const bool lower = y + 0.5 < 0.625 * size.height, left = x + 0.5 < 0.625 * size.width;
          CAPTURE(x);
          CAPTURE(y);
          CHECK(at_window(frame.ids, x, y)[0] == (lower ? 1.0f : left ? 2.0f : 0.0f));
        }
    }
}

TEST_CASE("dFdx and dFdy of a linear function are its slopes along x and along y, upward") {
  for_renderers_and_sizes([](GlRenderer renderer, WindowSize size) {
    const GlFrame across = drawn_with(whole_window(), clip_space_vertex_shader,
                                      writing("dFdx(ndc), dFdx(gl_FragCoord.x)"), size, renderer);
    const GlFrame upward = drawn_with(whole_window(), clip_space_vertex_shader,
                                      writing("dFdy(ndc), dFdy(gl_FragCoord.y)"), size, renderer);
    // Differences of two numbers up to 2 beside the window's border, each from a plane of three terms.
    constexpr double rounding = 2 * 2 * 6 * float_rounding;
    const auto apart = [](float value, double expected) { return std::abs(static_cast<double>(value) - expected); };
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const float *const dx = at_window(across.radiance, x, y), *const dy = at_window(upward.radiance, x, y);
        REQUIRE(apart(dx[0], 2.0 / size.width) <= rounding);
        REQUIRE(apart(dx[1], 0) <= rounding);
        REQUIRE(dx[2] == 1);
        REQUIRE(apart(dy[0], 0) <= rounding);
        REQUIRE(apart(dy[1], 2.0 / size.height) <= rounding);
        REQUIRE(dy[2] == 1);
      }
  });
}

TEST_CASE("derivatives are differences within blocks of two by two pixels, the first of which is at the lower left") {
  // The square's difference between rows r and r + 1 is (r + 1.5)^2 - (r + 0.5)^2 = 2 r + 2.
  for_renderers_and_sizes([](GlRenderer renderer, WindowSize size) {
    const GlFrame frame = drawn_with(
        whole_window(), clip_space_vertex_shader,
        writing("dFdx(gl_FragCoord.x * gl_FragCoord.x), dFdy(gl_FragCoord.y * gl_FragCoord.y), 0.0"), size, renderer);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        REQUIRE(at_window(frame.radiance, x, y)[0] == static_cast<float>(2 * (x & ~1) + 2));
        REQUIRE(at_window(frame.radiance, x, y)[1] == static_cast<float>(2 * (y & ~1) + 2));
      }
  });
}

TEST_CASE("the cross product of a position's derivatives is the normal of a face that is seen") {
  const std::string fragment = "#version 330 core\n"
                               "in VS_OUT { vec3 FragPos; vec3 Normal; vec2 TexCoord; } fs_in;\n"
                               "out vec4 FragColor;\n"
                               "void main() {\n"
                               "    vec3 n = normalize(cross(dFdx(fs_in.FragPos), dFdy(fs_in.FragPos)));\n"
                               "    FragColor = vec4(dot(n, normalize(fs_in.Normal)), 1.0, 0.0, 1.0);\n"
                               "}\n";
  Object cube;
  cube.mesh = std::make_shared<const Mesh>(cube_mesh());
  cube.position = {0.3, -0.2, -4};
  cube.material.fragment_function = Phong{};
  for (const GlRenderer renderer : software_renderers)
    for (const Double3 angles : {Double3(0), Double3(30, 40, 0), Double3(-35, 200, 77)})
      for (const Double3 scale : {Double3(1), Double3(1.5, 0.7, 1), Double3(-1, 1, 1)}) {
        cube.rotate_degrees = angles;
        cube.scale = scale;
        const GlFrame frame = drawn_with(of(cube), "", fragment, {48, 47}, renderer);
        int seen = 0;
        for (int y = 0; y < 47; ++y)
          for (int x = 0; x < 48; ++x) {
            const float* const pixel = frame.radiance.at(x, y);
            if (pixel[1] == 0) continue;
            ++seen;
            // Positions up to 6 differ by a tenth from pixel to pixel, with an error below 6 * 2^-20: the normal turns
            // by less than a thousandth. The wrong sign of either derivative would turn it round.
            REQUIRE(pixel[0] > 0.999f);
          }
        CHECK(seen > 100);
      }
}

TEST_CASE("a position that is rebuilt from gl_FragCoord and the matrices is the one that was interpolated") {
  const std::string vertex = text_of(std::string(REFRASTER_SOURCE_DIR) + "/scenes/lecture/shader/vertex.glsl");
  const std::string fragment =
      "#version 330 core\n"
      "layout (std140) uniform Matrices { mat4 view; mat4 projection; };\n"
      "in VS_OUT { vec3 FragPos; vec3 Normal; vec2 TexCoord; } fs_in;\n"
      "out vec4 FragColor;\n"
      "void main() {\n"
      "    vec3 ndc = 2.0 * gl_FragCoord.xyz / vec3(48.0, 47.0, 1.0) - 1.0;\n"
      "    vec4 rebuilt = inverse(projection * view) * vec4(ndc, 1.0);\n"
      "    FragColor = vec4(distance(rebuilt.xyz / rebuilt.w, fs_in.FragPos), 1.0, 0.0, 1.0);\n"
      "}\n";
  Object cube;
  cube.mesh = std::make_shared<const Mesh>(cube_mesh());
  cube.position = {0.3, -0.8, -4};
  cube.rotate_degrees = {30, 40, 0};
  cube.material.fragment_function = Phong{};
  for (const GlRenderer renderer : software_renderers) {
    const GlFrame frame = drawn_with(of(cube), vertex, fragment, {48, 47}, renderer);
    double farthest = 0;
    for (std::size_t i = 0; i < frame.radiance.values.size(); i += 3)
      farthest = std::max(farthest, static_cast<double>(frame.radiance.values[i]));
    CHECK(*std::max_element(frame.radiance.values.begin(), frame.radiance.values.end()) >= 1); // the cube is seen
    // A distance w up to 6 changes by w^2 / near = 144 for a change of 1 in depth, which is good to 2^-20; a pixel is a
    // tenth wide, and one in a row on the wrong side of the middle would be some off.
    CHECK(farthest < 1e-3);
  }
}

TEST_CASE("a face is front where it runs counter-clockwise in the image, and only back faces are culled") {
  // To the left one that runs counter-clockwise, to the right one that runs clockwise. No centre lies on an edge.
  const std::vector<Float3> left = {{-0.83f, -0.71f, -1}, {-0.11f, -0.71f, -1}, {-0.83f, 0.63f, -1}},
                            right = {{0.11f, -0.71f, -1}, {0.83f, 0.63f, -1}, {0.83f, -0.71f, -1}};
  const std::string fragment = "#version 330 core\n"
                               "out vec4 FragColor;\n"
                               "void main() { FragColor = vec4(gl_FrontFacing ? 1.0 : 0.5, 0.0, 0.0, 1.0); }\n";
  constexpr WindowSize size = {40, 40};
  for (const GlRenderer renderer : software_renderers)
    for (const Cull cull : {Cull::none, Cull::back})
      for (const double mirror : {1.0, -1.0}) {
        CAPTURE(name_of(renderer));
        CAPTURE(name_of(cull));
        CAPTURE(mirror);
        Scene scene = scene_before_the_eye();
        scene.objects = {shining(left), shining(right)};
        for (Object& object : scene.objects) object.cull = cull, object.scale.x = mirror;
        const GlFrame frame = drawn_with(scene, "", fragment, size, renderer);
        const Image<float> here = objects_here(scene, size);
        // Mirrored, they change sides, and their faces turn round.
        const float seen_left = *frame.radiance.at(8, 28), seen_right = *frame.radiance.at(31, 28);
        CHECK(seen_left == 1);
        CHECK(seen_right == (cull == Cull::back ? 0 : 0.5f));
        CHECK(*here.at(8, 28) == (mirror > 0 ? 1 : 2));
        std::uint64_t drawn = 0;
        for (int y = 0; y < size.height; ++y)
          for (int x = 0; x < size.width; ++x) {
            CHECK(frame.ids.at(x, y)[0] == *here.at(x, y));
            drawn += *here.at(x, y) != 0;
          }
        CHECK(frame.samples_passed == drawn);
      }
}

TEST_CASE("from inside a closed body all faces are back, and culling leaves nothing") {
  Object cube;
  cube.mesh = std::make_shared<const Mesh>(cube_mesh());
  cube.rotate_degrees = {20, 30, 40};
  cube.material.fragment_function = Phong{};
  const std::string fragment = "#version 330 core\n"
                               "out vec4 FragColor;\n"
                               "void main() { FragColor = vec4(gl_FrontFacing ? 1.0 : 0.5, 0.0, 0.0, 1.0); }\n";
  const GlFrame all = drawn_with(of(cube), "", fragment, {9, 7}, GlRenderer::llvmpipe);
  for (std::size_t i = 0; i < all.radiance.values.size(); i += 3) CHECK(all.radiance.values[i] == 0.5f);
  cube.cull = Cull::back;
  CHECK(drawn_with(of(cube), "", fragment, {9, 7}, GlRenderer::llvmpipe).samples_passed == 0);
}

TEST_CASE("a texture is seen the way up that its file has") {
  // Row 0 is the bottom one: red and green below, blue and white above.
  Texture texture;
  texture.levels.push_back({2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}});
  Object plane;
  plane.mesh = std::make_shared<const Mesh>(plane_mesh(1)); // v runs along -z: turned upright, along y
  plane.rotate_degrees = {90, 0, 0};
  plane.position = {0, 0, -1};
  plane.material = shining({}).material;
  plane.material.diffuse_map.texture = std::make_shared<const Texture>(texture);
  plane.material.diffuse_map.filter = TextureFilter::nearest;
  const std::string lecture = std::string(REFRASTER_SOURCE_DIR) + "/scenes/lecture/shader/";
  const std::string shaders[][2] = {{"", ""}, {text_of(lecture + "vertex.glsl"), text_of(lecture + "phong_fs.glsl")}};
  for (const GlRenderer renderer : software_renderers)
    for (const auto& [vertex, fragment] : shaders)
      for (const WindowSize size : {WindowSize{8, 8}, WindowSize{9, 9}}) {
        const GlFrame frame = drawn_with(of(plane), vertex, fragment, size, renderer);
        const auto colour = [&](int x, int y) {
          const std::uint8_t* const level = frame.rgb8.at(x, y);
          return std::array<int, 3>{level[0], level[1], level[2]};
        };
        CHECK(colour(1, 1) == std::array<int, 3>{0, 0, 255});
        CHECK(colour(6, 1) == std::array<int, 3>{255, 255, 255});
        CHECK(colour(1, 6) == std::array<int, 3>{255, 0, 0});
        CHECK(colour(6, 6) == std::array<int, 3>{0, 255, 0});
      }
}
