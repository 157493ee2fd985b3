// Every limit of io/file/limits.h: what is said beyond it, with which exit code, and that no memory was taken for it.

#include <refraster/files.h>

#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "tests/support/files/jpeg_bytes.h"
#include "tests/support/files/page_part.h"
#include "tests/support/files/png_bytes.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

/// One step beyond a limit.
struct Beyond {
  const Limit& limit;
  std::vector<test::TestFile> files; // one of a name that ends in .obj, .png … is what `arguments` reads
  Words arguments;
  int exit_code;
  std::string said; // the whole line, without "refraster: "; of wrong usage, its beginning
};

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  result.reserve((text.size() + 1) * count);
  for (std::size_t i = 0; i < count; ++i) result.append(i == 0 ? "" : ",").append(text);
  return result;
}

std::string scene_of(const std::string& point_lights, const std::string& direction_lights, const std::string& objects) {
  return R"({"scene": {"camera": {"position": "0 0 5"}, "point_lights": [)" + point_lights +
         R"(], "direction_lights": [)" + direction_lights + R"(], "objects": [)" + objects + "]}}";
}

std::string object_of(const std::string& shape, const std::string& material_more = "") {
  return "{" + shape +
         R"(, "fragment_function": "phong", "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0,
  "scale": "1 1 1", "material": {"ka": "0 0 0", "kd": "1 1 1", "ks": "0 0 0", "glossiness": 1)" +
         material_more + "}}";
}

/// Triangles that share no vertex.
std::string triangle_soup(std::size_t triangles) {
  std::string text;
  for (std::size_t i = 0; i < triangles; ++i) text += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
  return text;
}

/// Grey, and pixels for one only.
std::string png_of(std::uint32_t width, std::uint32_t height) {
  return test::png_signature + test::png_header(width, height, 8, 0) +
         test::png_chunk("IDAT", test::zlib_stored(std::string(2, '\0'))) + test::png_chunk("IEND", "");
}

/// Progressive, of one pixel, whose only scan is there so many times.
std::string jpeg_of(std::size_t scans) {
  test::JpegBytes jpeg;
  jpeg.frame = 0xc2;
  jpeg.scans = std::vector<test::JpegScan>(scans, {{0}, {{128}}});
  return test::jpeg_bytes(jpeg);
}

/// A file of one pixel with so many channels.
std::string exr_of(int channels) {
  const TemporaryFolder folder;
  std::vector<std::string> names;
  for (int i = 0; i < channels; ++i) names.push_back("c" + std::to_string(i));
  write_image(folder / "i.exr", Image<float>(1, 1, channels), names);
  return text_of(folder / "i.exr");
}

std::vector<Beyond> beyond_each() {
  std::vector<Beyond> list;
  const auto add = [&](const Limit& limit, std::vector<test::TestFile> files, Words arguments, const std::string& said,
                       int exit_code = 3) {
    list.push_back({limit, std::move(files), std::move(arguments), exit_code, said});
  };
  const auto add_scene = [&](const Limit& limit, std::string text, const std::string& said,
                             std::vector<test::TestFile> files = {}) {
    files.push_back({"s.json", std::move(text)});
    add(limit, std::move(files), {"render", "s.json", "-o", "never.png", "--size", "8x8"}, said);
  };
  const auto with_file = [](const std::string& key, const std::string& name) {
    return "\"" + key + "\": \"" + name + "\"";
  };

  add(limit::scene_bytes, {{"s.json", "{", limit::scene_bytes.value + 1}}, {"render", "s.json"},
      "s.json: found 16777217 bytes, expected at most 16777216 bytes");
  add_scene(limit::json_depth, std::string(1 << 20, '['),
            "s.json:1:65: found 65 levels of nesting, expected at most 64 levels");
  add_scene(limit::obj_bytes, scene_of("", "", object_of(with_file("obj_file_path", "m.obj"))),
            "m.obj: found 2147483648 bytes, expected at most 2147483647 bytes",
            {{"m.obj", "v", limit::obj_bytes.value + 1}});
  const std::string of_file =
      "{" + with_file("obj_file_path", "m.obj") +
      R"(, "position": "0 0 0", "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1"})";
  add_scene(limit::mtl_bytes, scene_of("", "", of_file), "m.mtl: found 16777217 bytes, expected at most 16777216 bytes",
            {{"m.obj", "mtllib m.mtl\n" + triangle_soup(1)}, {"m.mtl", "#", limit::mtl_bytes.value + 1}});
  std::string names = triangle_soup(1);
  for (int i = 0; i <= 65536; ++i) names += "usemtl m" + std::to_string(i) + "\n";
  add_scene(limit::materials, scene_of("", "", of_file),
            "m.obj: found 65537 materials, expected at most 65536 materials", {{"m.obj", std::move(names)}});
  add(limit::csv_bytes, {{"t.csv", "#", limit::csv_bytes.value + 1}},
      {"brdf", "eval", "lambert", "--points", "t.csv"},
      "t.csv: found 268435457 bytes, expected at most 268435456 bytes");
  add(limit::image_bytes, {{"i.pfm", "PF", limit::image_bytes.value + 1}}, {"compare", "i.pfm", "i.pfm"},
      "i.pfm: found 8589934593 bytes, expected at most 8589934592 bytes");
  add(limit::image_side, {{"i.png", png_of(65537, 1)}}, {"compare", "i.png", "i.png"},
      "i.png: found 65537 x 1 pixels, expected at most 65536 a side");
  add(limit::image_pixels, {{"i.png", png_of(16384, 16385)}}, {"compare", "i.png", "i.png"},
      "i.png: found 16384 x 16385 pixels, expected at most 268435456 pixels");
  add(limit::image_channels, {{"i.exr", exr_of(65)}}, {"compare", "i.exr", "i.exr"},
      "i.exr: found 65 channels, expected at most 64 channels");
  add(limit::jpeg_scans, {{"i.jpg", jpeg_of(501)}}, {"compare", "i.jpg", "i.jpg"},
      "i.jpg: found 501 scans, expected at most 500 scans");
  add_scene(limit::texture_side,
            scene_of("", "", object_of(R"("mesh": {"cube": {}})", ", " + with_file("texture_file_path", "t.png"))),
            "t.png: found 16385 x 1 pixels, expected at most 16384 texels a side", {{"t.png", png_of(16385, 1)}});
  add_scene(limit::objects, scene_of("", "", repeated("{}", 65537)),
            "s.json:1:100: /scene/objects: found an array of 65537 values, expected at most 65536 values");
  add_scene(limit::lights<PointLight>, scene_of(repeated("{}", 65537), "", ""),
            "s.json:1:61: /scene/point_lights: found an array of 65537 values, expected at most 65536 values");
  add_scene(limit::lights<DirectionLight>, scene_of("", repeated("{}", 65537), ""),
            "s.json:1:85: /scene/direction_lights: found an array of 65537 values, expected at most 65536 values");
  add_scene(limit::vertices, scene_of("", "", repeated(object_of(with_file("obj_file_path", "m.obj")), 8948)),
            "s.json: /scene/objects: found 268440000 vertices, expected at most 268435456 vertices",
            {{"m.obj", triangle_soup(10000)}});
  add_scene(limit::triangles, scene_of("", "", repeated(object_of(R"("mesh": {"plane": {"segments": 4096}})"), 9)),
            "s.json: /scene/objects: found 301989888 triangles, expected at most 268435456 triangles");
  add(limit::frame_side, {}, {"render", "s.json", "--size", "16385x1"},
      "--size: found \"16385x1\", expected WIDTHxHEIGHT, each 1 to 16384", 2);
  add(limit::frame_samples, {}, {"render", "s.json", "--size", "16384x16384", "--samples", "16"},
      "--samples: found 4294967296 samples, expected at most 2147483648 samples", 2);
  add(limit::threads, {}, {"render", "s.json", "--threads", "1025"},
      "--threads: found \"1025\", expected a number in 0..1024", 2);
  return list;
}

/// What a run takes that does nothing.
std::uint64_t idle_bytes(const TemporaryFolder& folder) {
  return run_program(folder.path, {"list", "precisions"}).peak_bytes;
}

} // namespace

TEST_CASE("beyond each limit there is one line that says so, the exit code, and no memory taken") {
  const std::vector<Beyond> list = beyond_each();
  for (const Beyond& beyond : list) {
    const TemporaryFolder folder;
    test::write_files(folder.path, beyond.files);
    const Finished run = run_program(folder.path, beyond.arguments);
    INFO(beyond.limit.what);
    CHECK(run.exit_code == beyond.exit_code);
    if (beyond.exit_code == 3) CHECK(run.err == "refraster: " + beyond.said + "\n");
    else CHECK(run.err.starts_with("refraster: " + beyond.said + "\n"));
    CHECK(run.out.empty());
    // The largest input here that is read has 2.5 MB, of JSON, of which 75 times as much may be taken.
    CHECK(run.peak_bytes < idle_bytes(folder) + 190'000'000);
    CHECK_FALSE(std::filesystem::exists(folder / "never.png"));
  }
}

TEST_CASE("no limit is without a test of what is said beyond it, and the documentation says it too") {
  const std::vector<Beyond> list = beyond_each();
  for (const Limit* const limit : all_limits) {
    INFO(limit->what);
    // refraster gl reads GLSL: tests/system/gl has that one.
    if (limit == &limit::glsl_bytes) continue;
    const auto found = std::find_if(list.begin(), list.end(), [&](const Beyond& b) { return &b.limit == limit; });
    REQUIRE(found != list.end());
    CHECK(found->said.ends_with("expected " + at_most(*limit)));
  }
}

TEST_CASE("docs/limits.md has exactly the table that the program prints") {
  const TemporaryFolder folder;
  CHECK(test::page_part("docs/limits.md", "refraster list limits") == run_program(folder.path, {"list", "limits"}).out);
}
