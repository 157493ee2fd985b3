#pragma once
// Changes to the text of a scene, before it is read.

#include "io/json/json.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// A change to a scene before it is read.
struct SceneEdit {
  std::string pointer; // of the value: a JSON pointer, RFC 6901, as "/scene/camera/fov_y"
  std::string value;   // JSON. It takes the place of the value, or is added to the object; empty: nothing stays
  std::string origin;  // names it in messages, in the place of the file: "--fov"
};

/// The text with one change after the other. A pointer's members that are not there are made, as the last of its keys
/// is: whether there is such a key is seen when the scene is read. "*" stands for each element of an array. Throws
/// InputError, which names the change, for a text that is no JSON, a value that is none, and a pointer that leads
/// nowhere.
EditedText edited_text(const std::string& file, std::string text, const std::vector<SceneEdit>& edits);

/// A text in the quotes and with the escapes of JSON.
std::string json_string(std::string_view text);

/// A finite number as JSON has it; it reads back as the same double.
std::string json_number(double number);

/// One part of a pointer, with its escapes.
std::string pointer_part(std::string_view key);

} // namespace refraster
