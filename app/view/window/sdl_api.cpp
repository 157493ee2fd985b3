#include "app/view/window/sdl_api.h"

#include "app/view/window/window.h"

#include <dlfcn.h>

namespace refraster {
namespace {

SdlApi loaded() {
  const char* const file = "libSDL2-2.0.so.0";
  void* const library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!library) throw NoWindow("no SDL2 on this machine (Debian: libsdl2-2.0-0): " + std::string(dlerror()));
  SdlApi api;
#define REFRASTER_SDL_LOAD(name, symbol)                                                                               \
  api.name = reinterpret_cast<decltype(api.name)>(dlsym(library, #symbol));                                            \
  if (!api.name) throw NoWindow(std::string(file) + " has no " #symbol ": SDL 2.0.16 or later is needed");
  REFRASTER_SDL_FUNCTIONS(REFRASTER_SDL_LOAD)
#undef REFRASTER_SDL_LOAD
  return api;
}

} // namespace

const SdlApi& sdl() {
  static const SdlApi api = loaded();
  return api;
}

} // namespace refraster
