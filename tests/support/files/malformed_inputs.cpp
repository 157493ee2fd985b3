#include "tests/support/files/malformed_inputs.h"

#include <refraster/files.h>

#include "io/image/image_formats.h"
#include "io/json/json.h"
#include "tests/support/files/malformed_images.h"
#include "tests/support/files/npy_bytes.h"
#include "tests/support/files/png_bytes.h"
#include "tests/support/shading/each_fragment_function.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace refraster::test {
namespace {

using List = std::vector<MalformedInput>;
using namespace std::string_literals;

// Files as such: the same for every format.
void add_files(List& list) {
  list.push_back({"no such scene", Reader::scene, "s.json", {}, "s.json: found no such file, expected a scene file"});
  list.push_back({"a folder for a scene",
                  Reader::scene,
                  "s.json",
                  {{"s.json/", ""}},
                  "s.json: found a folder, expected a scene file"});
  list.push_back({"an empty scene",
                  Reader::scene,
                  "s.json",
                  {{"s.json", ""}},
                  "s.json: found an empty file, expected a scene file"});
  list.push_back({"a huge scene",
                  Reader::scene,
                  "s.json",
                  {{"s.json", "{", JsonDocument::max_bytes + 1}},
                  "s.json: found 16777217 bytes, expected at most 16777216 bytes"});
  list.push_back({"no such OBJ", Reader::obj, "m.obj", {}, "m.obj: found no such file, expected an OBJ file"});
  list.push_back({"a huge OBJ",
                  Reader::obj,
                  "m.obj",
                  {{"m.obj", "v", std::uint64_t{1} << 32}},
                  "m.obj: found 4294967296 bytes, expected at most 2147483647 bytes"});
  list.push_back(
      {"an empty image", Reader::image, "i.png", {{"i.png", ""}}, "i.png: found an empty file, expected an image"});
  list.push_back({"a folder for a table",
                  Reader::merl,
                  "t.binary",
                  {{"t.binary/", ""}},
                  "t.binary: found a folder, expected a MERL table"});
}

void add_json(List& list) {
  const auto add = [&](const std::string& name, const std::string& text, const std::string& expected) {
    list.push_back({name, Reader::scene, "s.json", {{"s.json", text}}, expected});
  };
  add("a scene cut short",
      "{\"scene\": {\n  \"camera\": ", "s.json:2:13: found the end of the file, expected a JSON value");
  add("a scene that is a list", "[1]", "s.json:1:1: found an array of 1 value, expected an object with the key scene");
  add("two values", "{\"scene\": 1} {}", "s.json:1:14: found \"{\", expected the end of the file");
  add("a missing colon", "{\"scene\" {}}", "s.json:1:10: found \"{\", expected ':'");
  add("a missing comma", "{\"scene\": 1 \"a\": 2}", "s.json:1:13: found \"\"a\"\", expected ',' or '}'");
  add("a missing comma in a list", "[1 2]", "s.json:1:4: found \"2\", expected ',' or ']'");
  add("a key without quotes", "{scene: 1}", "s.json:1:2: found \"scene\", expected a key in quotes, or '}'");
  add("a string that does not end", "{\"scene",
      "s.json:1:8: found the end of the file, expected a string that ends in '\"'");
  add("a string over two lines", "{\"sc\nene\": 1}",
      "s.json:1:5: found a line end, expected a string that ends in '\"'");
  add("an unknown escape", "{\"sc\\ene\": 1}",
      "s.json:1:5: found \"\\ene\"\", expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u");
  add("a byte that is not UTF-8", "{\"sc\xff\": 1}", "s.json:1:5: found \"\xff\"\", expected UTF-8");
  add("NaN", "{\"scene\": NaN}", "s.json:1:11: found \"NaN\", expected a JSON value");
  add("a number beyond double", "{\"scene\": 1e999}", "s.json:1:11: found \"1e999\", expected a number below 1.8e308");
  add("a comment that does not end", "{\"scene\": 1} /* x",
      "s.json:1:18: found the end of the file, expected a comment: //, or /* closed by */");
  add("a zero byte", "{\"scene\"\0: 1}"s, "s.json:1:9: found a zero byte, expected text");
  add("nesting too deep", std::string(100000, '['),
      "s.json:1:65: found 65 levels of nesting, expected at most 64 levels");
}

/// "a" or "b" or "c": every fragment function.
std::string function_names() {
  std::string text;
  for (const FragmentFunction& function : each_fragment_function())
    text += (text.empty() ? "\"" : " or \"") + std::string(name_of(function)) + '"';
  return text;
}

/// a, b, c: the names of files that stand for one.
std::string shader_stems() {
  std::string text;
  const auto append = [&](const auto& function) {
    for (const std::string_view stem : function.shader_stems) text += (text.empty() ? "" : ", ") + std::string(stem);
  };
  for (const FragmentFunction& function : each_fragment_function()) std::visit(append, function);
  return text;
}

/// a, b, c: the parameters of all fragment functions, each once.
std::string parameter_names() {
  std::vector<std::string_view> names;
  const auto append = [&]<class Function>(const Function& function) {
    Function::fields(function, [&](std::string_view name, const auto&, const Range&, std::string_view) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    });
  };
  for (const FragmentFunction& function : each_fragment_function()) std::visit(append, function);
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

void add_scenes(List& list) {
  const auto add = [&](const std::string& name, const std::string& from, const std::string& to,
                       const std::string& expected) {
    list.push_back({name, Reader::scene, "s.json", {{"s.json", scene_with(from, to)}}, expected});
  };
  list.push_back({"no scene",
                  Reader::scene,
                  "s.json",
                  {{"s.json", "{}"}},
                  "s.json:1:1: /scene: found nothing, expected an object"});
  add("an unknown key", "\"glossiness\"", "\"shininess\": 1, \"glossiness\"",
      "s.json:9:69: /scene/objects/0/material/shininess: found an unknown key, expected one of " + parameter_names() +
          ", brdf_file_path, texture_file_path, texture_filter, diffuse_map, specular_map, emissive_map, opacity_map, "
          "normal_map, bump_map, roughness_map, metallic_map, emissive, opacity_threshold, normal_scale, bump_scale");
  add("a missing key", "\"ka\": \"0 0 0\", ", "",
      "s.json:9:17: /scene/objects/0/material/ka: found nothing, expected three numbers >= 0");
  add("a key twice", "\"rotate_y\": 0", "\"rotate_x\": 1, \"rotate_y\": 0",
      "s.json:8:41: /scene/objects/0/rotate_x: found the key a second time, expected each key once");
  add("a string for a number", "\"glossiness\": 8", "\"glossiness\": \"8\"",
      "s.json:9:83: /scene/objects/0/material/glossiness: found \"8\", expected a number >= 0");
  add("a string with quotes for a number", "\"glossiness\": 8", R"("glossiness": "a\"b\\")",
      "s.json:9:83: /scene/objects/0/material/glossiness: found \"a\"b\\\", expected a number >= 0");
  add("a number below its range", "\"glossiness\": 8", "\"glossiness\": -3",
      "s.json:9:83: /scene/objects/0/material/glossiness: found -3, expected a number >= 0");
  add("a vector of two numbers", "\"0 0 6\"", "\"0 0\"",
      "s.json:2:26: /scene/camera/position: found \"0 0\", expected three numbers");
  add("a vector of four numbers", "\"0 0 6\"", "[0, 0, 6, 1]",
      "s.json:2:26: /scene/camera/position: found an array of 4 values, expected three numbers");
  add("a vector that is not finite", "\"0 0 6\"", "\"0 nan 6\"",
      "s.json:2:26: /scene/camera/position: found \"0 nan 6\", expected three numbers");
  add("a vector beyond double", "\"0 0 6\"", "\"0 0 6e400\"",
      "s.json:2:26: /scene/camera/position: found \"0 0 6e400\", expected three numbers");
  add("a negative colour", "\"0.5 0.5 0.5\"", "\"0.5 -0.5 0.5\"",
      "s.json:9:39: /scene/objects/0/material/kd: found \"0.5 -0.5 0.5\", expected three numbers >= 0");
  add("a light without direction", "\"0 0 -1\"", "\"0 -0.0 0e7\"",
      "s.json:4:38: /scene/direction_lights/0/direction: found a vector of length 0, expected a direction");
  add("a target at the camera", "\"0 0 6\"", "\"0 0 6\", \"target\": \"0 0 6\"",
      "s.json:2:45: /scene/camera/target: found the camera's position, expected a target away from the position");
  add("no target can be judged without a position", "\"0 0 6\"", "\"six\", \"target\": \"0 0 0\"",
      "s.json:2:26: /scene/camera/position: found \"six\", expected three numbers");
  add("up along the line of sight", "\"0 0 6\"", "\"0 0 6\", \"up\": \"0 0 2\"",
      "s.json:2:41: /scene/camera/up: found an up vector along the line of sight, expected up not parallel to target - "
      "position");
  add("up of no length", "\"0 0 6\"", "\"0 0 6\", \"up\": \"0 0 0\"",
      "s.json:2:41: /scene/camera/up: found a vector of length 0, expected a direction");
  add("looking straight down", "\"0 0 6\"", "\"0 9 6\", \"target\": \"0 0 6\"",
      "s.json:2:45: /scene/camera/target: found an up vector along the line of sight, expected up not parallel to "
      "target - position");
  add("near beyond far", "\"0 0 6\"", "\"0 0 6\", \"near\": 10, \"far\": 10",
      "s.json:2:54: /scene/camera/far: found a far plane that is not beyond the near one, expected near < far");
  add("near at the eye", "\"0 0 6\"", "\"0 0 6\", \"near\": 0",
      "s.json:2:43: /scene/camera/near: found 0, expected a number > 0");
  add("a view of 180 degrees", "\"0 0 6\"", "\"0 0 6\", \"fov_y\": 180",
      "s.json:2:44: /scene/camera/fov_y: found 180, expected a number > 0 and < 180");
  add("an object for a list", "[{\"direction\": \"0 0 -1\", \"radiance\": \"1 1 1\"}]", "{}",
      "s.json:4:23: /scene/direction_lights: found an object, expected an array");
  add("a number in a list of objects", "[{\"direction\": \"0 0 -1\", \"radiance\": \"1 1 1\"}]", "[7]",
      "s.json:4:24: /scene/direction_lights/0: found 7, expected an object");
  add("an unknown fragment function", "\"phong\"", "\"Phong\"",
      "s.json:7:26: /scene/objects/0/fragment_function: found \"Phong\", expected " + function_names());
  add("an unknown shader", "\"fragment_function\": \"phong\"",
      "\"vertex_shader_file_path\": \"v\", \"fragment_shader_file_path\": \"toon.glsl\"",
      "s.json:7:66: /scene/objects/0/fragment_shader_file_path: found \"toon.glsl\", expected a file with the stem " +
          shader_stems() + "; or the key fragment_function");
  add("no vertex shader", "\"fragment_function\": \"phong\"", "\"fragment_shader_file_path\": \"phong_fs.glsl\"",
      "s.json:5:15: /scene/objects/0/vertex_shader_file_path: found nothing, expected the path of a file");
  add("both a mesh and a file", "\"fragment_function\"", "\"obj_file_path\": \"m.obj\", \"fragment_function\"",
      "s.json:6:13: /scene/objects/0/mesh: found both obj_file_path and mesh, expected one of the two");
  add("neither a mesh nor a file", "\"mesh\": {\"sphere\": {\"segments\": 8, \"rings\": 4}},", "",
      "s.json:5:15: /scene/objects/0/obj_file_path: found nothing, expected the path of a file, or the key mesh");
  add("an unknown shape", "\"sphere\"", "\"ball\"",
      "s.json:6:14: /scene/objects/0/mesh: found \"ball\", expected an object with one key: sphere or cube or plane or "
      "torus or knot");
  add("a sphere too fine", "\"segments\": 8", "\"segments\": 1e9",
      "s.json:6:37: /scene/objects/0/mesh/sphere/segments: found 1e9, expected a whole number from 3 to 4096");
  add("half a ring", "\"rings\": 4", "\"rings\": 4.5",
      "s.json:6:49: /scene/objects/0/mesh/sphere/rings: found 4.5, expected a whole number from 2 to 4096");
  const std::string mesh = "\"mesh\": {\"sphere\": {\"segments\": 8, \"rings\": 4}}";
  const std::string wanted = mesh + ", \"normals\": ",
                    beside = "found normals beside mesh, expected obj_file_path: a shape has its own";
  add("normals of a shape", mesh + ",", wanted + "\"flat\",", "s.json:6:65: /scene/objects/0/normals: " + beside);
  add("unknown normals", mesh + ",", wanted + "\"auto\",",
      "s.json:6:65: /scene/objects/0/normals: found \"auto\", expected \"file\" or \"smooth\" or \"flat\" or an object "
      "with crease_degrees\n"
      "s.json:6:65: /scene/objects/0/normals: " +
          beside);
  add("an object without a crease", mesh + ",", wanted + "{},",
      "s.json:6:65: /scene/objects/0/normals/crease_degrees: found nothing, expected a number from 0 to 180\n"
      "s.json:6:65: /scene/objects/0/normals: " +
          beside);
  add("a crease beyond half a turn", mesh + ",", wanted + "{\"crease_degrees\": 181},",
      "s.json:6:65: /scene/objects/0/normals: " + beside +
          "\n"
          "s.json:6:84: /scene/objects/0/normals/crease_degrees: found 181, expected a number from 0 to 180");
  add("an unknown filter", "\"glossiness\": 8", "\"glossiness\": 8, \"texture_filter\": \"cubic\"",
      "s.json:9:104: /scene/objects/0/material/texture_filter: found \"cubic\", expected \"nearest\" or \"bilinear\" "
      "or \"trilinear\"");
  add("a string for true", "\"glossiness\": 8", "\"glossiness\": 8, \"specular_gate\": \"true\"",
      "s.json:9:103: /scene/objects/0/material/specular_gate: found \"true\", expected false or true");
  add("merl without a table", "\"phong\"", "\"merl\"",
      "s.json:9:17: /scene/objects/0/material/brdf_file_path: found nothing, expected the path of a file");
  add("a texture that is not there", "\"glossiness\": 8", "\"glossiness\": 8, \"texture_file_path\": \"no.png\"",
      "s.json:9:107: /scene/objects/0/material/texture_file_path: found no such file, no.png, expected an image");
  list.push_back({"a fault in a mesh of a scene",
                  Reader::scene,
                  "s.json",
                  {{"s.json", scene_with("\"mesh\": {\"sphere\": {\"segments\": 8, \"rings\": 4}}",
                                         "\"obj_file_path\": \"m.obj\"")},
                   {"m.obj", "v 0 0\n"}},
                  "m.obj:1:1: found 2 numbers, expected 3 to 7 numbers"});
  add("several faults, in the order of the file", "\"0 0 6\"},\n  \"point_lights\": [{",
      "7},\n  \"point_lights\": [{\"x\": 1, ",
      "s.json:2:26: /scene/camera/position: found 7, expected three numbers\n"
      "s.json:3:21: /scene/point_lights/0/x: found an unknown key, expected one of position, radiance, constant, "
      "linear, quadratic, shadow, space");
}

/// ASCII with a zero byte before (1) or behind (0) each character.
std::string utf_16(const std::string& ascii, std::size_t zeros_before) {
  std::string bytes(2 * ascii.size(), '\0');
  for (std::size_t i = 0; i < ascii.size(); ++i) bytes[2 * i + zeros_before] = ascii[i];
  return bytes;
}

void add_obj(List& list) {
  const auto add = [&](const std::string& name, const std::string& text, const std::string& expected) {
    list.push_back({name, Reader::obj, "m.obj", {{"m.obj", text}}, expected});
  };
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const std::string a_face = ", expected at least one face (a statement f)";
  add("no face", square, "m.obj: found no face, only vertices" + a_face);
  add("only points", square + "p 1 2 3\np 4\n", "m.obj: found only points: they are not drawn" + a_face);
  add("only lines", square + "l 1 2 3\n", "m.obj: found only lines: they are not drawn" + a_face);
  add("only points and lines", square + "l 1 2 3\np 1\n",
      "m.obj: found only points and lines: they are not drawn" + a_face);
  add("only a free-form surface", square + "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 4 3\nend\n",
      "m.obj: found only free-form curves or surfaces: they are not drawn" + a_face);
  add("text of another kind", "solid cube\nfacet normal 0 0 1\n", "m.obj: found no statement v or f" + a_face);
  add("two coordinates", "v 0 0 0\nv 1 0\nv 1 1 1\nf 1 2 3\n", "m.obj:2:1: found 2 numbers, expected 3 to 7 numbers");
  add("a coordinate that is a word", "v 0 zero 0\nv 1 0 0\nv 1 1 1\nf 1 2 3\n",
      "m.obj:1:5: found \"zero\", expected a finite number in single precision");
  add("a coordinate that is nan", "v 0 0 0\nv 1 nan 0\nv 1 1 1\nf 1 2 3\n",
      "m.obj:2:5: found \"nan\", expected a finite number in single precision");
  add("a coordinate that is nan, of a face before it", "f 1 2 -2\nv 0 0 0\nv 1 -1.#IND 0\nf 1 2 2\n",
      "m.obj:1:7: found v index -2, expected no v index, since none is given\n"
      "m.obj:3:5: found \"-1.#IND\", expected a finite number in single precision");
  add("a colour that is a word", "v 0 0 0 red 0 0\nv 1 0 0\nv 1 1 1\nf 1 2 3\n",
      "m.obj:1:9: found \"red\", expected a finite number in single precision");
  add("a coordinate beyond float", "v 0 0 1e39\nv 1 0 0\nv 1 1 1\nf 1 2 3\n",
      "m.obj:1:7: found \"1e39\", expected a finite number in single precision");
  add("a normal of two numbers", square + "vn 1 0\nf 1 2 3\n", "m.obj:5:1: found 2 numbers, expected 3 numbers");
  add("an empty vt", square + "vt\nf 1 2 3\n", "m.obj:5:1: found 0 numbers, expected 1 to 3 numbers");
  add("an index beyond the last", square + "f 1 2 5\n", "m.obj:5:7: found v index 5, expected 1 to 4 or -1 to -4");
  add("an index before the first", square + "f 1 2 -5\n", "m.obj:5:7: found v index -5, expected 1 to 4 or -1 to -4");
  add("index 0", square + "f 0 1 2\n", "m.obj:5:3: found v index 0, expected 1 to 4 or -1 to -4");
  add("an index beyond int64", square + "f 1 2 99999999999999999999\n",
      "m.obj:5:7: found v index 99999999999999999999, expected 1 to 4 or -1 to -4");
  add("a normal that is not there", square + "f 1//1 2//1 3//1\n",
      "m.obj:5:6: found vn index 1, expected no vn index, since none is given\n"
      "m.obj:5:11: found vn index 1, expected no vn index, since none is given\n"
      "m.obj:5:16: found vn index 1, expected no vn index, since none is given");
  add("a face of two corners", square + "f 1 2\n",
      "m.obj:5:1: found a face with 2 corners, expected at least 3 corners");
  add("a corner that is a word", square + "f 1 2 x\n", "m.obj:5:7: found \"x\", expected v, v/vt, v//vn or v/vt/vn");
  add("a corner of four indices", square + "vt 0 0\nvn 0 0 1\nf 1 2 3/1/1/1\n",
      "m.obj:7:7: found \"3/1/1/1\", expected v, v/vt, v//vn or v/vt/vn");
  add("a corner that ends in three slashes", square + "vt 0 0\nf 1/1 2/1 3///\n",
      "m.obj:6:11: found \"3///\", expected v, v/vt, v//vn or v/vt/vn");
  add("a corner of a slash", square + "f 1 2 /\n", "m.obj:5:7: found \"/\", expected v, v/vt, v//vn or v/vt/vn");
  add("an unknown smoothing group", square + "s smooth\nf 1 2 3\n",
      "m.obj:5:3: found \"smooth\", expected off, or the number of a smoothing group");
  add("a smoothing group beyond 64 bits", square + "s 18446744073709551616\nf 1 2 3\n",
      "m.obj:5:3: found \"18446744073709551616\", expected off, or the number of a smoothing group");
  add("a negative smoothing group beyond 64 bits", square + "s -9223372036854775809\nf 1 2 3\n",
      "m.obj:5:3: found \"-9223372036854775809\", expected off, or the number of a smoothing group");
  add("a fault behind a continued line", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 \\\n  2 7\n",
      "m.obj:5:5: found v index 7, expected 1 to 3 or -1 to -3");
  add("a text with a zero byte", square + square + "v 0 0 \0 0\n"s, "m.obj:9:7: found a zero byte, expected text");
  const std::string text = ", expected an OBJ file: text in ASCII or UTF-8";
  add("a binary file", "glTF\2\0\0\0\x40\3\0\0v 0 0 0\n"s, "m.obj: found a binary file" + text);
  std::string packed; // as bytes of a compressed file: any of 256, equally often
  for (int i = 0; i < 1024; ++i) packed += static_cast<char>(i * 167 % 256);
  add("a compressed file", "\x1f\x8b" + packed, "m.obj: found a binary file" + text);
  add("UTF-16, little-endian", "\xff\xfe" + utf_16(square, 0), "m.obj: found UTF-16 text" + text);
  add("UTF-16, big-endian", "\xfe\xff" + utf_16(square, 1), "m.obj: found UTF-16 text" + text);
  add("UTF-16 without a mark", utf_16(square, 0), "m.obj: found UTF-16 text" + text);
  add("big-endian UTF-16 without a mark", utf_16(square, 1), "m.obj: found UTF-16 text" + text);
  add("UTF-32", "\xff\xfe\0\0v\0\0\0"s, "m.obj: found UTF-32 text" + text);
}

// A PNG of 8-bit RGB with a size of its own, and no pixels: only the size counts here.
std::string png_without_pixels(std::uint32_t width, std::uint32_t height) {
  return png_signature + png_header(width, height, 8, 2) + png_chunk("IDAT", "");
}

void add_images(List& list) {
  const auto add = [&](const std::string& name, const std::string& input, const std::string& bytes,
                       const std::string& expected) {
    list.push_back({name, Reader::image, input, {{input, bytes}}, expected});
  };
  add("a text for an image", "i.png", "not an image\n",
      "i.png: found an unknown image type, expected " + readable_formats());
  add("a PNG cut short", "i.png", png_without_pixels(4, 4), "i.png: found a truncated image, expected a whole one");
  add("a PNG of a huge size", "i.png", png_without_pixels(60000, 60000),
      "i.png: found 60000 x 60000 pixels, expected at most 268435456 pixels");
  add("a PNG larger than its file", "i.png", png_without_pixels(16000, 16000),
      "i.png: found 16000 x 16000 pixels, expected as many as a file of 45 bytes can hold");
  add("a PFM without a size", "i.pfm", "PF\nwide 2\n-1\n", "i.pfm: width: found \"wide\", expected a number of pixels");
  add("a PFM of scale 0", "i.pfm", "PF\n1 1\n0\n", "i.pfm: scale: found \"0\", expected a number that is not 0");
  add("a PFM cut short", "i.pfm", "Pf\n2 2\n-1\n123456789012", "i.pfm: pixels: found 12 bytes, expected 16 bytes");
  add("a PFM of a huge size", "i.pfm", "PF\n4294967295 4294967295\n-1\n",
      "i.pfm: found 4294967295 x 4294967295 pixels, expected at most 65536 a side");
  add("a PFM of no pixels", "i.pfm", "PF\n0 5\n-1\n", "i.pfm: found 0 x 5 pixels, expected at least 1 x 1");
  add("an array of NumPy cut short", "i.npy", npy_bytes("<f4", "(2, 2)", "12345678"),
      "i.npy: values: found 8 bytes, expected 16 bytes");
  add("an array of NumPy larger than its file", "i.npy", npy_bytes("|u1", "(16000, 16000)", ""),
      "i.npy: found 16000 x 16000 pixels, expected as many as a file of 128 bytes can hold");
  add("an HDR cut short", "i.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n\x80\x80\x80\x80",
      "i.hdr: found a truncated image, expected a whole one");
  list.push_back({"a float texture",
                  Reader::texture,
                  "i.pfm",
                  {{"i.pfm", "Pf\n1 1\n-1\n0000"}},
                  "i.pfm: found an image of floating-point numbers, expected 8 or 16 bits a channel"});
}

void add_merl(List& list) {
  const std::string sound = bytes_of(std::int32_t{90}) + bytes_of(std::int32_t{90}) + bytes_of(std::int32_t{180});
  const auto add = [&](const std::string& name, TestFile file, const std::string& expected) {
    list.push_back({name, Reader::merl, file.name, {file}, expected});
  };
  add("a table of 4 bytes", {"t.binary", "1234"}, "t.binary: found 4 bytes, expected 34992012 bytes");
  add("a table cut short", {"t.binary", sound, 34992011}, "t.binary: found 34992011 bytes, expected 34992012 bytes");
  add("a table too long", {"t.binary", sound, 34992013}, "t.binary: found 34992013 bytes, expected 34992012 bytes");
  add("wrong dimensions", {"t.binary", sound.substr(0, 8) + bytes_of(std::int32_t{360}), 34992012},
      "t.binary: dimensions: found 90 x 90 x 360, expected 90 x 90 x 180");
  add("huge dimensions", {"t.binary", std::string(12, '\x7f')},
      "t.binary: dimensions: found 2139062143 x 2139062143 x 2139062143, expected 90 x 90 x 180");
  add("a value that is not a number",
      {"t.binary", sound, 34992012, 12 + 8 * (1458000 + 180 * 90 * 3 + 180 * 2 + 1),
       bytes_of(std::numeric_limits<double>::quiet_NaN())},
      "t.binary: g[3][2][1]: found nan, expected a finite number");
  add("an infinite value", {"t.binary", sound, 34992012, 34992004, bytes_of(-std::numeric_limits<double>::infinity())},
      "t.binary: b[89][89][179]: found infinity, expected a finite number");
}

} // namespace

const std::vector<MalformedInput>& malformed_inputs() {
  static const List list = [] {
    List inputs;
    for (const auto add : {add_files, add_json, add_scenes, add_obj, add_images, add_merl}) add(inputs);
    for (MalformedInput& image : malformed_images()) inputs.push_back(std::move(image));
    return inputs;
  }();
  return list;
}

} // namespace refraster::test
