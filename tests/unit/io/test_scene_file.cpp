#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/scene/scene_markdown.h"
#include "io/scene/shape_mesh.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/page_part.h"
#include "tests/support/files/png_bytes.h"

#include <doctest/doctest.h>

namespace refraster::test {
namespace {

/// What is said first of what is refused; "" of what is read.
std::string first_fault(auto&& read) {
  try {
    read();
  } catch (const InputError& error) {
    const InputFault& fault = error.faults().at(0);
    return fault.path + ": " + fault.found + ", " + fault.expected;
  }
  return "";
}

Scene scene(const std::string& text) {
  const TemporaryFolder folder;
  write_files(folder.path, {{"s.json", text}});
  return read_scene(folder / "s.json");
}

Scene scene(const std::string& from, const std::string& to) {
  return scene(scene_with(from, to));
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
const std::string grey_pixel = png_bytes(2, 2, 1, 8, {1, 2, 3, 4});

} // namespace

TEST_CASE("the lecture's own file loads unchanged") {
  // scenes/lecture/config.json is that file; here with assets of its own.
  const TemporaryFolder folder;
  const std::string text =
      read_file(REFRASTER_SOURCE_DIR "/scenes/lecture/config.json", "the lecture's scene", 1 << 20);
  write_files(folder.path, {{"resource/objects/", ""},
                            {"resource/textures/", ""},
                            {"config.json", text},
                            {"resource/objects/cube.obj", triangle},
                            {"resource/textures/wood.png", grey_pixel}});
  const Scene read = read_scene(folder / "config.json");
  CHECK(read.camera.position == Double3(0, 0, 6));
  CHECK(read.camera.target == Double3(0, 0, 5));
  CHECK(read.camera.fov_y_degrees == 45);
  REQUIRE(read.point_lights.size() == 1);
  CHECK(read.point_lights[0].position == Double3(0, 0, -10));
  CHECK(read.point_lights[0].linear == 0.09);
  CHECK(read.point_lights[0].quadratic == 0.032);
  REQUIRE(read.direction_lights.size() == 1);
  CHECK(read.direction_lights[0].direction == Double3(-0.2, -1, -0.3));
  CHECK(read.direction_lights[0].radiance == Double3(0.1, 0.1, 0.1));
  REQUIRE(read.objects.size() == 1);
  const Object& cube = read.objects[0];
  CHECK(cube.name == "cube");
  CHECK(cube.mesh->triangles.size() == 1);
  CHECK(cube.vertex_shader_path == folder / "shader/vertex.glsl");
  REQUIRE(std::holds_alternative<Phong>(
      cube.material.fragment_function)); // by the stem phong_fs; the BRDF file need not exist
  const Phong& phong = std::get<Phong>(cube.material.fragment_function);
  CHECK(phong.ka == Double3(0.05));
  CHECK(phong.glossiness == 8);
  CHECK(phong.specular_gate == SpecularGate::open);
  CHECK(cube.material.diffuse_map.filter == TextureFilter::bilinear);
  REQUIRE(cube.material.diffuse_map.texture);
  CHECK(cube.material.diffuse_map.texture->levels.size() == 1);
}

TEST_CASE("vectors are strings or arrays") {
  CHECK(scene("\"0 0 6\"", "\" 1e0\\t+2.5   -3 \"").camera.position == Double3(1, 2.5, -3));
  CHECK(scene("\"0 0 6\"", "[1, 2.5, -3]").camera.position == Double3(1, 2.5, -3));
}

TEST_CASE("every optional key of the camera is read") {
  const Camera camera =
      scene("\"0 0 6\"", "\"0 0 6\", \"target\": \"1 2 3\", \"up\": [0, 0, 1], \"fov_y\": 60, \"near\": 0.5, "
                         "\"far\": 1e4, \"movement_speed\": 5, \"mouse_sensitivity\": 0.1")
          .camera;
  CHECK(camera.target == Double3(1, 2, 3));
  CHECK(camera.up == Double3(0, 0, 1));
  CHECK(camera.fov_y_degrees == 60);
  CHECK(camera.near == 0.5);
  CHECK(camera.far == 10000);
}

TEST_CASE("a number may be written in every way that JSON has, and is rounded once") {
  const std::pair<const char*, double> numbers[] = {{"0", 0},
                                                    {"0e308", 0},
                                                    {"0.000e-9", 0},
                                                    {"0.1", 0.1},
                                                    {"12e-1", 1.2},
                                                    {"1E+2", 100},
                                                    {"5e-324", 5e-324},
                                                    {"1e-999999999", 0},
                                                    {"1e-4526761657999999999", 0},
                                                    {"9007199254740993", 9007199254740992},
                                                    {"18446744073709551616", 0x1p64},
                                                    {"1.7976931348623157e308", 1.7976931348623157e308},
                                                    {"2.2250738585072011e-308", 2.2250738585072011e-308}};
  for (const auto& number : numbers) {
    CAPTURE(number.first);
    const Scene read = scene("\"glossiness\": 8", std::string("\"glossiness\": ") + number.first);
    CHECK(std::get<Phong>(read.objects[0].material.fragment_function).glossiness == number.second);
  }
}

TEST_CASE("lists may be empty, and a scene without objects is a scene") {
  const Scene empty = scene(R"({"scene": {"camera": {"position": "0 0 0"}, "point_lights": [], "direction_lights": [],
                              "objects": [], "background": "0.25 0.5 2"}})");
  CHECK(empty.objects.empty());
  CHECK(empty.background == Double3(0.25, 0.5, 2));
}

TEST_CASE("comments, trailing commas and a byte order mark are taken") {
  std::string text =
      "\xef\xbb\xbf// first\n/* \"scene\": */ " + scene_with("\"glossiness\": 8}", "\"glossiness\": 8,} // last");
  CHECK_NOTHROW(scene(text));
}

TEST_CASE("mirrored and singular scales are allowed") {
  CHECK(scene("\"scale\": \"1 1 1\"", "\"scale\": \"-1 1 0\"").objects[0].scale == Double3(-1, 1, 0));
  CHECK(scene("\"scale\": \"1 1 1\"", "\"scale\": \"0 0 0\"").objects[0].scale == Double3(0, 0, 0));
}

TEST_CASE("a fragment function is chosen by its name, else by the stem of the shader file") {
  CHECK(
      std::holds_alternative<BlinnPhong>(scene("\"phong\"", "\"blinn_phong\"").objects[0].material.fragment_function));
  const std::string shaders = "\"vertex_shader_file_path\": \"v.glsl\", \"fragment_shader_file_path\": ";
  for (const char* const stem : {"blinn_phong_fs", "blinn_fs", "blinn_phong", "blinn"})
    CHECK(std::holds_alternative<BlinnPhong>(
        scene("\"fragment_function\": \"phong\"", shaders + "\"any/folder/" + stem + ".glsl\"")
            .objects[0]
            .material.fragment_function));
  // The key wins.
  CHECK(std::holds_alternative<Phong>(
      scene("\"fragment_function\": \"phong\"", "\"fragment_function\": \"phong\", " + shaders + "\"blinn_fs.glsl\"")
          .objects[0]
          .material.fragment_function));
}

TEST_CASE("of microfacets some parameters may be left out, and their maps are read in green and blue") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& material) {
    std::string text = scene_with("\"phong\"", "\"microfacet\"");
    const std::size_t at = text.find("{\"ka\"");
    text.replace(at, text.find('}', at) + 1 - at, "{" + material + "}");
    write_files(folder.path, {{"s.json", text}, {"orm.png", png_bytes(1, 1, 3, 8, {10, 20, 30})}});
    return read_scene(folder / "s.json").objects[0].material;
  };
  const std::string needed = R"("base_color": "1 0.5 0", "metallic": 0.5, "roughness": 0.25)";
  const Material plain = read(needed);
  const Microfacet& function = std::get<Microfacet>(plain.fragment_function);
  CHECK(function.base_color == Double3(1, 0.5, 0));
  CHECK(function.metallic == 0.5);
  CHECK(function.roughness == 0.25);
  CHECK(function.ior == 1.5);
  CHECK(function.fresnel == MicrofacetFresnel::schlick);
  const Material full = read(needed + R"(, "ior": 1.33, "fresnel": "conductor", "eta": "1 2 3", "k": "0 1 2",
    "roughness_map": "orm.png", "metallic_map": {"path": "orm.png"})");
  CHECK(full.microfacets()->ior == 1.33);
  CHECK(full.microfacets()->eta == Double3(1, 2, 3));
  CHECK(full.microfacets()->k == Double3(0, 1, 2));
  CHECK(full.microfacets()->fresnel == MicrofacetFresnel::conductor);
  CHECK(full.roughness_map.texture->levels[0].rgb[0] == 20);
  CHECK(full.metallic_map.texture->levels[0].rgb[0] == 30);
  const std::string at = "/scene/objects/0/material/";
  CHECK(first_fault([&] { read(R"("base_color": "1 1 1", "metallic": 1)"); }) ==
        at + "roughness: nothing, a number from 0 to 1");
  CHECK(first_fault([&] { read(needed + R"(, "ior": 0.9)"); }) == at + "ior: 0.9, a number from 1 to 10");
  CHECK(first_fault([&] { read(R"("base_color": "2 1 1", "metallic": 1, "roughness": 1)"); }) ==
        at + "base_color: \"2 1 1\", three numbers from 0 to 1");
  CHECK(first_fault([&] { read(needed + R"(, "eta": "0 1 1")"); }).starts_with(at + "eta: "));
}

TEST_CASE("choices are read by their names") {
  const Object object =
      scene("\"glossiness\": 8}", "\"glossiness\": 8, \"specular_gate\": true, \"texture_filter\": \"nearest\"}, "
                                  "\"cull\": \"back\", \"name\": \"ball\"")
          .objects[0];
  CHECK(object.cull == Cull::back);
  CHECK(object.name == "ball");
  CHECK(object.material.diffuse_map.filter == TextureFilter::nearest);
  CHECK(std::get<Phong>(object.material.fragment_function).specular_gate == SpecularGate::cut_below_horizon);
}

TEST_CASE("a texture is a path, or an object with all that can be said of it") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& keys) {
    write_files(folder.path, {{"s.json", scene_with("\"glossiness\": 8}", "\"glossiness\": 8, " + keys + "}")},
                              {"a.png", png_bytes(2, 2, 1, 8, {0, 188, 255, 20})},
                              {"b.png", grey_pixel}});
    return read_scene(folder / "s.json").objects[0].material;
  };
  const auto refused = [&](const std::string& keys) { return first_fault([&] { read(keys); }); };
  const Material plain = read("\"diffuse_map\": \"a.png\", \"specular_map\": {\"path\": \"b.png\"}");
  CHECK(plain.diffuse_map.texture->full_scale == 255);
  CHECK_FALSE(plain.diffuse_map.is_placed());
  CHECK(plain.specular_map.texture->levels[0].width == 2);
  CHECK_FALSE(plain.emissive_map.texture);
  CHECK(plain.emissive == Double3(0));
  const Material full = read("\"diffuse_map\": {\"path\": \"a.png\", \"filter\": \"trilinear\", \"wrap\": \"clamp\", "
                             "\"scale\": [2, -3], \"offset\": \"0.5 1\", \"color_space\": \"srgb\"}, "
                             "\"emissive_map\": \"a.png\"");
  const TextureMap& map = full.diffuse_map;
  CHECK(map.filter == TextureFilter::trilinear);
  CHECK(map.wrap == TextureWrap::clamp);
  CHECK(map.scale == Double2(2, -3));
  CHECK(map.offset == Double2(0.5, 1));
  CHECK(map.texture->full_scale == 1);
  REQUIRE(map.texture->levels.size() == 2);
  // IEC 61966-2-1, by hand: 188 is ((188 / 255 + 0.055) / 1.055)^2.4 = 0.5029; 20 is ((20 / 255 + 0.055) / 1.055)^2.4.
  CHECK(static_cast<double>(map.texture->levels[0].rgb[9]) == doctest::Approx(0.502886458));
  CHECK(static_cast<double>(map.texture->levels[0].rgb[3]) == doctest::Approx(0.006995410));
  CHECK(full.emissive_map.texture != map.texture); // as stored
  CHECK(full.emissive_map.texture->full_scale == 255);
  CHECK(full.emissive == Double3(1)); // beside a map
  CHECK(read("\"emissive_map\": \"a.png\", \"emissive\": \"0.5 0 0\"").emissive == Double3(0.5, 0, 0));
  const std::string at = "/scene/objects/0/material/";
  CHECK(refused("\"diffuse_map\": \"a.png\", \"texture_file_path\": \"b.png\"") ==
        at + "diffuse_map: diffuse_map beside texture_file_path, one of the two");
  CHECK(refused("\"specular_map\": 3") == at + "specular_map: 3, the path of a file, or an object with one");
  CHECK(refused("\"specular_map\": {}").starts_with(at + "specular_map/path: "));
  CHECK(refused("\"specular_map\": {\"path\": \"a.png\", \"scale\": [1]}").starts_with(at + "specular_map/scale: "));
  CHECK(refused("\"specular_map\": {\"path\": \"a.png\", \"wrap\": \"mirror\"}") ==
        at + "specular_map/wrap: \"mirror\", \"repeat\" or \"clamp\"");
}

TEST_CASE("an opacity is alpha or luminance, or the channel that is asked for, of any fragment function") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& keys) {
    write_files(folder.path, {{"s.json", scene_with("\"glossiness\": 8}", "\"glossiness\": 8, " + keys + "}")},
                              {"rgba.png", png_bytes(1, 1, 4, 8, {10, 20, 30, 40})},
                              {"rgb.png", png_bytes(1, 1, 3, 8, {10, 20, 30})},
                              {"ga.png", png_bytes(1, 1, 2, 8, {50, 60})},
                              {"g.png", png_bytes(1, 1, 1, 8, {70})},
                              {"white.png", png_bytes(1, 1, 3, 8, {255, 255, 255})}});
    return read_scene(folder / "s.json").objects[0].material;
  };
  const auto value = [&](const std::string& image, const std::string& channel) {
    const std::string keys = channel.empty() ? "" : ", \"channel\": \"" + channel + "\"";
    const Material material = read("\"opacity_map\": {\"path\": \"" + image + ".png\"" + keys + "}");
    const PaddedVector<float>& rgb = material.opacity_map.texture->levels.at(0).rgb;
    CHECK(rgb[0] == rgb[1]);
    CHECK(rgb[0] == rgb[2]);
    CHECK(material.opacity_threshold == 0.5);
    return static_cast<double>(rgb[0]);
  };
  const double luminance = 0.2126 * 10 + 0.7152 * 20 + 0.0722 * 30; // ITU-R BT.709
  CHECK(value("rgba", "") == 40);
  CHECK(value("rgba", "auto") == 40);
  CHECK(value("rgba", "red") == 10);
  CHECK(value("rgba", "green") == 20);
  CHECK(value("rgba", "blue") == 30);
  CHECK(value("rgba", "alpha") == 40);
  CHECK(value("rgba", "luminance") == doctest::Approx(luminance).epsilon(0x1p-23));
  CHECK(value("rgb", "") == doctest::Approx(luminance).epsilon(0x1p-23));
  CHECK(value("rgb", "alpha") == 255);
  CHECK(value("ga", "") == 60);
  CHECK(value("ga", "blue") == 50);
  CHECK(value("g", "") == 70);
  CHECK(value("g", "alpha") == 255);
  CHECK(value("white", "") == 255);
  const Material both = read("\"texture_file_path\": \"rgba.png\", \"opacity_map\": {\"path\": \"rgba.png\", "
                             "\"filter\": \"nearest\", \"wrap\": \"clamp\", \"scale\": [2, 3], \"offset\": [4, 5]}, "
                             "\"opacity_threshold\": 0.25");
  CHECK(both.opacity_map.texture != both.diffuse_map.texture);
  CHECK(both.opacity_map.filter == TextureFilter::nearest);
  CHECK(both.opacity_map.wrap == TextureWrap::clamp);
  CHECK(both.opacity_map.scale == Double2(2, 3));
  CHECK(both.opacity_map.offset == Double2(4, 5));
  CHECK(both.opacity_threshold == 0.25);
  const auto refused = [&](const std::string& keys) { return first_fault([&] { read(keys); }); };
  const std::string at = "/scene/objects/0/material/";
  CHECK(refused("\"opacity_threshold\": 1.5") == at + "opacity_threshold: 1.5, a number from 0 to 1");
  CHECK(refused("\"opacity_map\": {\"path\": \"g.png\", \"channel\": \"hue\"}")
            .starts_with(at + "opacity_map/channel: \"hue\", \"auto\" or \"red\""));
  CHECK(refused("\"diffuse_map\": {\"path\": \"g.png\", \"channel\": \"red\"}")
            .starts_with(at + "diffuse_map/channel: an unknown key"));
}

TEST_CASE("normals are turned by maps of any fragment function, and meshes that need tangents get them once") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& keys) {
    write_files(folder.path, {{"s.json", scene_with("\"glossiness\": 8}", "\"glossiness\": 8, " + keys + "}")},
                              {"a.png", png_bytes(2, 2, 3, 8, {128, 128, 255, 10, 20, 30, 1, 2, 3, 128, 255, 0})}});
    return read_scene(folder / "s.json");
  };
  const Scene scene = read("\"normal_map\": \"a.png\", \"normal_scale\": -0.5, "
                           "\"bump_map\": {\"path\": \"a.png\", \"channel\": \"blue\"}, \"bump_scale\": 3");
  const Material& material = scene.objects[0].material;
  CHECK(material.normal_scale == -0.5);
  CHECK(material.bump_scale == 3);
  const std::vector<float> directions(material.normal_map.texture->levels[0].rgb.begin(),
                                      material.normal_map.texture->levels[0].rgb.end());
  CHECK(directions ==
        std::vector<float>{1, 2, 3, 128, 255, 0, 128, 128, 255, 10, 20, 30}); // the bottom row is the first
  CHECK(material.bump_map.texture->levels[0].rgb[0] == 3);
  CHECK(material.bump_map.texture->levels[0].rgb[1] == 3);
  CHECK(scene.objects[0].mesh->tangents.size() == scene.objects[0].mesh->uvs.size());
  CHECK(read("\"diffuse_map\": \"a.png\"").objects[0].mesh->tangents.empty());
  const Material usual = read("\"bump_map\": \"a.png\"").objects[0].material;
  CHECK(usual.normal_scale == 1);
  CHECK(usual.bump_scale == 1);
  CHECK(static_cast<double>(usual.bump_map.texture->levels[0].rgb[9]) ==
        doctest::Approx(0.2126 * 10 + 0.7152 * 20 + 0.0722 * 30)); // luminance
  CHECK_THROWS_AS(read("\"normal_map\": \"a.png\", \"normal_scale\": \"much\""), InputError);
}

TEST_CASE("shapes are made with their parameters, and equal ones once") {
  const std::string sphere = "{\"sphere\": {\"segments\": 8, \"rings\": 4}}";
  CHECK(scene(sphere, sphere).objects[0].mesh->triangles.size() == 2 * 8 * 3);
  CHECK(scene(sphere, "{\"sphere\": {}}").objects[0].mesh->triangles.size() == 2 * 64 * 31);
  CHECK(scene(sphere, "{\"cube\": {}}").objects[0].mesh->triangles.size() == 12);
  CHECK(scene(sphere, "{\"plane\": {\"segments\": 3}}").objects[0].mesh->triangles.size() == 18);
  CHECK(scene(sphere, "{\"torus\": {\"rings\": 5, \"tube_radius\": 0.1}}").objects[0].mesh->triangles.size() ==
        2 * 64 * 5);
  CHECK(scene(sphere, sphere).objects[0].name == "sphere");
}

TEST_CASE("a merl material needs its table alone; what belongs to other functions is accepted and checked") {
  const TemporaryFolder folder;
  const std::string header = {90, 0, 0, 0, 90, 0, 0, 0, static_cast<char>(180), 0, 0, 0};
  const std::string material = R"("material": {"ka": "0 0 0", "kd": "0.5 0.5 0.5", "ks": "1 1 1", "glossiness": 8})";
  const auto with = [&](const std::string& keys) {
    std::string text = scene_with("\"phong\"", "\"merl\"");
    text.replace(text.find(material), material.size(), "\"material\": {\"brdf_file_path\": \"t.binary\"" + keys + "}");
    write_files(folder.path, {{"s.json", text}, {"t.binary", header, 34992012}});
    return read_scene(folder / "s.json");
  };
  const Scene plain = with("");
  const Merl& merl = std::get<Merl>(plain.objects[0].material.fragment_function);
  CHECK(merl.table);
  CHECK(merl.lookup == MerlLookup::trilinear);
  CHECK(merl.angles == MerlAngles::closed);
  const Scene other =
      with(", \"merl_lookup\": \"trilinear-edge\", \"merl_angles\": \"frame\", \"ka\": \"0 0 0\", \"glossiness\": 8, "
           "\"texture_file_path\": \"none.png\"");
  CHECK(std::get<Merl>(other.objects[0].material.fragment_function).lookup == MerlLookup::trilinear_edge);
  CHECK(std::get<Merl>(other.objects[0].material.fragment_function).angles == MerlAngles::frame);
  CHECK_THROWS_AS(with(", \"glossiness\": -1"), InputError);
}

TEST_CASE("a file that is used twice is loaded once, however its path is written") {
  const TemporaryFolder folder;
  const auto object = [](const std::string& mesh, const std::string& texture, const std::string& filter) {
    return R"({"obj_file_path": ")" + mesh +
           R"(", "fragment_function": "phong", "position": "0 0 0", "rotate_x": 0, "rotate_y": 0,
      "rotate_z": 0, "scale": "1 1 1", "material": {"ka": "0 0 0", "kd": "1 1 1", "ks": "0 0 0", "glossiness": 1,
      "texture_file_path": ")" +
           texture + R"(", "texture_filter": ")" + filter + R"("}})";
  };
  write_files(
      folder.path,
      {{"m/", ""},
       {"m/t.obj", triangle},
       {"a.png", grey_pixel},
       {"b.png", grey_pixel},
       {"s.json",
        R"({"scene": {"camera": {"position": "0 0 6"}, "point_lights": [], "direction_lights": [], "objects": [)" +
            object("m/t.obj", "a.png", "bilinear") + "," + object("m/../m/./t.obj", "./a.png", "trilinear") + "," +
            object("m/t.obj", folder / "b.png", "bilinear") + "]}}"}});
  const std::vector<Object> objects = read_scene(folder / "s.json").objects;
  CHECK(objects[0].mesh == objects[1].mesh);
  CHECK(objects[0].mesh == objects[2].mesh);
  CHECK(objects[0].material.diffuse_map.texture == objects[1].material.diffuse_map.texture);
  CHECK(objects[0].material.diffuse_map.texture != objects[2].material.diffuse_map.texture);
  // Mip levels are there where anyone asks for them.
  CHECK(objects[0].material.diffuse_map.texture->levels.size() == 2);
  CHECK(objects[2].material.diffuse_map.texture->levels.size() == 1);
}

TEST_CASE("faults beyond the first hundred are counted") {
  std::string keys;
  for (int i = 0; i < 250; ++i) keys += "\"k" + std::to_string(i) + "\": 0, ";
  try {
    scene("\"position\": \"0 0 6\"", keys + "\"position\": \"0 0 6\"");
    FAIL("no fault");
  } catch (const InputError& error) {
    CHECK(error.faults().size() == 101);
    CHECK(error.faults().back().found == "150 more faults");
  }
}

TEST_CASE("a shape's vertices and triangles are known before it is made, and no memory is taken for more") {
  for (const Shape& shape :
       {Shape(SphereShape{7, 2}), Shape(SphereShape{5, 9}), Shape(CubeShape{}), Shape(PlaneShape{1}),
        Shape(PlaneShape{6}), Shape(TorusShape{3, 8, 0.4}), Shape(KnotShape{20, 3, 0.2})}) {
    const auto mesh = make_mesh(shape);
    CHECK(mesh_counts(shape) == MeshCounts{mesh->positions.size(), mesh->triangles.size()});
    CHECK(mesh_counts(shape) == MeshCounts{mesh->positions.capacity(), mesh->triangles.capacity()});
    CHECK(mesh->normals.capacity() == mesh->positions.size());
    CHECK(mesh->uvs.capacity() == mesh->positions.size());
  }
}

TEST_CASE("docs/scene-format.md has exactly the tables that the program prints") {
  CHECK(page_part("docs/scene-format.md", "refraster list scene-format") == scene_format_markdown());
}

} // namespace refraster::test
