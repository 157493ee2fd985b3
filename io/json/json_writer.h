#pragma once
// JSON documents that the program writes: reports of frames and of comparisons.

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Writes one document, indented, members in the order of the calls. Numbers read back as the same double; what JSON
/// has no number for (NaN, infinity) becomes null, and what is no UTF-8 U+FFFD. Calls must nest properly (assert).
class JsonWriter {
public:
  JsonWriter();
  ~JsonWriter();
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;

  void begin_object();
  void end_object();
  void begin_array();
  void end_array();
  void key(std::string_view name);

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

  /// One member of an object.
  void member(std::string_view name, const auto& content) {
    key(name);
    value(content);
  }

  /// The finished document, with a newline at its end.
  std::string text() const;

private:
  void write_bool(bool flag);
  void write_integer(std::int64_t number);

  struct Document;
  std::unique_ptr<Document> document_;
};

} // namespace refraster
