#include "gl/program/introspection.h"
#include "gl/program/program_use.h"

#include <algorithm>

namespace refraster {
namespace {

constexpr const char* channels[] = {"red", "green", "blue"};

/// The words of a list that a condition holds for: "green and blue".
template <class Condition>
std::string channels_where(Condition&& condition) {
  std::string list;
  for (std::size_t i = 0; i < 3; ++i)
    if (condition(i)) list += (list.empty() ? "" : " and ") + std::string(channels[i]);
  return list;
}

} // namespace

ColourMask colour_mask(const GlApi& gl, GLuint program, std::vector<std::string>& warnings) {
  if (!gl.GetProgramInterfaceiv) return {GL_TRUE, GL_TRUE, GL_TRUE};
  ColourMask mask{};
  bool stated = false; // why there is no colour
  for (const ProgramResource& output :
       resources(gl, program, GL_PROGRAM_OUTPUT, {GL_TYPE, GL_LOCATION, GL_LOCATION_INDEX, GL_ARRAY_SIZE})) {
    const auto type_enum = static_cast<GLenum>(output.values[0]);
    const GLint location = output.values[1], index = output.values[2], size = output.values[3];
    const GlslType& type = glsl_type(type_enum);
    // Built in, of older GLSL; drivers give them location 0 or none.
    if (output.name == "gl_FragColor" || output.name.starts_with("gl_FragData")) return {GL_TRUE, GL_TRUE, GL_TRUE};
    if (output.name.starts_with("gl_") || location < 0) continue; // depth, sample mask
    const std::string what = declaration(output.name, type_enum, size);
    if (location > 0) {
      warnings.push_back("output " + what + " at location " + std::to_string(location) +
                         " goes nowhere: the image is what location 0 is given");
    } else if (index > 0) {
      warnings.push_back("output " + what + " at index " + std::to_string(index) +
                         " goes nowhere: it is a second colour for blending, and nothing is blended");
    } else if (type.base != GlslBase::float_) {
      warnings.push_back("output " + output.name + ": found " + type.name + ", expected vec4: no colour is written");
      stated = true;
    } else {
      if (size > 1)
        warnings.push_back("output " + what +
                           ": its elements from 1 on go nowhere: the image is what location 0 is given");
      // Several outputs may share a location, each with some of its components: GLSL 4.40, 4.4.2.
      GLint component = 0;
      for (const ProgramResource& place : resources(gl, program, GL_PROGRAM_OUTPUT, {GL_LOCATION_COMPONENT}))
        if (place.name == output.name) component = place.values[0];
      for (int i = component; i < std::min(component + type.components, 3); ++i)
        mask[static_cast<std::size_t>(i)] = GL_TRUE;
    }
  }
  const std::string missing = channels_where([&](std::size_t i) { return mask[i] == GL_FALSE; });
  if (mask == ColourMask{}) {
    if (!stated)
      warnings.push_back("the fragment shader writes no colour: it has no output at location 0 that it writes to");
  } else if (!missing.empty()) {
    warnings.push_back("the output at location 0 has no " + missing + ": nothing is written there, expected vec4");
  }
  return mask;
}

} // namespace refraster
