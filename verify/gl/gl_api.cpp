#include "verify/gl/gl_api.h"

namespace refraster {

const char* load(GlApi& gl, GlFunction (*get)(const char* name)) {
#define REFRASTER_GL_LOAD(TYPE, name)                                                                                  \
  gl.name = reinterpret_cast<PFNGL##TYPE##PROC>(get("gl" #name));                                                      \
  if (!gl.name) return "gl" #name;
  REFRASTER_GL_FUNCTIONS(REFRASTER_GL_LOAD)
#undef REFRASTER_GL_LOAD
  return nullptr;
}

} // namespace refraster
