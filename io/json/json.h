#pragma once
// JSON text as a tree that knows where in the file each value stands.

#include <refraster/notes.h>

#include "io/file/limits.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

/// A value of a JsonDocument, by its place in the list of all values; 0 is the root.
using JsonIndex = std::uint32_t;

struct JsonNode {
  JsonKind kind;
  std::uint32_t begin, end;            // bytes of the file: the value is text[begin, end)
  std::uint32_t key_begin = 0;         // of a member: where its key stands
  std::string_view key, string;        // decoded; string: of a string
  double number = 0;                   // of a number, correctly rounded
  JsonIndex first_child = 0, next = 0; // 0: there is none, since the root is nobody's child
  std::uint32_t children = 0;
};

/// Where a part of a text that was put together is from, up to the next part.
struct TextPart {
  std::size_t begin = 0;  // in the text
  std::size_t source = 0; // of the part's first byte: in the file; nothing with an origin
  std::string origin;     // what messages name in the place of the file; empty: the file
};

/// A file's text, changed.
struct EditedText {
  std::string text;
  std::vector<TextPart> parts = {}; // in the order of the text; none: all is as in the file
  std::string file_text = {};       // as it was, where there are parts
};

/// One JSON file. Beside the standard: // and /* */ comments, and a comma after the last member or element.
/// All values lie in one list, so that neither reading nor freeing a file recurses, however deep it nests.
class JsonDocument {
public:
  /// Throws InputError at the first fault of syntax, and for a text beyond limit::scene_bytes or
  /// limit::json_depth. `file` only names it in messages.
  JsonDocument(std::string file, std::string text);
  /// The same of a text that was changed. Messages have the places of the file, or what a part is from.
  JsonDocument(std::string file, EditedText edited);
  JsonDocument(const JsonDocument&) = delete;

  static constexpr std::size_t max_bytes = limit::scene_bytes.value;

  const std::string& file() const { return file_; }
  const JsonNode& operator[](JsonIndex i) const { return nodes_[i]; }
  /// All of it, as it was given.
  const EditedText& text() const { return edited_; }
  /// The value as written.
  std::string_view source(const JsonNode& node) const;
  /// What a message says was found: the value as written where it is short, else its kind.
  std::string describe(const JsonNode& node) const;
  /// A fault at a byte of the text, with line and column (in characters).
  InputFault fault_at(std::size_t offset, std::string path, std::string found, std::string expected) const;

private:
  std::string file_;
  EditedText edited_;
  std::string& text_ = edited_.text;
  std::string decoded_; // keys and strings, one after the other
  std::vector<JsonNode> nodes_;
};

/// The member of an object; 0, which is the root and no member, where there is none.
JsonIndex member_of(const JsonDocument& document, JsonIndex object, std::string_view key);

} // namespace refraster
