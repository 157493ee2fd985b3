#pragma once
// JSON documents that the program writes.

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Writes one document, indented, members in the order of the calls. Numbers read back as the same double; what JSON
/// has no number for (NaN, infinity) becomes null, and what is no UTF-8 U+FFFD. Members stand in objects only, and
/// values elsewhere (assert).
class JsonWriter {
public:
  JsonWriter();
  ~JsonWriter();
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;

  void null();
  void value(double number);
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(std::same_as<bool> auto flag) { write_bool(flag); }
  void value(std::integral auto number) requires(!std::same_as<decltype(number), bool>) {
    write_integer(static_cast<std::int64_t>(number));
  }
  template <class Item>
  void value(const std::vector<Item>& items) {
    begin_array();
    for (const Item& item : items) value(item);
    end_array();
  }

  /// What is not there is null.
  template <class Content>
  void value(const std::optional<Content>& content) {
    if (content) value(*content);
    else null();
  }

  /// An object or array of what write() writes.
  template <std::invocable Write>
  void object(const Write& write) {
    begin_object();
    write();
    end_object();
  }
  template <std::invocable Write>
  void array(const Write& write) {
    begin_array();
    write();
    end_array();
  }

  void key(std::string_view name);

  /// One member of an object.
  void member(std::string_view name, const auto& content) {
    key(name);
    value(content);
  }

  template <std::invocable Write>
  void object(std::string_view name, const Write& write) {
    key(name);
    object(write);
  }
  template <std::invocable Write>
  void array(std::string_view name, const Write& write) {
    key(name);
    array(write);
  }
  /// What write(*content) writes, or null.
  template <class Content, class Write>
  void optional(std::string_view name, const Content& content, const Write& write) {
    key(name);
    if (content) write(*content);
    else null();
  }
  /// A text, or null for an empty one.
  void text_or_null(std::string_view name, std::string_view text) {
    key(name);
    if (text.empty()) null();
    else value(text);
  }

  /// The finished document, with a newline at its end.
  std::string text() const;

private:
  void begin_object();
  void end_object();
  void begin_array();
  void end_array();
  void write_bool(bool flag);
  void write_integer(std::int64_t number);

  struct Document;
  std::unique_ptr<Document> document_;
};

} // namespace refraster
