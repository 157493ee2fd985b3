// Folders of references.

#include <refraster/notes.h>

#include "suite/references/update.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace refraster;
using namespace refraster::suite;

namespace {

namespace fs = std::filesystem;

Reference reference_of(ReferenceKind kind, char digit) {
  return {kind, std::string(64, digit), 64, 36, "0.1.0", "double", "why", "2026-01-01T00:00:00Z", 0.5};
}

} // namespace

TEST_CASE("references are read as they were written") {
  const TemporaryFolder folder;
  const std::map<std::string, Reference> all = {{"a", reference_of(ReferenceKind::image, '1')},
                                                {"b@2x", reference_of(ReferenceKind::digest, '2')}};
  save_text(folder / "refs.json", references_json(all));
  CHECK(References(folder.path).all() == all);
  CHECK(References(folder / "none").all().empty());
}

TEST_CASE("a file of references that is not as it should be is refused with its place") {
  const TemporaryFolder folder;
  for (const char* const wrong :
       {"[]", "{}", R"({"schema": 1, "references": {}})", R"({"schema": 2, "references": {"a": {}}})",
        R"({"schema": 2, "references": {"a": 3}})", R"({"schema": 2, "references": {}, "more": 1})",
        "{\"schema\": 2, \"ref"}) {
    save_text(folder / "refs.json", wrong);
    CHECK_THROWS_AS(References(folder.path), InputError);
  }
}

TEST_CASE("an update counts from the moment that refs.json says so, wherever it is ended") {
  const TemporaryFolder folder;
  const Reference before = reference_of(ReferenceKind::image, '1'), after = reference_of(ReferenceKind::image, '2');
  save_text(folder / "refs.json", references_json({{"a", before}}));
  save_text(folder / "a.png", "old");
  const std::string waiting = folder / waiting_name("a", after.sha256);
  save_text(waiting, "new");
  // Ended before: the old one stands, and what waits is removed by the next.
  CHECK(text_of(References(folder.path).image_of("a")) == "old");
  // Ended behind it: the new one stands, under its other name.
  save_text(folder / "refs.json", references_json({{"a", after}}));
  CHECK(text_of(References(folder.path).image_of("a")) == "new");
  remove_waiting(folder.path, References(folder.path).all());
  CHECK(fs::exists(waiting));
  // To its end.
  save_text(folder / "refs.json", references_json({{"a", before}}));
  UpdatedReference one;
  one.name = "a", one.change = Change::changed, one.before = before, one.now = after;
  store_references(References(folder.path), {one});
  CHECK(text_of(folder / "a.png") == "new");
  CHECK_FALSE(fs::exists(waiting));
  CHECK(References(folder.path).all().at("a") == after);
}

TEST_CASE("a digest is of the size, and of every bit") {
  Image<float> image(2, 3, 3), turned(3, 2, 3);
  const std::string digest = float_image_digest(image);
  CHECK(float_image_digest(turned) != digest);
  image.values.back() = -0.0f;
  CHECK(float_image_digest(image) != digest);
}
