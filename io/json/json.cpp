#include "io/json/json.h"

#include "io/file/number_text.h"
#include "io/file/text.h"

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <new>
#include <utility>

namespace refraster {
namespace {

// Numbers are handed over as text: what rapidjson 1.1 makes of 0e308 or 0.0e-9 rests on the number of leading zeros of
// 0, which is not defined.
constexpr unsigned parse_flags = rapidjson::kParseIterativeFlag | rapidjson::kParseCommentsFlag |
                                 rapidjson::kParseTrailingCommasFlag | rapidjson::kParseNumbersAsStringsFlag |
                                 rapidjson::kParseValidateEncodingFlag;

/// rapidjson writes to whatever its allocator gives.
struct ThrowingAllocator : rapidjson::CrtAllocator {
  void* Malloc(std::size_t size) { return given(CrtAllocator::Malloc(size), size); }
  void* Realloc(void* memory, std::size_t old_size, std::size_t size) {
    return given(CrtAllocator::Realloc(memory, old_size, size), size);
  }

private:
  static void* given(void* memory, std::size_t size) {
    if (!memory && size > 0) throw std::bad_alloc();
    return memory;
  }
};

/// The text as rapidjson reads it. Its own StringStream knows the end by a zero byte, and steps over that where a
/// character of several bytes is cut there; and of that stream the reader works on copies, while the original stands
/// still. This one ends where the text does, and its position is the reader's.
struct TrackedStream {
  using Ch = char;
  const char *begin, *at, *end;

  explicit TrackedStream(std::string_view text) : begin(text.data()), at(begin), end(begin + text.size()) {}

  // NOLINTBEGIN(readability-identifier-naming): the names that rapidjson calls
  char Peek() const { return at < end ? *at : '\0'; }
  char Take() { return at < end ? *at++ : '\0'; }
  std::size_t Tell() const { return static_cast<std::size_t>(at - begin); }
  // For writers.
  char* PutBegin() { return nullptr; }
  void Put(char) {}
  void Flush() {}
  std::size_t PutEnd(char*) { return 0; }
  // NOLINTEND(readability-identifier-naming)
};
static_assert(!rapidjson::StreamTraits<TrackedStream>::copyOptimization);

/// Builds the list of values from what the reader meets. The reader tells no positions, but its stream stands just
/// behind a scalar or key when the handler is called, and on the bracket of an array or object.
class TreeBuilder {
public:
  TreeBuilder(const std::string& text, const TrackedStream& stream, std::string& decoded, std::vector<JsonNode>& nodes)
      : text_(text), stream_(stream), decoded_(decoded), nodes_(nodes) {}

  bool too_deep() const { return open_.size() > limit::json_depth.value; }
  bool number_is_too_big() const { return number_is_too_big_; }

  // NOLINTBEGIN(readability-identifier-naming): the names that rapidjson calls
  bool Null() { return scalar(JsonKind::null, offset() - 4); }
  bool Bool(bool value) { return scalar(JsonKind::boolean, offset() - (value ? 4 : 5)); }
  bool RawNumber(const char* text, rapidjson::SizeType length, bool) {
    double value = 0;
    number_is_too_big_ = read_number(std::string_view(text, length), value) != NumberText::good;
    return !number_is_too_big_ && number(value);
  }
  // Only without kParseNumbersAsStringsFlag.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }

  bool String(const char* text, rapidjson::SizeType length, bool) {
    scalar(JsonKind::string, opening_quote());
    nodes_.back().string = store(text, length);
    return true;
  }
  bool Key(const char* text, rapidjson::SizeType length, bool) {
    key_begin_ = opening_quote();
    key_ = store(text, length);
    return true;
  }
  bool StartObject() { return start(JsonKind::object); }
  bool StartArray() { return start(JsonKind::array); }
  bool EndObject(rapidjson::SizeType) { return finish(); }
  bool EndArray(rapidjson::SizeType) { return finish(); }
  // NOLINTEND(readability-identifier-naming)

private:
  struct Open {
    JsonIndex node, last_child;
  };

  std::uint32_t offset() const { return static_cast<std::uint32_t>(stream_.Tell()); }

  /// Of the string whose closing quote was just read: the last quote before it that no odd run of backslashes escapes.
  std::uint32_t opening_quote() const {
    std::uint32_t at = offset() - 1;
    for (;;) {
      --at;
      if (text_[at] != '"') continue;
      std::uint32_t run = at;
      while (run > 0 && text_[run - 1] == '\\') --run;
      if ((at - run) % 2 == 0) return at;
    }
  }

  /// The decoded text is never longer than the file, for which `decoded_` has room: views into it stay valid.
  std::string_view store(const char* text, std::size_t length) {
    const std::size_t begin = decoded_.size();
    decoded_.append(text, length);
    return std::string_view(decoded_).substr(begin, length);
  }

  void add(JsonKind kind, std::uint32_t begin) {
    const auto index = static_cast<JsonIndex>(nodes_.size());
    JsonNode node{};
    node.kind = kind;
    node.begin = begin;
    node.end = offset();
    if (!open_.empty()) {
      Open& parent = open_.back();
      if (nodes_[parent.node].kind == JsonKind::object) {
        node.key = key_;
        node.key_begin = key_begin_;
      }
      (parent.last_child ? nodes_[parent.last_child].next : nodes_[parent.node].first_child) = index;
      parent.last_child = index;
      ++nodes_[parent.node].children;
    }
    nodes_.push_back(node);
  }

  bool scalar(JsonKind kind, std::uint32_t begin) {
    add(kind, begin);
    return true;
  }
  bool number(double value) {
    std::uint32_t begin = offset();
    while (begin > 0 && std::string_view("+-.0123456789eE").find(text_[begin - 1]) != std::string_view::npos) --begin;
    add(JsonKind::number, begin);
    nodes_.back().number = value;
    return true;
  }
  bool start(JsonKind kind) {
    add(kind, offset());
    open_.push_back({static_cast<JsonIndex>(nodes_.size() - 1), 0});
    return !too_deep();
  }
  bool finish() {
    nodes_[open_.back().node].end = offset() + 1;
    open_.pop_back();
    return true;
  }

  const std::string& text_;
  const TrackedStream& stream_;
  std::string& decoded_;
  std::vector<JsonNode>& nodes_;
  std::vector<Open> open_;
  std::string_view key_;
  std::uint32_t key_begin_ = 0;
  bool number_is_too_big_ = false;
};

const char* expected_syntax(rapidjson::ParseErrorCode code) {
  switch (code) {
  case rapidjson::kParseErrorDocumentEmpty:
    return "a JSON value";
  case rapidjson::kParseErrorDocumentRootNotSingular:
    return "the end of the file";
  case rapidjson::kParseErrorValueInvalid:
    return "a JSON value";
  case rapidjson::kParseErrorObjectMissName:
    return "a key in quotes, or '}'";
  case rapidjson::kParseErrorObjectMissColon:
    return "':'";
  case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
    return "',' or '}'";
  case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
    return "',' or ']'";
  case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
    return "four hexadecimal digits after \\u";
  case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
    return "a pair of UTF-16 surrogates";
  case rapidjson::kParseErrorStringEscapeInvalid:
    return "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u";
  case rapidjson::kParseErrorStringMissQuotationMark:
    return "a string that ends in '\"'";
  case rapidjson::kParseErrorStringInvalidEncoding:
    return "UTF-8";
  case rapidjson::kParseErrorNumberTooBig:
    return "a number below 1.8e308";
  case rapidjson::kParseErrorNumberMissFraction:
    return "a digit after '.'";
  case rapidjson::kParseErrorNumberMissExponent:
    return "a digit in the exponent";
  case rapidjson::kParseErrorUnspecificSyntaxError:
    return "a comment: //, or /* closed by */";
  default:
    return "JSON";
  }
}

} // namespace

JsonDocument::JsonDocument(std::string file, std::string text)
    : JsonDocument(std::move(file), EditedText{std::move(text)}) {}

JsonDocument::JsonDocument(std::string file, EditedText edited) : file_(std::move(file)), edited_(std::move(edited)) {
  if (text_.starts_with("\xef\xbb\xbf")) text_.replace(0, 3, "   "); // byte order mark
  if (const std::size_t zero = text_.find('\0'); zero != std::string::npos)
    throw InputError(fault_at(zero, "", "a zero byte", "text"));
  if (text_.size() > max_bytes)
    throw InputError(fault_at(0, "", found_of(limit::scene_bytes, text_.size()), at_most(limit::scene_bytes)));
  decoded_.reserve(text_.size());
  // At most 75 bytes a character in all, limit::scene_bytes.
  static_assert(sizeof(JsonNode) <= 72);
  // A value is the root, or the first in its brackets, or behind a comma: so memory is taken once, and no more than the
  // text asks for.
  nodes_.reserve(1 + static_cast<std::size_t>(std::count_if(text_.begin(), text_.end(),
                                                            [](char c) { return c == ',' || c == '[' || c == '{'; })));
  TrackedStream stream(text_);
  rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, ThrowingAllocator> reader;
  TreeBuilder builder(text_, stream, decoded_, nodes_);
  reader.Parse<parse_flags>(stream, builder);
  if (!reader.HasParseError()) return;

  const std::size_t at = std::min(reader.GetErrorOffset(), text_.size());
  if (builder.too_deep())
    throw InputError(
        fault_at(at, "", found_of(limit::json_depth, limit::json_depth.value + 1), at_most(limit::json_depth)));
  std::string found = "the end of the file";
  const char* expected =
      expected_syntax(builder.number_is_too_big() ? rapidjson::kParseErrorNumberTooBig : reader.GetParseErrorCode());
  if (at < text_.size() && text_[at] == '\n' &&
      reader.GetParseErrorCode() == rapidjson::kParseErrorStringEscapeInvalid) {
    found = "a line end"; // which the reader calls a bad escape
    expected = expected_syntax(rapidjson::kParseErrorStringMissQuotationMark);
  } else if (at < text_.size()) {
    const std::size_t word_end = text_.find_first_of(" \t\r\n,:[]{}", at + 1);
    found = in_quotes(std::string_view(text_).substr(at, word_end == std::string::npos ? word_end : word_end - at));
  }
  throw InputError(fault_at(at, "", std::move(found), expected));
}

std::string_view JsonDocument::source(const JsonNode& node) const {
  return std::string_view(text_).substr(node.begin, node.end - node.begin);
}

std::string JsonDocument::describe(const JsonNode& node) const {
  switch (node.kind) {
  case JsonKind::string:
    return in_quotes(node.string);
  case JsonKind::array:
    return "an array of " + counted(node.children, "value");
  case JsonKind::object:
    return "an object";
  default:
    return std::string(source(node).substr(0, 60));
  }
}

InputFault JsonDocument::fault_at(std::size_t offset, std::string path, std::string found, std::string expected) const {
  InputFault fault;
  fault.file = file_;
  TextPart part;
  for (const TextPart& one : edited_.parts)
    if (one.begin <= offset) part = one;
  if (part.origin.empty()) {
    const TextPlace place =
        place_in(edited_.parts.empty() ? text_ : edited_.file_text, part.source + (offset - part.begin));
    fault.line = place.line;
    fault.column = place.column;
  } else {
    fault.file = part.origin;
  }
  fault.path = std::move(path);
  fault.found = std::move(found);
  fault.expected = std::move(expected);
  return fault;
}

JsonIndex member_of(const JsonDocument& document, JsonIndex object, std::string_view key) {
  for (JsonIndex i = document[object].first_child; i; i = document[i].next)
    if (document[i].key == key) return i;
  return 0;
}

} // namespace refraster
