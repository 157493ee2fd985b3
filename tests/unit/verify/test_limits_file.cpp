#include <refraster/notes.h>

#include "verify/compare/limits_file.h"

#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <fstream>

using namespace refraster;

namespace {

CompareLimits limits_in(const std::string& text) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "limits.json") << text;
  return read_limits(folder / "limits.json");
}

} // namespace

TEST_CASE("limits come from a file, each of them optional") {
  const CompareLimits all = limits_in(R"({"max_abs": 1.5, "max_rms": 0.25, "max_count": 12 /* edges */})");
  CHECK(all.max_abs == 1.5);
  CHECK(all.max_rms == 0.25);
  CHECK(all.max_count == 12);
  CHECK_FALSE(limits_in("{}").any());
}

TEST_CASE("limits of a file are in levels or in the unit that it names, and given in the one that is asked for") {
  const test::TemporaryFolder folder;
  const auto read = [&](const std::string& text, CompareUnit unit) {
    std::ofstream(folder / "limits.json") << text;
    return read_limits(folder / "limits.json", unit);
  };
  const std::string plain = R"({"max_abs": 51, "max_rms": 25.5})", levels = R"({"max_abs": 51, "unit": "levels"})",
                    values = R"({"unit": "values", "max_abs": 0.2, "max_count": 4})";
  CHECK(read(plain, CompareUnit::levels).max_abs == 51);
  CHECK(read(plain, CompareUnit::values).max_abs == 0.2);
  CHECK(read(plain, CompareUnit::values).max_rms == 0.1);
  CHECK(read(levels, CompareUnit::levels).max_abs == 51);
  CHECK(read(values, CompareUnit::values).max_abs == 0.2);
  CHECK(read(values, CompareUnit::levels).max_abs == 51);
  CHECK(read(values, CompareUnit::levels).max_count == 4);
}

TEST_CASE("every wrong limit of a file is reported by its place") {
  try {
    limits_in("{\n\"max_abs\": -1,\n\"max_rms\": \"1\",\n\"max_count\": 1.5,\n\"max\": 3}");
    FAIL("read");
  } catch (const InputError& error) {
    REQUIRE(error.faults().size() == 4);
    CHECK(error.faults()[0].line == 2);
    CHECK(error.faults()[0].path == "/max_abs");
    CHECK(error.faults()[1].line == 3);
    CHECK(error.faults()[2].line == 4);
    CHECK(error.faults()[2].expected == "a whole number >= 0");
    CHECK(error.faults()[3].line == 5);
    CHECK(error.faults()[3].found == "an unknown key");
    CHECK(error.faults()[3].expected == "one of max_abs, max_rms, max_count, unit");
  }
  CHECK_THROWS_AS(limits_in("[]"), InputError);
  for (const char* const unit : {"\"level\"", "\"Values\"", "1", "null", "\"levels\", \"unit\": \"levels\""})
    CHECK_THROWS_AS(limits_in("{\"unit\": " + std::string(unit) + "}"), InputError);
  for (const char* const key : {"max_abs", "max_rms", "max_count"}) {
    const std::string member = std::string("\"") + key + "\": ";
    CHECK_THROWS_AS(limits_in("{" + member + "0, " + member + "1}"), InputError);
  }
}
