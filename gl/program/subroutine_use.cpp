#include "gl/program/introspection.h"
#include "gl/program/program_use.h"

#include <algorithm>

namespace refraster {

SubroutineUse subroutine_use(const GlApi& gl, GLuint program, std::vector<std::string>& warnings) {
  if (!gl.UniformSubroutinesuiv || !gl.GetProgramStageiv) return {};
  const auto of_stage = [&](GLenum stage, GLenum uniforms, GLenum functions) {
    GLint places = 0;
    gl.GetProgramStageiv(program, stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, &places);
    std::vector<GLuint> calls(static_cast<std::size_t>(places));
    const std::vector<ProgramResource> names = resources(gl, program, functions, {});
    for (const ProgramResource& uniform :
         resources(gl, program, uniforms, {GL_LOCATION, GL_ARRAY_SIZE, GL_COMPATIBLE_SUBROUTINES})) {
      const auto call = static_cast<GLuint>(uniform.values[2]);
      for (GLint i = 0; i < std::max(uniform.values[1], 1) && uniform.values[0] + i < places; ++i)
        calls[static_cast<std::size_t>(uniform.values[0] + i)] = call;
      warnings.push_back("subroutine uniform " + array_name(uniform.name) +
                         " is not one that refraster sets: it calls " +
                         (call < names.size() ? names[call].name : "the first that fits"));
    }
    return calls;
  };
  SubroutineUse use;
  use.vertex = of_stage(GL_VERTEX_SHADER, GL_VERTEX_SUBROUTINE_UNIFORM, GL_VERTEX_SUBROUTINE);
  use.fragment = of_stage(GL_FRAGMENT_SHADER, GL_FRAGMENT_SUBROUTINE_UNIFORM, GL_FRAGMENT_SUBROUTINE);
  return use;
}

} // namespace refraster
