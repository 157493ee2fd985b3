// Of a program that is built without SDL2.

#include "app/view/window/window.h"

namespace refraster {

struct Window::Display {};

Window::Window() {
  throw NoWindow("this program was built without a window, which needs SDL2: scripts/setup window, and build again");
}
Window::~Window() = default;
void Window::open(const std::string&, Size) {}
void Window::close() {}
Size Window::size() const {
  return {};
}
void Window::set_title(const std::string&) {}
void Window::show(const Image<std::uint8_t>&, const std::function<void(const Canvas&)>&) {}
std::optional<WindowEvent> Window::wait(int) {
  return std::nullopt;
}

} // namespace refraster
