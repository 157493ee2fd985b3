#include "io/scene/example_scene.h"

#include "io/file/input_file.h"
#include "io/file/number_text.h"
#include "io/json/json_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string_view>

namespace refraster {
namespace {

/// The next word of a line, which is taken off it.
std::string_view next_word(std::string_view& line) {
  constexpr std::string_view blanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::size_t end = std::min(line.find_first_of(blanks), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

/// Makes the box hold the vertex that a line says, if it says one.
void grow(Box& box, std::string_view line) {
  if (next_word(line) != "v") return;
  Double3 vertex;
  for (int c = 0; c < 3; ++c)
    if (read_number(next_word(line), vertex[c]) != NumberText::good) return;
  for (int c = 0; c < 3; ++c) {
    box.least[c] = std::min(box.least[c], vertex[c]);
    box.most[c] = std::max(box.most[c], vertex[c]);
  }
}

std::string three(const Double3& v) {
  char text[100];
  std::snprintf(text, sizeof text, "%.9g %.9g %.9g", v.x, v.y, v.z);
  return text;
}

std::string quoted(const std::string& text) {
  JsonWriter json;
  json.value(text);
  const std::string document = json.text();
  return document.substr(0, document.size() - 1); // without its line end
}

std::string scene_text(const std::string& mesh, const std::string& camera) {
  return R"({"scene": {
  "camera": {)" +
         camera + R"(},
  "point_lights": [],
  "direction_lights": [
    {"direction": "-1 -1.5 -1", "radiance": "0.9 0.9 0.85"},
    {"direction": "1 0.3 -0.5", "radiance": "0.15 0.18 0.25"}
  ],
  "objects": [{
    )" + mesh +
         R"(,
    "fragment_function": "phong",
    "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
    "material": {"ka": "0.1 0.1 0.1", "kd": "0.7 0.7 0.7", "ks": "0.2 0.2 0.2", "glossiness": 30}
  }]
}}
)";
}

} // namespace

std::optional<Box> obj_vertex_box(const std::string& path) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::uint64_t max_bytes = std::uint64_t{1} << 30, part_bytes = std::uint64_t{1} << 20;
  Box box{Double3(infinity), Double3(-infinity)};
  try {
    const InputFile file(path, "an OBJ file", std::numeric_limits<std::uint64_t>::max());
    const std::uint64_t end = std::min(file.size_bytes(), max_bytes);
    std::string text; // begins at the begin of a line
    for (std::uint64_t at = 0; at < end;) {
      const auto size = static_cast<std::size_t>(std::min(part_bytes, end - at));
      const std::size_t kept = text.size();
      text.resize(kept + size);
      file.read(at, text.data() + kept, size);
      at += size;
      std::size_t begin = 0;
      for (std::size_t line_end = text.find('\n', kept); line_end != std::string::npos;
           line_end = text.find('\n', begin)) {
        grow(box, std::string_view(text).substr(begin, line_end - begin));
        begin = line_end + 1;
      }
      text.erase(0, begin);
      if (text.size() > part_bytes) text.clear(); // no vertex has such a line
    }
    grow(box, text);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (!(box.least.x <= box.most.x)) return std::nullopt;
  return box;
}

std::string example_scene() {
  return scene_text(R"("mesh": {"sphere": {}})", R"("position": "0 0 5", "fov_y": 30)");
}

std::string example_scene(const std::string& obj_file_path, const Box& box) {
  constexpr double fov_y_degrees = 40;
  const Double3 centre = box.least * 0.5 + box.most * 0.5, half = box.most * 0.5 - box.least * 0.5;
  const double extent = length(half), radius = extent > 0 && std::isfinite(extent) ? extent : 1;
  // A sphere around the box fills the height of the image at radius / sin(fov / 2); a tenth more leaves a margin.
  const double distance = 1.1 * radius / std::sin(fov_y_degrees / 2 * std::numbers::pi / 180);
  const Double3 position = centre + normalize(Double3(0.5, 0.4, 1)) * distance;
  char planes[100];
  std::snprintf(planes, sizeof planes, R"("fov_y": %g, "near": %.3g, "far": %.3g)", fov_y_degrees, distance / 100,
                distance * 10);
  return scene_text("\"obj_file_path\": " + quoted(obj_file_path),
                    "\"position\": \"" + three(position) + "\", \"target\": \"" + three(centre) + "\", " + planes);
}

} // namespace refraster
