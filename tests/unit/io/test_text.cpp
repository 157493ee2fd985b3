// Text that the program writes: UTF-8 and JSON of whatever bytes a name has.

#include "io/file/text.h"
#include "io/json/json_writer.h"

#include <doctest/doctest.h>

namespace refraster {

TEST_CASE("what is UTF-8 stays, and each byte that is part of no character is replaced") {
  for (const char* const text : {"", "plain", "Gr\xc3\xbc\xc3\x9f", "\xe2\x82\xac", "\xf0\x9f\x98\x80", "\xef\xbf\xbf",
                                 "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf", "\xee\x80\x80"})
    CHECK(as_utf8(text) == text);
  const std::string bad = "\xef\xbf\xbd";
  CHECK(as_utf8("a\xff"
                "b") == "a" + bad + "b");
  CHECK(as_utf8("\xc3") == bad);                               // ends too early
  CHECK(as_utf8("\x80") == bad);                               // begins in the middle
  CHECK(as_utf8("\xc0\xaf") == bad + bad);                     // a slash in two bytes
  CHECK(as_utf8("\xe0\x9f\xbf") == bad + bad + bad);           // two bytes' worth in three
  CHECK(as_utf8("\xf0\x8f\xbf\xbf") == bad + bad + bad + bad); // three bytes' worth in four
  CHECK(as_utf8("\xed\xa0\x80") == bad + bad + bad);           // a surrogate
  CHECK(as_utf8("\xf4\x90\x80\x80") == bad + bad + bad + bad); // beyond U+10FFFF
  CHECK(as_utf8("\xe2\x82z") == bad + bad + "z");
}

TEST_CASE("JSON is JSON whatever bytes a name has") {
  JsonWriter json;
  json.object([&] {
    json.member("out\xff", std::string("b\xe9"
                                       "r.png"));
  });
  CHECK(json.text() == "{\n  \"out\xef\xbf\xbd\": \"b\xef\xbf\xbdr.png\"\n}\n");
}

} // namespace refraster
