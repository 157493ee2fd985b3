#include "gl/context/gl_api.h"

#include <string_view>

namespace refraster {
namespace {

bool has_extension(const GlApi& gl, std::string_view name) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
    if (reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))) == name) return true;
  return false;
}

} // namespace

const char* load(GlApi& gl, GlFunction (*get)(const char* name)) {
#define REFRASTER_GL_LOAD(TYPE, name)                                                                                  \
  gl.name = reinterpret_cast<PFNGL##TYPE##PROC>(get("gl" #name));                                                      \
  if (!gl.name) return "gl" #name;
  REFRASTER_GL_FUNCTIONS(REFRASTER_GL_LOAD)
#undef REFRASTER_GL_LOAD

  // A name alone proves nothing: Mesa gives a function for every name that it has heard of, which then is an error.
  GLint major = 0, minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  const int version = 10 * major + minor;
  const auto later = [&](auto& function, const char* name, int since, std::string_view extension) {
    if (version >= since || has_extension(gl, extension))
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(get(name));
  };
  later(gl.GetInternalformativ, "glGetInternalformativ", 42, "GL_ARB_internalformat_query");
  later(gl.GetProgramInterfaceiv, "glGetProgramInterfaceiv", 43, "GL_ARB_program_interface_query");
  later(gl.GetProgramResourceName, "glGetProgramResourceName", 43, "GL_ARB_program_interface_query");
  later(gl.GetProgramResourceiv, "glGetProgramResourceiv", 43, "GL_ARB_program_interface_query");
  later(gl.GetProgramStageiv, "glGetProgramStageiv", 40, "GL_ARB_shader_subroutine");
  later(gl.UniformSubroutinesuiv, "glUniformSubroutinesuiv", 40, "GL_ARB_shader_subroutine");
  later(gl.VertexAttribL4d, "glVertexAttribL4d", 41, "GL_ARB_vertex_attrib_64bit");
  return nullptr;
}

} // namespace refraster
