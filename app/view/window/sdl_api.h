#pragma once
// The functions of SDL2 that are used here, and no others. Loaded at run time: a program that is built with a window
// starts on machines that have no SDL2, and starts no slower than without.

#include <SDL.h>

namespace refraster {

#define REFRASTER_SDL_FUNCTIONS(F)                                                                                     \
  F(BlitSurface, SDL_UpperBlit)                                                                                        \
  F(ConvertSurfaceFormat, SDL_ConvertSurfaceFormat)                                                                    \
  F(CreateRGBSurfaceWithFormat, SDL_CreateRGBSurfaceWithFormat)                                                        \
  F(CreateRGBSurfaceWithFormatFrom, SDL_CreateRGBSurfaceWithFormatFrom)                                                \
  F(CreateWindow, SDL_CreateWindow)                                                                                    \
  F(FreeSurface, SDL_FreeSurface)                                                                                      \
  F(GetDisplayUsableBounds, SDL_GetDisplayUsableBounds)                                                                \
  F(GetError, SDL_GetError)                                                                                            \
  F(GetKeyName, SDL_GetKeyName)                                                                                        \
  F(GetMouseState, SDL_GetMouseState)                                                                                  \
  F(GetWindowSize, SDL_GetWindowSize)                                                                                  \
  F(GetWindowSurface, SDL_GetWindowSurface)                                                                            \
  F(HideWindow, SDL_HideWindow)                                                                                        \
  F(Init, SDL_Init)                                                                                                    \
  F(SetHint, SDL_SetHint)                                                                                              \
  F(SetWindowTitle, SDL_SetWindowTitle)                                                                                \
  F(SoftStretchLinear, SDL_SoftStretchLinear)                                                                          \
  F(UpdateWindowSurface, SDL_UpdateWindowSurface)                                                                      \
  F(WaitEventTimeout, SDL_WaitEventTimeout)

/// Each by the type that SDL's header gives it.
struct SdlApi {
#define REFRASTER_SDL_MEMBER(name, symbol) decltype(&::symbol) name = nullptr;
  REFRASTER_SDL_FUNCTIONS(REFRASTER_SDL_MEMBER)
#undef REFRASTER_SDL_MEMBER
};

/// Loads the library, once; it stays. Throws NoWindow where there is none.
const SdlApi& sdl();

} // namespace refraster
