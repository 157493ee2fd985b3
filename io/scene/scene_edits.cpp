#include "io/scene/scene_edits.h"

#include <refraster/notes.h>

#include "io/file/nearest.h"
#include "io/file/text.h"
#include "io/json/json_writer.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace refraster {
namespace {

/// What takes the place of some bytes of a text.
struct Replacement {
  std::size_t begin, end;
  std::string text;
};

[[noreturn]] void refuse_edit(const SceneEdit& edit, std::string found, std::string expected) {
  throw InputError(InputFault{edit.origin, 0, 0, edit.pointer, std::move(found), std::move(expected)});
}

/// The parts between the slashes, without their escapes.
std::vector<std::string> parts_of(const SceneEdit& edit) {
  std::vector<std::string> parts;
  if (!edit.pointer.starts_with('/'))
    refuse_edit(edit, in_quotes(edit.pointer), "a JSON pointer, as /scene/camera/fov_y");
  for (std::size_t at = 0; at < edit.pointer.size(); ++at) {
    const char c = edit.pointer[at];
    if (c == '/') {
      parts.emplace_back();
    } else if (c == '~') {
      const char escaped = at + 1 < edit.pointer.size() ? edit.pointer[++at] : '\0';
      if (escaped != '0' && escaped != '1') refuse_edit(edit, "~ without 0 or 1", "~0 for ~, or ~1 for /");
      parts.back() += escaped == '0' ? '~' : '/';
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Finds what a change does to a document.
class Edit {
public:
  Edit(const JsonDocument& document, const SceneEdit& edit) : document_(document), edit_(edit), parts_(parts_of(edit)) {
    if (!edit.value.empty()) {
      const JsonDocument value(edit.origin, edit.value);
      value_ = value.source(value[0]);
    }
    descend(0, 0, 0);
  }
  /// In the order of the text.
  const std::vector<Replacement>& replacements() const { return replacements_; }

private:
  void descend(JsonIndex node, JsonIndex parent, std::size_t depth) {
    const JsonNode& at = document_[node];
    if (depth == parts_.size()) return arrive(node, parent);
    const std::string& part = parts_[depth];
    if (at.kind == JsonKind::object) {
      for (JsonIndex i = at.first_child; i; i = document_[i].next)
        if (document_[i].key == part) return descend(i, node, depth + 1);
      return add(at, depth);
    }
    if (at.kind != JsonKind::array) refuse_edit(edit_, document_.describe(at) + before(depth), "an object or an array");
    if (part == "*") {
      for (JsonIndex i = at.first_child; i; i = document_[i].next) descend(i, node, depth + 1);
      return;
    }
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc{} || end != part.data() + part.size() || number >= at.children)
      refuse_edit(edit_, in_quotes(part) + before(depth),
                  at.children == 0 ? "nothing: the array is empty"
                                   : "0 to " + std::to_string(at.children - 1) + ", or * for all");
    JsonIndex child = at.first_child;
    while (number-- > 0) child = document_[child].next;
    descend(child, node, depth + 1);
  }

  std::string before(std::size_t depth) const {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += '/' + pointer_part(parts_[i]);
    return text.empty() ? text : " at " + text;
  }

  void arrive(JsonIndex node, JsonIndex parent) {
    const JsonNode& at = document_[node];
    if (!value_.empty()) return replacements_.push_back({at.begin, at.end, value_});
    if (document_[parent].kind != JsonKind::object) refuse_edit(edit_, "no member of an object", "a key to leave out");
    // With its comma; a comma that is left behind the last member is allowed.
    JsonIndex previous = 0;
    for (JsonIndex i = document_[parent].first_child; i != node; i = document_[i].next) previous = i;
    if (at.next) replacements_.push_back({at.key_begin, document_[at.next].key_begin, ""});
    else if (previous) replacements_.push_back({document_[previous].end, at.end, ""});
    else replacements_.push_back({document_[parent].begin + 1, document_[parent].end - 1, ""});
  }

  /// The rest of the pointer as a new member.
  void add(const JsonNode& object, std::size_t depth) {
    if (value_.empty()) return; // it is not there already
    std::string text, closing;
    for (std::size_t i = depth; i < parts_.size(); ++i) {
      text += (i > depth ? "{" : "") + json_string(parts_[i]) + ": ";
      if (i > depth) closing += '}';
    }
    replacements_.push_back({object.begin + 1, object.begin + 1, text + value_ + closing + ", "});
  }

  const JsonDocument& document_;
  const SceneEdit& edit_;
  std::vector<std::string> parts_;
  std::string value_;
  std::vector<Replacement> replacements_;
};

/// The text with other bytes in some places.
EditedText replaced(const EditedText& before, const std::vector<Replacement>& replacements, const std::string& origin) {
  EditedText after;
  after.file_text = before.parts.empty() ? before.text : before.file_text;
  const std::vector<TextPart> parts = before.parts.empty() ? std::vector<TextPart>{{}} : before.parts;
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::size_t part_end = i + 1 < parts.size() ? parts[i + 1].begin : before.text.size();
      const std::size_t from = std::max(begin, parts[i].begin), to = std::min(end, part_end);
      if (from >= to) continue;
      TextPart part = parts[i];
      part.source += from - part.begin;
      part.begin = after.text.size();
      after.text.append(before.text, from, to - from);
      after.parts.push_back(std::move(part));
    }
  };
  std::size_t at = 0;
  for (const Replacement& replacement : replacements) {
    copy(at, replacement.begin);
    if (!replacement.text.empty()) after.parts.push_back({after.text.size(), 0, origin});
    after.text += replacement.text;
    at = replacement.end;
  }
  copy(at, before.text.size());
  return after;
}

std::string json_text(auto value) {
  JsonWriter json;
  json.value(value);
  std::string document = json.text();
  document.pop_back(); // its line end
  return document;
}

} // namespace

std::string json_string(std::string_view text) {
  return json_text(text);
}

std::string json_number(double number) {
  return json_text(number);
}

std::string pointer_part(std::string_view key) {
  std::string result;
  for (const char c : key) { // the escapes of a JSON pointer, RFC 6901
    if (c == '~') result += "~0";
    else if (c == '/') result += "~1";
    else result += c;
  }
  return result;
}

EditedText edited_text(const std::string& file, std::string text, const std::vector<SceneEdit>& edits) {
  EditedText edited{std::move(text)};
  for (const SceneEdit& edit : edits) {
    const JsonDocument document(file, edited);
    const Edit change(document, edit);
    // As the document has it: without a byte order mark.
    if (!change.replacements().empty()) edited = replaced(document.text(), change.replacements(), edit.origin);
  }
  return edited;
}

} // namespace refraster
