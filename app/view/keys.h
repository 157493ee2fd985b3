#pragma once
// The keys of the window, declared: what H shows, `refraster view --help`, docs/view.md and the window's own reading of
// keys follow from one list.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

enum class KeyAction {
  forward,
  back,
  left,
  right,
  up,
  down,
  change_motion, // walk or orbit
  home,          // the scene's own camera
  function,
  precision,
  light, // that of the key's number
  shadows,
  edges,
  aov,
  picture, // write it
  help,
  close, // a panel of text, or the window
  quit,
  count_
};

/// A key by the name that SDL gives it, SDL_GetKeyName: "W", "Page Up", "1".
struct NamedKey {
  std::string_view name;
  KeyAction action;
};

/// A line of the help: keys that belong together, or something that is done with the mouse, which has none.
struct KeyLine {
  std::string_view shown; // "W S"
  std::vector<NamedKey> keys;
  std::string_view meaning; // a phrase without a full stop
};

const std::vector<KeyLine>& key_lines();

/// Nothing for a key without a meaning.
std::optional<KeyAction> action_of_key(std::string_view name);

/// "W S: forward and back".
std::string key_note(const KeyLine& line);
/// In two columns, for a window so many characters wide; the second is at least 20 wide.
std::vector<std::string> key_table(int width);
/// For docs/view.md: `refraster list keys`.
std::string keys_markdown();

} // namespace refraster
