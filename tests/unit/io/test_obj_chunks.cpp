// An OBJ file is read in chunks, by several threads: of that, nothing is to be seen in what comes out.

#include "io/mesh/obj/fast_numbers.h"
#include "io/mesh/obj/first_numbers.h"
#include "io/mesh/obj_file.h"
#include "io/mesh/obj_numbers.h"
#include "tests/support/for_all.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace refraster::test {
namespace {

template <class T>
void append_bits(std::string& text, const std::vector<T>& list) {
  text += std::to_string(list.size()) + ":";
  text.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
}

/// All that is known of a text in the end: mesh and notes, or faults.
std::string outcome(const std::string& text, const ObjWork& work) {
  NoteList notes;
  std::string result;
  try {
    const Mesh mesh = mesh_of_obj("m.obj", text, {.notes = &notes, .threads = work.threads}, work.chunk_bytes);
    append_bits(result, mesh.positions), append_bits(result, mesh.normals), append_bits(result, mesh.uvs);
    append_bits(result, mesh.colours), append_bits(result, mesh.triangles);
    for (const TriangleRun& run : mesh.material_runs)
      result += std::to_string(run.first_triangle) + "=" + std::to_string(run.material) + " ";
    for (const MeshMaterial& material : mesh.materials) result += material.name + ";";
    for (const MaterialLibrary& library : mesh.material_libraries)
      result += library.text + "@" + std::to_string(library.line);
    for (const Note& note : notes.notes()) result += "\n" + note.text();
  } catch (const InputError& error) {
    result = error.what();
  }
  return result;
}

void check_same_in_chunks(const std::string& text) {
  CAPTURE(text);
  const std::string expected = outcome(text, {1, text.size() + 1});
  for (const std::size_t chunk_bytes : {1u, 2u, 3u, 5u, 8u, 13u, 21u, 34u, 55u})
    CHECK(outcome(text, {1 + static_cast<int>(chunk_bytes % 3), chunk_bytes}) == expected);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace

TEST_CASE("a chunk begins with a line: it may begin at any, in the middle of what goes on over several lines too") {
  const std::vector<std::string> texts = {
      square + "f 1 2 3 4\n",
      square + "f 1 2 3 4",
      "\xef\xbb\xbf" + square + "f 1 2 3 4 # all\n",
      square + "f 1 \\\n2 \\\r\n3 # a \\\nf \\\n-4 -3 -1\nmtllib a\\\nb.mtl\nusemtl c\nf 1 2 3\n",
      std::string("v 0 0 0\rv 1 0 0\r\rv 1 1 0\r\n\r\nv 0 1 0\rf 1 2 3\r"),
      "f 1/1/2 2/2/1 3/3/2\n" + square + "vt 0 0\nvt 1\nvt 0 1 0\nvn 0 0 1\nf -1/-3/-1 1//2 2\nvn 0 1 0\n",
      square + "s 1\nf 1 2 3\ns off\nf 1 3 4\ns -7\nf 1 2 4\ns 1\nf 2 3 4\nusemtl a\ns 9\nusemtl b\nf 1 2 3\n",
      "v 0 0 0 1 0 0\n" + square + "v 5 5 5 9 0 255 7\nf 1 2 3\nf 4 5 6\n# v 1 2 3\nv nan 0 0\ncurv 1\ncurv 2\n",
      "v 5000000.3 1 0\nv 5000000.8 1 0\nv 5000000.3 2 0\nv 0 0 0\nf 1 2 3\n",
      square + "  f 1 2 3\n\tf 2 3 4\nfoo 1 2\nfo 1 2 4\nvp 1 2\nvx\nf 1 2 3 # 4 5 6\nf 1 2 4\n",
      // Faults.
      square + "f 1 2\nf 1 2 5\nf 0 1 2\nf -1 -2 -5\nv 1 2\nf 1 2 3/\nf 1/ 2 x\nvt\nv 1 2 3 4 5 6 7 8\nf 5 6 7\n",
      square + "v nan 0 0\nf 1 2 5\nv 1e99 0 0\nf 1 2 6\nf 7 1 2\ns many\nf 1 2 9999999999999999999\n",
      std::string("l 1 2\np 1\nv 0 0 0\n"),
      std::string("# nothing\n\n\n"),
      square + std::string("f 1 2 3\n\0f 1 2 3\n", 17),
  };
  for (const std::string& text : texts) check_same_in_chunks(text);
}

TEST_CASE("chunks are as good as the whole for random statements, sound ones and others") {
  for_all(200, [](Random& random) {
    static constexpr const char* statements[] = {
        "v 1 2 3",   "v .5 -1e-3 +2", "v 0 0 1 0.5 0.5 1",   "vt 0.25 1",           "vn 0 0 -1",   "f 1 2 3",
        "f 1 2 3 4", "f -1 -2 -3",    "f 1/1/1 2/1/1 3/1/1", "f 2//-1 3//-1 4//-1", "f 4 3 2 1 5", "s 1",
        "s off",     "s 2",           "usemtl red",          "usemtl blue",         "g a b",       "# note",
        "",          "f 1 2 3 # 4",   "v 1 2\\\n3",          "f 1 \\\n 2 3",        "l 1 2",       "mtllib x.mtl",
        "\tvt 1",    "f 1/1 2/1 3/1", "f 3 2/1 1",           "vn nan 0 0"};
    static constexpr const char* faults[] = {"f 1 2",   "f 1 2 99999", "v 1 2 x", "s on me",
                                             "f 1 0 2", "v inf 1 1",   "f a b c"};
    static constexpr const char* ends[] = {"\n", "\n", "\r\n", "\r"};
    const char* const end = ends[random.below(4)];
    std::string text = square + "v 2 2 2\nvt 0 0\nvn 0 1 0\n";
    const bool is_sound = random.below(3) > 0;
    for (int i = random.below(60); i >= 0; --i) {
      text += !is_sound && random.below(12) == 0 ? faults[random.below(static_cast<int>(std::size(faults)))]
                                                 : statements[random.below(static_cast<int>(std::size(statements)))];
      text += end;
    }
    text += random.below(2) == 0 ? "f 1 2 3" : "f 1 2 3\n";
    check_same_in_chunks(text);
  });
}

TEST_CASE("a mesh has the same bits whatever the number of threads") {
  std::string text;
  constexpr int n = 90; // a hilly field, of triangles, quads and more
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      std::ostringstream line;
      line << "v " << i << ' ' << std::sin(i * 0.3) * std::cos(j * i * 0.02) << ' ' << j << '\n';
      text += line.str();
    }
  const auto at = [](int i, int j) { return " " + std::to_string(i * n + j + 1); };
  for (int i = 0; i + 1 < n; ++i)
    for (int j = 0; j + 2 < n; ++j) {
      if (j % 3 == 0) text += "f" + at(i, j) + at(i, j + 1) + at(i + 1, j) + "\n";
      if (j % 3 == 1) text += "f" + at(i, j) + at(i, j + 1) + at(i + 1, j + 1) + at(i + 1, j) + "\n";
      if (j % 3 == 2) text += "f" + at(i, j) + at(i, j + 1) + at(i, j + 2) + at(i + 1, j + 1) + at(i + 1, j) + "\n";
    }
  const std::string expected = outcome(text, {1, 0});
  for (const int threads : {2, 3, 7}) CHECK(outcome(text, {threads, 0}) == expected);
  CHECK(outcome("s 1\n" + text, {3, 0}) == outcome("s 1\n" + text, {1, 0}));
}

TEST_CASE("what is equal is numbered in the order in which it first appears, by any number of threads") {
  constexpr std::size_t count = 200'000; // several blocks
  Random random(7);
  std::vector<std::int64_t> firsts; // of what each i is equal to; -1: it has no number
  std::vector<std::int32_t> expected;
  std::vector<std::size_t> expected_places;
  for (std::size_t i = 0; i < count; ++i) {
    const auto other = static_cast<std::size_t>(random.below(static_cast<int>(i) + 1));
    const int kind = random.below(4);
    firsts.push_back(kind == 0 ? -1
                     : kind == 1 || firsts.empty() || firsts[std::min(other, i - 1)] < 0
                         ? static_cast<std::int64_t>(i)
                         : firsts[std::min(other, i - 1)]);
    const std::int64_t first = firsts.back();
    if (first == static_cast<std::int64_t>(i)) expected_places.push_back(i);
    expected.push_back(first < 0                               ? -1
                       : first == static_cast<std::int64_t>(i) ? static_cast<std::int32_t>(expected_places.size()) - 1
                                                               : expected[static_cast<std::size_t>(first)]);
  }
  for (const int threads : {1, 2, 3, 7}) {
    std::vector<std::int32_t> numbers(count);
    std::vector<std::size_t> places(count);
    const std::uint32_t found = number_firsts(
        threads, count, [&](std::size_t i) { return firsts[i]; }, numbers.data(),
        [&](std::size_t i, std::uint32_t number) { places[number] = i; });
    places.resize(found);
    CHECK(places == expected_places);
    CHECK(numbers == expected);
  }
}

TEST_CASE("numbers that are read in one go are those that the careful reader reads") {
  int taken = 0;
  const auto check = [&taken](const std::string& word) {
    float fast = 0, careful = 0;
    const char* const begin = word.c_str();
    const char* const end = fast_float(begin, begin + word.size(), fast);
    // Of a text that goes on digits are read several at a time; the end of one may come anywhere.
    const std::string longer = word + " 123456789 123456789";
    float within = 0;
    const char* const end_within = fast_float(longer.c_str(), longer.c_str() + longer.size(), within);
    CAPTURE(word);
    CHECK((end ? end - begin : -1) == (end_within ? end_within - longer.c_str() : -1));
    if (!end || end != begin + word.size()) return;
    ++taken;
    CHECK(std::bit_cast<std::uint32_t>(fast) == std::bit_cast<std::uint32_t>(within));
    CHECK(read_coordinate(word, careful) == NumberText::good);
    CHECK(std::bit_cast<std::uint32_t>(fast) == std::bit_cast<std::uint32_t>(careful));
  };
  for (const char* const word : {"0", "-0", "+.5", "1.", "1e5", "-2E-3", "3.4028235e38", "1e-45", "1.1754943e-38", "e5",
                                 ".", "1e", "--1", "+-1", "16777217", "0.000000000000000000001", "9007199254740993"})
    check(word);
  for_all(20000, [&](Random& random) {
    // A float, and the middle between it and the next, with more digits than either needs: 1 in the last place decides.
    const auto bits = static_cast<std::uint32_t>(random.below(0x7f000000));
    const double low = static_cast<double>(std::bit_cast<float>(bits));
    const double middle = low + (static_cast<double>(std::bit_cast<float>(bits + 1)) - low) / 2;
    for (const double value : {low, middle, std::nextafter(middle, 0.0), std::nextafter(middle, HUGE_VAL)}) {
      char word[64];
      std::snprintf(word, sizeof word, random.below(2) == 0 ? "%.*e" : "%.*g", 5 + random.below(14), value);
      check(word);
    }
    const double ordinary = (random.below(2000000) - 1000000) / 1e4 + random.below(1000) / 1e9;
    char word[64];
    std::snprintf(word, sizeof word, "%.*f", random.below(12), ordinary);
    check(word);
  });
  CHECK(taken > 20000);
}

} // namespace refraster::test
