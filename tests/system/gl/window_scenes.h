#pragma once
// Scenes whose corners are placed by where they are seen, and shaders of a few lines, for what OpenGL makes of a
// window.

#include <refraster/scene.h>

#include "gl/render_gl.h"
#include "tests/support/program/program.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace refraster {

/// Triangles that shine in `colour` whatever the light, three corners each; every normal is (0, 0, 1).
inline Object shining(const std::vector<Float3>& corners, const Double3& colour = Double3(1)) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = corners;
  mesh->normals.assign(corners.size(), Float3(0, 0, 1));
  for (std::uint32_t i = 0; i < corners.size(); i += 3) mesh->triangles.push_back({i, i + 1, i + 2});
  Phong phong;
  phong.ka = colour, phong.kd = phong.ks = Double3(0);
  Object object;
  object.mesh = mesh;
  object.material.fragment_function = phong;
  return object;
}

/// A camera at the origin that looks along -z with 90 degrees from bottom to top. Its cotangent is exactly 1, so that
/// (x, y, -1) is seen at normalized device coordinates (x / aspect, y).
inline Scene scene_before_the_eye() {
  Scene scene;
  scene.camera.fov_y_degrees = 90;
  scene.camera.near = 0.25, scene.camera.far = 8;
  return scene;
}

/// A rectangle as two triangles, counter-clockwise where x0 < x1 and y0 < y1.
inline std::vector<Float3> rectangle(float x0, float y0, float x1, float y1, float z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

struct WindowSize {
  int width, height;
};

/// What OpenGL draws of a scene whose objects all have this vertex and this fragment shader, or ours where one is "".
/// Every image is read back.
inline GlFrame drawn_with(Scene scene, const std::string& vertex, const std::string& fragment, WindowSize size,
                          GlRenderer renderer) {
  const TemporaryFolder folder;
  save_text(folder / "vs.glsl", vertex);
  save_text(folder / "fs.glsl", fragment);
  for (Object& object : scene.objects) {
    if (!vertex.empty()) object.vertex_shader_path = folder / "vs.glsl";
    if (!fragment.empty()) object.fragment_shader_path = folder / "fs.glsl";
  }
  GlOptions options;
  options.width = size.width, options.height = size.height;
  options.renderer = renderer;
  options.want_radiance = options.want_depth = options.want_ids = true;
  return render_gl(scene, options);
}

/// Object space is clip space.
inline const std::string clip_space_vertex_shader = "#version 330 core\n"
                                                    "layout(location = 0) in vec3 vPos;\n"
                                                    "out vec2 ndc;\n"
                                                    "void main() { ndc = vPos.xy; gl_Position = vec4(vPos, 1.0); }\n";

/// A fragment shader that writes this expression, of `ndc` too.
inline std::string writing(const std::string& expression) {
  return "#version 330 core\n"
         "in vec2 ndc;\n"
         "out vec4 FragColor;\n"
         "void main() { FragColor = vec4(" +
         expression + ", 1.0); }\n";
}

inline constexpr GlRenderer software_renderers[] = {GlRenderer::llvmpipe, GlRenderer::softpipe};

/// Odd and even, with one row, with one column, and with both.
inline constexpr WindowSize window_sizes[] = {{16, 8}, {17, 9}, {16, 9}, {17, 8}, {33, 1}, {1, 33}, {2, 1}, {1, 1}};

} // namespace refraster
