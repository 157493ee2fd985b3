#include "gl/context/context.h"

#include "gl/context/driver.h"
#include "gl/context/driver_environment.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <iterator>
#include <sstream>
#include <string_view>
#include <unistd.h>

namespace refraster {
namespace {

#define REFRASTER_EGL_FUNCTIONS(F)                                                                                     \
  F(BINDAPI, BindAPI)                                                                                                  \
  F(CHOOSECONFIG, ChooseConfig)                                                                                        \
  F(CREATECONTEXT, CreateContext)                                                                                      \
  F(DESTROYCONTEXT, DestroyContext)                                                                                    \
  F(GETPROCADDRESS, GetProcAddress)                                                                                    \
  F(INITIALIZE, Initialize)                                                                                            \
  F(MAKECURRENT, MakeCurrent)                                                                                          \
  F(QUERYSTRING, QueryString)                                                                                          \
  F(TERMINATE, Terminate)

struct EglApi {
#define REFRASTER_EGL_MEMBER(TYPE, name) PFNEGL##TYPE##PROC name = nullptr;
  REFRASTER_EGL_FUNCTIONS(REFRASTER_EGL_MEMBER)
#undef REFRASTER_EGL_MEMBER
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;
  // Null without EGL_EXT_device_enumeration and EGL_EXT_device_query.
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString = nullptr;
};

const std::string what_to_install = advice({});

EglApi load_egl() {
  // Never closed: drivers leave threads and exit handlers behind.
  void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) throw NoOpenGl(std::string("no EGL library (") + dlerror() + "); " + what_to_install);
  EglApi egl;
#define REFRASTER_EGL_LOAD(TYPE, name)                                                                                 \
  egl.name = reinterpret_cast<PFNEGL##TYPE##PROC>(dlsym(library, "egl" #name));                                        \
  if (!egl.name) throw NoOpenGl("the EGL library has no egl" #name "; " + std::string(what_to_install));
  REFRASTER_EGL_FUNCTIONS(REFRASTER_EGL_LOAD)
#undef REFRASTER_EGL_LOAD
  const auto extension = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(egl.GetProcAddress(name));
  };
  extension(egl.GetPlatformDisplay, "eglGetPlatformDisplayEXT");
  extension(egl.QueryDevices, "eglQueryDevicesEXT");
  extension(egl.QueryDeviceString, "eglQueryDeviceStringEXT");
  if (!egl.GetPlatformDisplay)
    throw NoOpenGl(std::string("this EGL library can only draw to a window (no EGL_EXT_platform_base); ") +
                   what_to_install);
  return egl;
}

const EglApi& egl() {
  static const EglApi api = load_egl();
  return api;
}

/// Whether a list of words divided by spaces holds a word.
bool holds(const char* list, std::string_view word) {
  std::istringstream words(list ? list : "");
  return std::find(std::istream_iterator<std::string>(words), {}, word) != std::istream_iterator<std::string>();
}

/// A place that may be drawn to: a platform of EGL and what it calls native display.
struct Place {
  EGLenum platform;
  void* native;
};

/// In the order to be tried. A GPU comes first where the machine may choose; Mesa's surfaceless platform needs neither
/// GPU nor display server, and takes the driver that the environment names.
std::vector<Place> places(GlRenderer wanted) {
  const char* const client = egl().QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Place> hardware, software;
  if (egl().QueryDevices && holds(client, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    if (egl().QueryDevices(32, devices, &count))
      for (EGLint i = 0; i < count; ++i) {
        const char* const about =
            egl().QueryDeviceString ? egl().QueryDeviceString(devices[i], EGL_EXTENSIONS) : nullptr;
        (holds(about, "EGL_MESA_device_software") ? software : hardware)
            .push_back({EGL_PLATFORM_DEVICE_EXT, devices[i]});
      }
  }
  std::vector<Place> all;
  if (wanted == GlRenderer::system_default) all = hardware;
  if (holds(client, "EGL_MESA_platform_surfaceless"))
    all.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
  all.insert(all.end(), software.begin(), software.end());
  return all;
}

std::string text(const GlApi& gl, GLenum name) {
  const GLubyte* const words = gl.GetString(name);
  return words ? reinterpret_cast<const char*>(words) : "";
}

} // namespace

GlContext::GlContext(GlRenderer wanted) {
  std::vector<std::string> set_here;
  const auto set = [&](const char* name, std::string_view value) {
    setenv(name, std::string(value).c_str(), 1);
    set_here.emplace_back(name);
  };
  // A shader that Mesa finds in its cache on disk is not compiled again, and its warnings are not said again.
  set("MESA_SHADER_CACHE_DISABLE", "true");
  set("MESA_GLSL_CACHE_DISABLE", "true"); // its name before Mesa 21.1
  if (wanted != GlRenderer::system_default) {
    set("GALLIUM_DRIVER", name_of(wanted));
    set("LIBGL_ALWAYS_SOFTWARE", "true");
  }
  const std::string what_to_do = advice(driver_variables(environ, set_here));
  open(wanted, what_to_do);
  if (const char* const missing = load(gl_, egl().GetProcAddress)) {
    close();
    throw NoOpenGl(std::string("this OpenGL has no ") + missing + "; " + what_to_do);
  }
  driver_ = {text(gl_, GL_VENDOR), text(gl_, GL_RENDERER), text(gl_, GL_VERSION),
             text(gl_, GL_SHADING_LANGUAGE_VERSION)};
  if (wanted != GlRenderer::system_default && driver_.renderer.find(name_of(wanted)) == std::string::npos) {
    close();
    throw NoOpenGl(std::string(name_of(wanted)) + " was asked for, but this OpenGL draws with " + driver_.renderer +
                   "; " + what_to_do);
  }
}

void GlContext::open(GlRenderer wanted, const std::string& what_to_do) {
  bool any_display = false;
  for (const Place& place : places(wanted)) {
    display_ = egl().GetPlatformDisplay(place.platform, place.native, nullptr);
    if (!display_) continue;
    if (egl().Initialize(display_, nullptr, nullptr)) {
      any_display = true;
      constexpr EGLint drawing[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
      constexpr EGLint core_3_3[] = {
          EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
      EGLConfig config = nullptr;
      EGLint configs = 0;
      if (egl().BindAPI(EGL_OPENGL_API) && egl().ChooseConfig(display_, drawing, &config, 1, &configs) && configs > 0)
        context_ = egl().CreateContext(display_, config, EGL_NO_CONTEXT, core_3_3);
      if (context_ && egl().MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return;
    }
    close();
  }
  throw NoOpenGl(std::string(any_display ? "no OpenGL 3.3 core here" : "EGL finds no driver to draw with") + "; " +
                 what_to_do);
}

void GlContext::close() {
  if (!display_) return;
  egl().MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_) egl().DestroyContext(display_, context_);
  egl().Terminate(display_);
  display_ = context_ = nullptr;
}

GlContext::~GlContext() {
  close();
}

GlDriver driver_of(GlRenderer renderer) {
  return GlContext(renderer).driver();
}

} // namespace refraster
