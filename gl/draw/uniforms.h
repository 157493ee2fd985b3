#pragma once
// What a shader is given by name: docs/glsl-interface.md.

#include "gl/context/gl_api.h"
#include "gl/draw/dummy_textures.h"
#include "raster/shadow/map/light_view.h"
#include "raster/vertex/transform.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace refraster {

using Float3x3 = glm::mat3;
using Float4x4 = glm::mat4;
using UniformValue = std::variant<float, int, Float2, Float3, Float4, Float3x3, Float4x4>;
using UniformValues = std::map<std::string, UniformValue>;

/// The texture units that samplers are set to: those of texture_slots in their order, then these.
inline constexpr int merl_unit = static_cast<int>(texture_slots.size()), shadow_unit = merl_unit + 1,
                     compared_shadow_unit = merl_unit + 2, first_dummy_unit = merl_unit + 3;

/// The std140 block Matrices.
struct MatricesBlock {
  Float4x4 view, projection;
};

/// The camera's matrices, as an application would pass them: y is up in clip space.
MatricesBlock matrices_block(const Camera& camera, double aspect);

/// "pointLightCount".
std::string count_uniform(const LightNames& names);

/// For every object alike: the camera's position and the lights; `views`: light_views() of the scene.
UniformValues scene_uniforms(const Scene& scene, std::span<const LightView> views);

/// For one object: its matrices and its material.
UniformValues object_uniforms(const Object& object, const Double4x4& clip_from_world);

/// A value with a place in a program.
struct UniformSetting {
  GLint location;
  UniformValue value;
};

/// What to set of `values` before each draw. A uniform that the program lacks is left out. A warning is appended for
/// one that it declares and nobody sets, for one of another type, and for an array of lights that is too short; the
/// count of lights is then cut to its length. Samplers that nobody sets are set here, once and for all, to units of
/// `dummies`. `function` names the fragment function that `values` are of.
std::vector<UniformSetting> settings(const GlApi& gl, GLuint program, const UniformValues& values,
                                     std::string_view function, DummyTextures& dummies,
                                     std::vector<std::string>& warnings);

/// For the program in use.
void set_uniform(const GlApi& gl, const UniformSetting& setting);

} // namespace refraster
