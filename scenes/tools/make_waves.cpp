// make_waves COLUMNSxROWS FILE.obj: a rough sea of 2 COLUMNS ROWS triangles, see waves.h. With 1000x500 that is a
// million, each about a pixel at 1280x720.

#include <refraster/files.h>

#include "scenes/synthesis/waves.h"

#include <charconv>
#include <iostream>
#include <optional>
#include <string_view>

namespace refraster {
namespace {

std::optional<Quads> quads_from(std::string_view text) {
  Quads quads{};
  const char* const end = text.data() + text.size();
  const auto [x, first_error] = std::from_chars(text.data(), end, quads.columns);
  if (first_error != std::errc{} || x == end || *x != 'x') return std::nullopt;
  const auto [rest, second_error] = std::from_chars(x + 1, end, quads.rows);
  const auto sane = [](std::uint32_t n) { return n >= 1 && n <= 10'000; };
  if (second_error != std::errc{} || rest != end || !sane(quads.columns) || !sane(quads.rows)) return std::nullopt;
  return quads;
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  const auto quads = argc == 3 ? refraster::quads_from(argv[1]) : std::nullopt;
  if (!quads) {
    std::cerr << "usage: make_waves COLUMNSxROWS FILE.obj, each 1 to 10000\n";
    return 2;
  }
  try {
    refraster::write_obj(argv[2], refraster::waves(*quads));
    std::cout << argv[2] << "\n";
  } catch (const std::exception& error) {
    std::cerr << "make_waves: " << error.what() << "\n";
    return 4;
  }
}
