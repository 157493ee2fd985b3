#include "app/view/window/window.h"

#include "app/view/window/sdl_api.h"

#include <algorithm>
#include <cstdlib>

namespace refraster {
namespace {

using Surface = std::unique_ptr<SDL_Surface, decltype(&::SDL_FreeSurface)>;

Surface owned(SDL_Surface* surface) {
  if (!surface) throw std::runtime_error(std::string("SDL: ") + sdl().GetError());
  return {surface, sdl().FreeSurface};
}

/// SDL would ask each system of windows in turn, of which some print what they miss, and at last draw into nothing.
bool names_a_display() {
  const auto is_set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("SDL_VIDEODRIVER");
}

/// What of it is of interest here.
std::optional<WindowEvent> read(const SDL_Event& event) {
  using Kind = WindowEvent::Kind;
  switch (event.type) {
  case SDL_QUIT:
    return WindowEvent{Kind::close};
  case SDL_KEYDOWN:
  case SDL_KEYUP:
    if (event.key.repeat != 0) return std::nullopt;
    return WindowEvent{event.type == SDL_KEYDOWN ? Kind::key_down : Kind::key_up,
                       sdl().GetKeyName(event.key.keysym.sym)};
  case SDL_MOUSEBUTTONDOWN:
  case SDL_MOUSEBUTTONUP:
    if (event.button.button != SDL_BUTTON_LEFT) return std::nullopt;
    return WindowEvent{
        event.type == SDL_MOUSEBUTTONDOWN ? Kind::button_down : Kind::button_up, {}, event.button.x, event.button.y};
  case SDL_MOUSEMOTION:
    return WindowEvent{Kind::mouse, {}, event.motion.x, event.motion.y};
  case SDL_MOUSEWHEEL: {
    WindowEvent wheel{Kind::wheel};
    sdl().GetMouseState(&wheel.x, &wheel.y);
    wheel.notches = static_cast<double>(event.wheel.preciseY);
    if (event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED) wheel.notches = -wheel.notches;
    return wheel;
  }
  case SDL_WINDOWEVENT:
    if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED || event.window.event == SDL_WINDOWEVENT_EXPOSED)
      return WindowEvent{Kind::resized};
    if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) return WindowEvent{Kind::focus_lost};
    return std::nullopt;
  default:
    return std::nullopt;
  }
}

} // namespace

struct Window::Display {
  SDL_Window* window = nullptr;
};

Window::Window() : display_(std::make_unique<Display>()) {
  const SdlApi& api = sdl();
  if (!names_a_display()) throw NoWindow("no display: neither DISPLAY nor WAYLAND_DISPLAY says where");
  api.SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); // app/interrupt.h has its own
  api.SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  // The picture is in memory: OpenGL would be loaded only to copy it.
  api.SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  // A compositor goes on for the other windows.
  api.SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  if (api.Init(SDL_INIT_VIDEO) != 0) throw NoWindow(std::string("no display: ") + api.GetError());
}

Window::~Window() {
  close();
}

// SDL 2.26 ends its own waiting by an event that it sends to the window over a second connection. Where that comes to
// the X server after the window was destroyed, Xlib ends the program with exit code 1. So the window is hidden, and
// goes when the program does.
void Window::close() {
  if (display_->window) sdl().HideWindow(display_->window);
  display_->window = nullptr;
}

void Window::open(const std::string& title, Size size) {
  const SdlApi& api = sdl();
  if (SDL_Rect room; api.GetDisplayUsableBounds(0, &room) == 0 && room.w > 0 && room.h > 0) {
    const double fraction = std::min({1.0, double(room.w) / size.width, double(room.h) / size.height});
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(side * fraction)); };
    size = {scaled(size.width), scaled(size.height)};
  }
  display_->window = api.CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width,
                                      size.height, SDL_WINDOW_RESIZABLE);
  if (!display_->window) throw NoWindow(std::string("no window: ") + api.GetError());
}

Size Window::size() const {
  Size size;
  sdl().GetWindowSize(display_->window, &size.width, &size.height);
  return {std::clamp(size.width, 1, largest_side), std::clamp(size.height, 1, largest_side)};
}

void Window::set_title(const std::string& title) {
  sdl().SetWindowTitle(display_->window, title.c_str());
}

void Window::show(const Image<std::uint8_t>& picture, const std::function<void(const Canvas&)>& draw_over) {
  const SdlApi& api = sdl();
  SDL_Surface* const shown = api.GetWindowSurface(display_->window);
  if (!shown) return; // as while it is being resized: an event will say that it is there
  const Size size{shown->w, shown->h};
  constexpr Uint32 format = SDL_PIXELFORMAT_RGB888; // 0x00RRGGBB
  Surface canvas{nullptr, api.FreeSurface};
  if (picture.empty()) {
    canvas = owned(api.CreateRGBSurfaceWithFormat(0, size.width, size.height, 32, format)); // black
  } else {
    // SDL does not write to the pixels of a surface that it converts.
    auto* const bytes = const_cast<std::uint8_t*>(picture.values.data());
    const Surface source = owned(api.CreateRGBSurfaceWithFormatFrom(bytes, picture.width, picture.height, 24,
                                                                    3 * picture.width, SDL_PIXELFORMAT_RGB24));
    canvas = owned(api.ConvertSurfaceFormat(source.get(), format, 0));
    if (picture.width != size.width || picture.height != size.height) {
      Surface stretched = owned(api.CreateRGBSurfaceWithFormat(0, size.width, size.height, 32, format));
      api.SoftStretchLinear(canvas.get(), nullptr, stretched.get(), nullptr);
      canvas = std::move(stretched);
    }
  }
  draw_over({static_cast<std::uint32_t*>(canvas->pixels), canvas->w, canvas->h, canvas->pitch / 4});
  api.BlitSurface(canvas.get(), nullptr, shown, nullptr);
  api.UpdateWindowSurface(display_->window);
}

std::optional<WindowEvent> Window::wait(int milliseconds) {
  SDL_Event event;
  while (sdl().WaitEventTimeout(&event, milliseconds) == 1) {
    if (const auto of_interest = read(event)) return of_interest;
    milliseconds = 0; // what is of no interest here has ended the wait
  }
  return std::nullopt;
}

} // namespace refraster
