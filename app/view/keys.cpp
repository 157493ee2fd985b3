#include "app/view/keys.h"

#include "app/options/wrap.h"

#include <algorithm>

namespace refraster {

const std::vector<KeyLine>& key_lines() {
  using enum KeyAction;
  static const std::vector<KeyLine> lines = {
      {"drag", {}, "look around; around a model: turn it"},
      {"W S", {{"W", forward}, {"S", back}}, "forward and back; around a model: nearer and farther"},
      {"A D", {{"A", left}, {"D", right}}, "to the left and to the right"},
      {"Page Up, Page Down", {{"PageUp", up}, {"PageDown", down}}, "up and down"},
      {"wheel", {}, "narrower or wider field of view"},
      {"Tab", {{"Tab", change_motion}}, "walk through the scene, or go around what the camera looks at"},
      {"Home", {{"Home", home}}, "back to the scene's own camera"},
      {"click", {}, "how the pixel comes about, as `refraster explain` says it; the wheel scrolls it"},
      {"F", {{"F", function}}, "fragment function of all objects: the next one, at last the scene's own"},
      {"N", {{"N", precision}}, "number type of the still picture: the next precision"},
      {"1 ... 9",
       {{"1", light},
        {"2", light},
        {"3", light},
        {"4", light},
        {"5", light},
        {"6", light},
        {"7", light},
        {"8", light},
        {"9", light}},
       "the first light off and on, the second, and so on: point lights, then direction lights"},
      {"O", {{"O", shadows}}, "shadows of all lights, what occludes them: off and on"},
      {"E", {{"E", edges}}, "edges of the triangles that are seen, off and on"},
      {"V", {{"V", aov}}, "another value than the colour: the next AOV, as depth, normal, numbers of triangles"},
      {"P", {{"P", picture}}, "write the picture, its camera, and the command that makes it again"},
      {"H", {{"H", help}}, "this help, off and on"},
      {"Esc", {{"Escape", close}}, "close what is written over the picture; else leave"},
      {"Q", {{"Q", quit}}, "leave"}};
  return lines;
}

std::optional<KeyAction> action_of_key(std::string_view name) {
  for (const KeyLine& line : key_lines())
    for (const NamedKey& key : line.keys)
      if (key.name == name) return key.action;
  return std::nullopt;
}

std::string key_note(const KeyLine& line) {
  return std::string(line.shown).append(": ").append(line.meaning);
}

std::vector<std::string> key_table(int width) {
  constexpr int narrowest = 20;
  int first = 0;
  for (const KeyLine& line : key_lines()) first = std::max(first, columns_of(line.shown) + 2);
  std::vector<std::string> table;
  for (const KeyLine& line : key_lines()) {
    std::string text(line.shown);
    for (const std::string& part : wrapped(line.meaning, std::max(narrowest, width - first))) {
      text.append(static_cast<std::size_t>(first - columns_of(text)), ' ');
      table.push_back(text.append(part));
      text.clear();
    }
  }
  return table;
}

std::string keys_markdown() {
  std::string text = "| | |\n|---|---|\n";
  for (const KeyLine& line : key_lines())
    text.append("| ").append(line.shown).append(" | ").append(line.meaning).append(" |\n");
  return text;
}

} // namespace refraster
