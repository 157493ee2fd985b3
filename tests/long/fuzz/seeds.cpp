// fuzz_seeds FOLDER: the inputs that a fuzz run begins with, FOLDER/<target>/…: small sound files made by our own
// writers, the scenes of the repository, and the malformed inputs of tests/unit/io. image_seeds adds images of other
// writers.

#include <refraster/files.h>
#include <refraster/mesh.h>

#include "io/image/image_formats.h"
#include "tests/support/files/image_clauses.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/png_bytes.h"
#include "verify/device/read_profile.h"
#include "verify/device/shipped_profiles.h"
#include "io/parts/image_part.h"
#include "suite/references/references.h"
#include "suite/results/journal.h"
#include "suite/results/results_folder.h"
#include "verify/device/write_profile.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

namespace {
namespace fs = std::filesystem;
using namespace refraster;

class Seeds {
public:
  explicit Seeds(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& target, const std::string& name, const std::string& bytes) {
    const fs::path path = path_of(target, name);
    std::ofstream(path, std::ios::binary) << bytes;
  }
  std::string path_of(const std::string& target, const std::string& name) const {
    fs::create_directories(folder_ / target);
    return (folder_ / target / name).string();
  }

private:
  fs::path folder_;
};

void add_malformed(Seeds& seeds) {
  using test::Reader;
  constexpr std::uint64_t small = 1 << 16;
  int number = 0;
  for (const test::MalformedInput& input : test::malformed_inputs())
    for (const test::TestFile& file : input.files) {
      const std::string name = "malformed_" + std::to_string(number++);
      if (file.name.ends_with('/') || std::max<std::size_t>(file.content.size(), file.size_bytes) > small) continue;
      if (file.name.ends_with(".json")) seeds.add("scene", name, file.content);
      else if (file.name.ends_with(".obj")) seeds.add("obj", name, file.content);
      else if (input.reader == Reader::merl) seeds.add("merl", name, file.content);
      else if (file.name.ends_with(".png") || file.name.ends_with(".bmp") || file.name.ends_with(".tga"))
        seeds.add("image", name, file.content);
      else seeds.add("float_image", name, file.content);
    }
}

void add_scenes(Seeds& seeds) {
  for (const char* const folder : {"scenes/gallery", "scenes/lecture"})
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(REFRASTER_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".json") continue;
      std::ifstream file(entry.path());
      seeds.add("scene", entry.path().stem(), {std::istreambuf_iterator<char>(file), {}});
    }
  const auto add = [&](const std::string& name, const std::string& from, const std::string& to) {
    seeds.add("scene", name, test::scene_with(from, to));
  };
  add("sphere", "0.5 0.5 0.5", "1 0 1e300");
  for (const char* const shape :
       {R"("cube": {})", R"("plane": {"segments": 2})", R"("torus": {"segments": 5, "rings": 4, "tube_radius": 1.5})",
        R"("knot": {"segments": 30, "rings": 4, "tube_radius": 1e-300})"})
    add(std::string("shape_") + shape[1], R"("sphere": {"segments": 8, "rings": 4})", shape);
  add("mesh", R"("mesh": {"sphere": {"segments": 8, "rings": 4}})", R"("obj_file_path": "m.obj", "cull": "back")");
  for (const char* const filter : {"nearest", "bilinear", "trilinear"})
    add(std::string("texture_") + filter, "\"glossiness\": 8",
        std::string("\"glossiness\": 1e-3, \"texture_file_path\": \"t.png\", \"texture_filter\": \"") + filter + "\"");
  add("camera", "\"0 0 6\"",
      R"("-1e30 2.5e-3 6", "target": [0, 0, 0], "up": "0 1 1", "fov_y": 179.9, "near": 1e-300, "far": 1e300)");
  add("merl", R"("phong")", R"("merl")");
  add("mirrored", R"("scale": "1 1 1")", R"("scale": "-1e20 0 1")");
  add("escapes", R"("rotate_x": 0)", "\"name\": \"\\u00e4\\ud83d\\ude00\\n\\\\\\\"/\xc3\xa4\", /* */ \"rotate_x\": 0");
  seeds.add("limits", "all", R"({"max_abs": 0.5, "max_rms": 1e-3, "max_count": 12})");
  seeds.add("limits", "unit", R"({"unit": "values", "max_abs": 0.5})");
  seeds.add("limits", "unknown", "// a comment\n{\"max_abs\": -1, \"max\": [[]], \"max_count\": 1.5,}");
}

void add_devices(Seeds& seeds) {
  for (const ShippedProfile& profile : shipped_profiles())
    seeds.add("device", std::string(profile.name), std::string(profile.json));
  seeds.add("device", "written", device_profile_json(device_profile("llvmpipe")));
  seeds.add("device", "measured",
            R"({"name": "m", "based_on": "softpipe", "version": 2, "measured": {"vendor": "v", "renderer": "r",
                "version": "4.5", "glsl_version": "4.50", "habits": "h", "probe_version": 1}, "depth": {"format": "unorm16"}})");
  seeds.add("device", "unknown", R"({"name": 1, "based_on": "none", "raster": {"latice": [], "fill_rule": "up"}})");
}

void add_meshes(Seeds& seeds) {
  write_obj(seeds.path_of("obj", "cube"), cube_mesh());
  write_obj(seeds.path_of("obj", "sphere"), sphere_mesh(5, 3));
  const auto add = [&](const std::string& name, const std::string& text) { seeds.add("obj", name, text); };
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  add("plain", square + "f 1 2 3 4\n");
  add("relative", square + "vt 0 0\nvt 1 1\nvn 0 0 1\nf -4/-2/-1 -3/-1/-1 -2//-1\n");
  add("forward", "f 1 2 3\r\n" + square);
  add("groups", "o a\ng b\nusemtl c\n" + square + "s 1\nf 1 2 3\ns off\nf 1 3 4\ns on\nf 2 3 4\nl 1 2\np 1\n");
  add("continued", square + "f 1 2 \\\n3 4 # comment\\\nvn 1 2 \\\r\n 3\r");
  add("numbers", "v +1e-45 -0 .5 1\nv 3.4028235e38 1. 1e-9 0 0 1\nv 1E2 -1e+3 0\nvt 0.5\nvt 1 2 3\nf 1/1 2/2 3\n");
  add("concave", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\nf 5 4 3 2 1\n");
  add("hole", "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 3 3 0\nv 3 6 0\nv 6 6 0\nv 6 3 0\nf 1 2 3 4 1 5 6 7 8 5\n");
  add("crossed", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3 4\nf 1 1 1 1\nf 1 2 1 2 5\n");
  add("unusual", square + "s\nvn nan nan nan\nvt -1.#IND 0\nv inf 0 0\nv 9 9 9 1 0 0\nfo 1// 2// 3//\ns -2147483648\n"
                          "f 1/1/ 3/1/ 4/1/\ns 18446744073709551615\nf 1//1 2 3\nfoo\ncurv 0 1 1 2\ncall a.obj\n");
  add("two_sided", square + "f 1 2 3\nf 1 3 4\nf 3 2 1\nf 4 3 1\n");
  add("box",
      square +
          "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  add("pages", square + "v 1 0 1\nv 1 0 2\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\nf 2 1 6\n");
  add("poles", square + "v 0 0 0\nf 1 5 2 3\nf 1 1 3 4\nf 2 2 2 2\n");
  add("survey", "v 5000000.3 1 0\nv 5000000.8 1 0\nv 5000000.3 2 0\nv 0 0 0\nf 1 2 3\n");
  add("part_textured", square + "vt 0 1\nf 1 2 3\nf 1/1 3/1 4/1\nf 1/1 2 4/1\n");
  std::string comb, face = "f";
  for (int i = 0; i < 40; ++i) {
    comb += "v " + std::to_string(i) + " " + std::to_string(i % 2 * 8) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  add("comb", comb + "v 40 -1 0\nv 0 -1 0\n" + face + " 41 42\n");
}

void add_libraries(Seeds& seeds) {
  const auto add = [&](const std::string& name, const std::string& text) { seeds.add("mtl", name, text); };
  add("plain", "newmtl a\nKa 0.1 0.1 0.1\nKd 0.5 0.4 0.3\nKs 1 1 1\nKe 0 0 0\nNs 96.078431\nNi 1\nd 1\nillum 2\n");
  add("two", "# two\r\nnewmtl a b\r\nKd 1\r\nTr 0.25 # of light\r\nnewmtl c\r\nd -halo 0.5\r\nnewmtl a b\r\nKd 0\r\n");
  add("textures", "newmtl a\nmap_Kd -s 2 2 1 -o 0.5 0 -clamp on my wood.png\nmap_Bump -bm 0.3 -imfchan r a.png\n"
                  "map_d -blendu off -t 1 2 -mm 0 1 -texres 64 d.tga\nnorm -n.png\nrefl -type sphere sky.hdr\n");
  add("physical",
      "newmtl p\nPr 0.4\nPm 1\nmap_Pr r.png\nmap_Pm m.png\nPs 0.1\naniso 0\nmap_Ke e.png\nbump -bm b.png\n");
  add("wrong", "Kd 1 1 1\nnewmtl\nKd 2\nnewmtl a\nKd 1 2\nKd -1 0 0\nKs nan 0 0\nNs 1e999\nillum 2.5\nillum 11\nd\n"
               "map_Kd\nmap_Kd -s\nfoo 1\nKd spectral a.rfl\n\xef\xbb\xbf");
}

void add_images(Seeds& seeds) {
  int number = 0;
  for (const test::ImageClause& clause : test::all_image_clauses()) {
    const ImageFormat* const format = format_with_signature(clause.bytes);
    seeds.add(format && format->values == StoredValues::floats ? "float_image" : "image",
              "clause_" + std::to_string(number++), clause.bytes);
  }
  for (int channels = 1; channels <= 4; ++channels)
    for (const int bits : {8, 16}) {
      std::vector<std::uint16_t> samples;
      for (int i = 0; i < 5 * 3 * channels; ++i) samples.push_back(static_cast<std::uint16_t>(i * 4321));
      seeds.add("image", "png_" + std::to_string(channels) + "_" + std::to_string(bits),
                test::png_bytes(5, 3, channels, bits, samples));
    }
  for (const int channels : {1, 3}) {
    Image<std::uint8_t> integers(9, 7, channels);
    for (std::size_t i = 0; i < integers.values.size(); ++i) integers.values[i] = static_cast<std::uint8_t>(i * i);
    Image<float> floats(9, 2, channels);
    for (std::size_t i = 0; i < floats.values.size(); ++i) floats.values[i] = 0.3f * static_cast<float>(i);
    for (const ImageFormat& format : image_formats) {
      if (!format.writes.contains(channels)) continue;
      const std::string name = "own_" + std::to_string(channels) + "." + std::string(format.extensions[0]);
      if (can_write(format, {ImageValues::uint8, channels})) write_image(seeds.path_of("image", name), integers);
      if (can_write(format, {ImageValues::floats, channels})) write_image(seeds.path_of("float_image", name), floats);
    }
  }
}

void add_measurements(Seeds& seeds) {
  seeds.add("csv", "in_out", "# measured\ntheta_in,theta_out,dphi,r,g,b\n0,10,180,.1,2e-1,3\n10,20,0,nan,-1,inf\n");
  seeds.add("csv", "half", "theta_h;theta_d;phi_d\r\n\"1\"; 2 ;3\r\n");
  seeds.add("csv", "vectors", "in_x in_y in_z out_x out_y out_z\n0 0 1 0.6 0 0.8\n");
  seeds.add("csv", "faults", "a,b\n1\nx,2\n1,2,3\n");
}

void add_tables(Seeds& seeds) {
  using test::bytes_of;
  // As tests/long/fuzz/merl.cpp takes them: a header, then places and values.
  const std::string header = bytes_of(std::int32_t{90}) + bytes_of(std::int32_t{90}) + bytes_of(std::int32_t{180});
  int number = 0;
  for (const double value : {0.5, -1.0, 1e300, std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    seeds.add("merl", "value_" + std::to_string(number++),
              header + bytes_of(std::uint32_t{7}) + bytes_of(value) + bytes_of(std::uint32_t{1458007}) +
                  bytes_of(value));
  seeds.add("merl", "header", header);
}

void add_suites(Seeds& seeds) {
  using namespace suite;
  seeds.add("suite", "all", R"({"references": "refs", "defaults": {"size": [64, 36], "tags": ["a"], "srgb": true},
    "entries": [{"scene": ["a.json", "*.obj"], "name": "n", "action": ["compare", "verify"], "device": "softpipe",
      "size": [[4, 4], [8, 8]], "samples": [1, 16], "precision": ["double", "exact"], "reference": "digest",
      "limits": {"max_abs": 1, "max_rms": 0.5, "max_count": 3, "frame_ms": 2, "fail_on": {"edge": 1}},
      "timeout_seconds": 1.5, "max_memory_mib": 64, "allow_outside": false, "image": "x.png"}]})");
  const Reference reference{ReferenceKind::image, std::string(64, 'a'), 64, 36, "0.1.0", "double", "why", "when", 1.5};
  seeds.add("references", "one", references_json({{"ball", reference}}));
  const test::TemporaryFolder folder;
  prepare_results(folder.path);
  Journal journal(folder.path, {"s.json", {"a", "b"}});
  EntryResult result;
  result.name = "a", result.inputs = {{"x", "y"}}, result.details = {"line"};
  journal.add(result);
  journal.finish();
  std::ifstream file(journal.path(), std::ios::binary);
  seeds.add("journal", "one", {std::istreambuf_iterator<char>(file), {}});
}

void add_parts(Seeds& seeds) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.png.part-2-of-3";
  const Image<std::uint8_t> rgb8(5, 3, 3, 7);
  const Image<float> depth(5, 3, 1, 0.5f);
  write_image_part(path,
                   {.scene = "s.json",
                    .shard = {2, 3},
                    .width = 5,
                    .height = 9,
                    .settings = {{"version", "0.1.0"}, {"bits", "8"}},
                    .images = {{"image", ImageValues::uint8, 3}, {"depth", ImageValues::floats, 1}}},
                   {ImageRows(rgb8), ImageRows(depth)});
  std::ifstream file(path, std::ios::binary);
  seeds.add("part", "one", {std::istreambuf_iterator<char>(file), {}});
}

} // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
    return 2;
  }
  Seeds seeds(words[1]);
  add_suites(seeds);
  add_parts(seeds);
  for (const auto add : {add_malformed, add_scenes, add_devices, add_meshes, add_libraries, add_images, add_measurements,
                         add_tables})
    add(seeds);
}
