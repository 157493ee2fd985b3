// Arrays of NumPy, held against NumPy itself where it is installed.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/npy_bytes.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

namespace refraster::test {
namespace {

/// A Python that has NumPy, Debian's before that of the path; empty if there is none.
std::string python_with_numpy() {
  for (const char* const python : {"/usr/bin/python3", "python3"})
    if (std::system((std::string(python) + " -c 'import numpy' >/dev/null 2>&1").c_str()) == 0) return python;
  return "";
}

/// "0 1 2 ...", as Python prints them.
template <class Value>
Image<Value> counted(int width, int height, int channels) {
  Image<Value> image(width, height, channels);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<Value>(i * 3);
  return image;
}

} // namespace

TEST_CASE("NumPy loads what is written: type, shape and values, the top row first") {
  const std::string python = python_with_numpy();
  if (python.empty()) {
    MESSAGE("skipped: there is no python3 with numpy (scripts/setup numpy)");
    return;
  }
  const TemporaryFolder folder;
  const auto loaded = [&](const std::string& expression) {
    const std::string out = folder / "out";
    const std::string script = "import numpy; a = numpy.load('" + folder / "a.npy" + "'); print(" + expression + ")";
    REQUIRE(std::system((python + " -c \"" + script + "\" >" + out).c_str()) == 0);
    return read_file(out, "a text", 1 << 20);
  };
  const char* const facts = "a.dtype.str, a.shape, a.flags.c_contiguous, a[1].ravel().tolist()";
  write_image(folder / "a.npy", counted<std::uint8_t>(2, 2, 3));
  CHECK(loaded(facts) == "|u1 (2, 2, 3) True [18, 21, 24, 27, 30, 33]\n");
  write_image(folder / "a.npy", counted<std::uint16_t>(3, 2, 1));
  CHECK(loaded(facts) == "<u2 (2, 3) True [9, 12, 15]\n");
  write_image(folder / "a.npy", counted<std::uint32_t>(1, 2, 1));
  CHECK(loaded(facts) == "<u4 (2, 1) True [3]\n");
  write_image(folder / "a.npy", counted<float>(1, 2, 2));
  CHECK(loaded(facts) == "<f4 (2, 1, 2) True [6.0, 9.0]\n");
}

TEST_CASE("we load what NumPy saves") {
  const std::string python = python_with_numpy();
  if (python.empty()) {
    MESSAGE("skipped: there is no python3 with numpy (scripts/setup numpy)");
    return;
  }
  const TemporaryFolder folder;
  for (const char* const type : {"uint8", "uint16", "uint32", "float32", "float64"}) {
    CAPTURE(type);
    const std::string script = "import numpy; numpy.save('" + folder / "a.npy" +
                               "', numpy.arange(24, dtype='" + type + "').reshape(2, 4, 3))";
    REQUIRE(std::system((python + " -c \"" + script + "\"").c_str()) == 0);
    const ImageFile image = read_image(folder / "a.npy");
    CHECK(image.values.width == 4);
    CHECK(image.values.height == 2);
    CHECK(image.values.channels == 3);
    for (std::size_t i = 0; i < image.values.values.size(); ++i)
      CHECK(image.values.values[i] == static_cast<float>(i));
  }
}

TEST_CASE("the bytes are those of NumPy 1.24: the values begin at a multiple of 64") {
  const TemporaryFolder folder;
  write_image(folder / "a.npy", counted<std::uint8_t>(2, 1, 3));
  CHECK(read_file(folder / "a.npy", "an image", 1 << 20) ==
        npy_bytes("|u1", "(1, 2, 3)", std::string("\0\3\6\x09\x0c\x0f", 6)));
}

} // namespace refraster::test
