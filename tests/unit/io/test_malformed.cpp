#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

namespace refraster::test {
namespace {

/// What is said of the input, with names as seen from the folder; "" if nothing is.
std::string complaint(const TemporaryFolder& folder, const MalformedInput& input) {
  const std::string path = folder / input.input, prefix = folder / "";
  try {
    switch (input.reader) {
    case Reader::scene:
      read_scene(path);
      break;
    case Reader::obj:
      read_obj(path);
      break;
    case Reader::image:
      read_image(path);
      break;
    case Reader::texture:
      read_texture(path);
      break;
    case Reader::merl:
      read_merl(path);
      break;
    }
  } catch (const InputError& error) {
    std::string text = error.what();
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }
  return "";
}

} // namespace

TEST_CASE("every malformed input gets one clear line: file, place, found, expected") {
  CHECK(malformed_inputs().size() >= 45);
  for (const MalformedInput& input : malformed_inputs()) {
    CAPTURE(input.name);
    const TemporaryFolder folder;
    write_files(folder.path, input.files);
    CHECK(complaint(folder, input) == input.expected);
  }
}

TEST_CASE("the scene that malformed ones are made from is sound") {
  const TemporaryFolder folder;
  write_files(folder.path, {{"s.json", scene_with("0.5 0.5 0.5", "0 0 0")}});
  CHECK_NOTHROW(read_scene(folder / "s.json"));
}

} // namespace refraster::test
