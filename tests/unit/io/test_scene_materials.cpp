// Scenes whose objects have the materials of their OBJ files.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/brdf/merl_file.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/png_bytes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

namespace refraster::test {
namespace {

/// Five squares: of no material, red, green, red again, and of `usemtl` without a name.
const std::string squares =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1 2 3 4\n"
    "usemtl red\nf 1/1 2/2 3/3 4/4\nusemtl green\nf 1/1 2/2 3/3 4/4\nf 4 3 2\nusemtl red\nf 1 2 3\nusemtl\nf 1 2 3\n";
const std::string red_and_green = "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nmap_Kd t.png\n";

/// A scene of one object m.obj with these keys.
struct ModelFolder : TemporaryFolder {
  NoteList notes;
  SceneOptions options;

  explicit ModelFolder(const std::string& keys, const std::string& library = red_and_green,
                       const std::string& mesh = squares) {
    write_files(path, {{"s.json", R"({"scene": {"camera": {"position": "0 0 6"}, "point_lights": [],
        "direction_lights": [], "objects": [{"obj_file_path": "m.obj", "position": "0 0 0", "rotate_x": 0,
        "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1")" +
                                      keys + "}]}}"},
                       {"m.obj", mesh},
                       {"m.mtl", library},
                       {"t.png", png_bytes(1, 1, 3, 8, {255, 0, 0})}});
    options.notes = &notes;
  }
  Object object() { return read_scene(*this / "s.json", options).objects.at(0); }
  std::string noted() const {
    std::string text;
    for (const Note& note : notes.notes()) text += note.text().substr(path.string().size() + 1) + "\n";
    return text;
  }
  /// The message of what is wrong with the scene.
  std::string refused() {
    try {
      object();
    } catch (const InputError& error) {
      return error.faults().at(0).text().substr(path.string().size() + 1);
    }
    return "";
  }
};

Double3 kd(const Material& material) {
  return std::visit(
      [](const auto& function) {
        if constexpr (requires { function.kd; }) return function.kd;
        else return Double3(-1);
      },
      material.fragment_function);
}
Double3 kd(const Object& object, std::uint32_t triangle) {
  return kd(material_of(object, triangle));
}

const Double3 red(1, 0, 0), green(0, 1, 0), grey(0.8);

} // namespace

TEST_CASE("without a material each triangle has that of the file, in Blinn-Phong") {
  for (const char* const keys : {"", ", \"material\": \"from_file\""}) {
    ModelFolder folder(keys);
    const Object object = folder.object();
    const Double3 expected[] = {grey, grey, red, red, green, green, green, red, grey};
    REQUIRE(object.mesh->triangles.size() == std::size(expected));
    for (std::uint32_t i = 0; i < std::size(expected); ++i) {
      CAPTURE(i);
      CHECK(kd(object, i) == expected[i]);
      CHECK(std::holds_alternative<BlinnPhong>(material_of(object, i).fragment_function));
    }
    CHECK(material_of(object, 4).diffuse_map.texture);
    CHECK_FALSE(material_of(object, 2).diffuse_map.texture);
    CHECK(material_of(object, 4).name == "green");
    CHECK(object.mesh->materials.at(1).diffuse_map.path == "t.png");
    CHECK(folder.noted() == "m.obj: found 1 triangle without vt, on which the texture is not shown\n");
  }
}

TEST_CASE("the function of the object shades what the file describes: a measured one does not") {
  ModelFolder folder(", \"fragment_function\": \"phong\"");
  CHECK(std::holds_alternative<Phong>(material_of(folder.object(), 4).fragment_function));
  ModelFolder microfacets(", \"fragment_function\": \"microfacet\"",
                          "newmtl red\nKd 1 0 0\nPr 0.5\nnewmtl green\nKd 0 1 0\nmap_Pr t.png\nmap_Ks t.png\n");
  const Object object = microfacets.object();
  const Material& green_one = material_of(object, 4);
  REQUIRE(green_one.microfacets());
  CHECK(green_one.microfacets()->base_color == Double3(0, 1, 0));
  CHECK(green_one.microfacets()->roughness == 1);
  CHECK(green_one.roughness_map.texture);
  CHECK_FALSE(green_one.specular_map.texture);
  CHECK(microfacets.noted().find("with Ks, drawn without it: microfacets reflect by Kd, Pr and Pm") !=
        std::string::npos);
  CHECK(ModelFolder(", \"fragment_function\": \"merl\", \"material\": \"from_file\"").refused() ==
        "s.json:3:78: /scene/objects/0/fragment_function: found a function that files describe no materials for, "
        "expected phong, blinn_phong or microfacet, or no material \"from_file\"");
}

TEST_CASE("a material of the scene is that of all triangles, and a note says that the file's are not used") {
  const std::string blue = R"("kd": "0 0 1", "ka": "0 0 0", "ks": "0 0 0", "glossiness": 1)";
  ModelFolder folder(", \"fragment_function\": \"phong\", \"material\": {" + blue + "}");
  const Object object = folder.object();
  CHECK(object.materials.empty());
  CHECK(kd(object, 4) == Double3(0, 0, 1));
  CHECK(folder.noted() == "m.obj: found 2 materials of its own, not used: the scene's `material` is\n");
  CHECK(object.mesh->materials.at(0).file.empty()); // nor are they read
}

TEST_CASE("a scene may name materials: the others are what `material` says") {
  const std::string blue = R"({"kd": "0 0 1", "ka": "0 0 0", "ks": "0 0 0", "glossiness": 1})";
  ModelFolder one(", \"materials\": {\"red\": " + blue + "}");
  CHECK(kd(one.object(), 2) == Double3(0, 0, 1));
  CHECK(kd(one.object(), 4) == green);
  CHECK(kd(one.object(), 0) == grey);
  ModelFolder other(", \"fragment_function\": \"phong\", \"material\": " + blue +
                    ", \"materials\": {\"green\": \"from_file\"}");
  CHECK(kd(other.object(), 0) == Double3(0, 0, 1));
  CHECK(kd(other.object(), 2) == Double3(0, 0, 1));
  CHECK(kd(other.object(), 4) == green);
  CHECK(material_of(other.object(), 4).diffuse_map.texture);
  CHECK(ModelFolder(", \"materials\": {\"gren\": \"from_file\"}").refused() ==
        "s.json:3:71: /scene/objects/0/materials/gren: found a material that the OBJ file does not name, expected one "
        "of red, green; did you mean green?");
  CHECK(ModelFolder(", \"materials\": {\"red\": 5}").refused() ==
        "s.json:3:78: /scene/objects/0/materials/red: found 5, expected an object, or \"from_file\"");
}

TEST_CASE("what is missing is drawn in grey or without, with one note a kind") {
  ModelFolder none("", red_and_green, "mtllib gone.mtl\n" + squares.substr(squares.find('\n') + 1));
  CHECK(kd(none.object(), 2) == grey);
  CHECK(none.noted() == "m.obj:1: found the material library \"gone.mtl\", there is no such file: drawn without its "
                        "materials\n"
                        "m.obj: found the material \"red\", drawn in grey: no library describes it (2 times)\n");
  ModelFolder unnamed("", red_and_green, squares.substr(squares.find('\n') + 1));
  CHECK(kd(unnamed.object(), 2) == grey);
  CHECK(unnamed.noted() == "m.obj: found usemtl without mtllib, drawn in grey: no file describes its materials\n");
  ModelFolder textures("", "newmtl red\nmap_Kd gone.png\nnewmtl green\nKd 0 1 0\nmap_Kd m.mtl\n");
  const Object object = textures.object();
  CHECK_FALSE(material_of(object, 2).diffuse_map.texture);
  CHECK(kd(object, 2) == Double3(1));
  CHECK_FALSE(material_of(object, 4).diffuse_map.texture);
  const std::string noted = textures.noted();
  CHECK(noted.find("m.mtl:2: found the texture \"gone.png\", there is no such file: drawn without it\n") !=
        std::string::npos);
  CHECK(noted.find("m.mtl: found ") != std::string::npos);
  CHECK(noted.find("drawn without it: expected ") != std::string::npos);
}

TEST_CASE("maps of a library are textures with their options; those of colours are sRGB") {
  ModelFolder folder("", "newmtl green\nmap_Kd -s 2 3 -o 0.5 t.png\nmap_Ks -clamp on t.png\nmap_Ke t.png\n");
  const Object object = folder.object();
  const Material& material = material_of(object, 4);
  CHECK(material.diffuse_map.scale == Double2(2, 3));
  CHECK(material.diffuse_map.offset == Double2(0.5, 0));
  CHECK(material.diffuse_map.wrap == TextureWrap::repeat);
  CHECK(material.diffuse_map.texture->full_scale == 1);
  CHECK(material.specular_map.wrap == TextureWrap::clamp);
  CHECK(material.specular_map.texture->full_scale == 255);
  CHECK(material.emissive_map.texture == material.diffuse_map.texture);
  CHECK(material.emissive == Double3(1));
  CHECK(std::get<BlinnPhong>(material.fragment_function).ks == Double3(1));
  const Material dark = [] {
    ModelFolder of_colours("", "newmtl green\nKs 0.5 0 0\nmap_Ks t.png\nKe 0 0 2\n");
    return material_of(of_colours.object(), 4);
  }();
  CHECK(dark.emissive == Double3(0, 0, 2));
  CHECK(std::get<BlinnPhong>(dark.fragment_function).ks == Double3(0.5, 0, 0));
}

TEST_CASE("map_d cuts out, by the channel of -imfchan; d below 1 beside it has no part in that") {
  const auto opacity = [](const std::string& statements, std::string& noted) {
    ModelFolder folder("", "newmtl green\n" + statements + "\n");
    write_files(folder.path, {{"rgba.png", png_bytes(1, 1, 4, 8, {10, 20, 30, 40})}});
    const Material material = material_of(folder.object(), 4);
    noted = folder.noted();
    CHECK(material.opacity_threshold == 0.5);
    return material.opacity_map;
  };
  const auto value = [&](const std::string& statement) {
    std::string noted;
    const TextureMap map = opacity(statement, noted);
    CHECK(noted.find("map_d") == std::string::npos);
    CHECK(noted.find("-imfchan") == std::string::npos);
    return map.texture ? static_cast<double>(map.texture->levels.at(0).rgb.at(0)) : -1;
  };
  CHECK(value("Kd 1 1 1") == -1);
  CHECK(value("map_d rgba.png") == 40);
  CHECK(value("map_d -imfchan r rgba.png") == 10);
  CHECK(value("map_d -imfchan g rgba.png") == 20);
  CHECK(value("map_d -imfchan b rgba.png") == 30);
  CHECK(value("map_d -imfchan m rgba.png") == 40);
  CHECK(value("map_d -imfchan l rgba.png") == doctest::Approx(18.596).epsilon(0x1p-20)); // 2.126 + 14.304 + 2.166
  std::string noted;
  const TextureMap map = opacity("map_d -s 2 3 -o 0.5 -clamp on -imfchan z rgba.png\nd 0.25", noted);
  CHECK(map.scale == Double2(2, 3));
  CHECK(map.offset == Double2(0.5, 0));
  CHECK(map.wrap == TextureWrap::clamp);
  CHECK(map.texture->levels.at(0).rgb.at(0) == 40);
  CHECK(noted.find("-imfchan z, read without -imfchan: an image has no depth") != std::string::npos);
  CHECK(noted.find("d below 1, read without it: map_d alone says what is cut out") != std::string::npos);
  opacity("d 0.25", noted);
  CHECK(noted.find("d below 1, drawn opaque: there is no blending") != std::string::npos);
}

TEST_CASE("a measured material is cut out by an opacity map, and a texture of colours beside it is noted") {
  ModelFolder folder(R"(, "fragment_function": "merl", "vertex_shader_file_path": "a_vs.glsl",
        "fragment_shader_file_path": "a_fs.glsl", "material": {"brdf_file_path": "t.binary",
        "texture_file_path": "t.png", "opacity_map": "t.png", "opacity_threshold": 0.25})");
  write_merl(folder / "t.binary", MerlTable(PaddedVector<double>(3 * MerlTable::samples, 0.5)));
  const Material material = folder.object().material;
  REQUIRE(material.measured() != nullptr);
  CHECK(material.measured()->table->sample(1, 2, 3).y == doctest::Approx(0.5));
  CHECK(material.has_cut_outs());
  CHECK(material.opacity_threshold == 0.25);
  CHECK(material.opacity_map.texture->levels.at(0).rgb.at(0) > 0);
  CHECK(material.diffuse_map.texture == nullptr);
  CHECK(folder.noted().find("t.png") != std::string::npos);
}

TEST_CASE("a light's shadow is read, and that opacity makes no holes in it is a note") {
  const auto noted = [](const std::string& light, const std::string& material, Shadow& shadow) {
    const TemporaryFolder folder;
    write_files(folder.path, {{"s.json", R"({"scene": {"camera": {"position": "0 0 6"}, "point_lights": [],
        "direction_lights": [{"direction": "0 0 -1", "radiance": "1 1 1")" +
                                             light + R"(}], "objects": [{"mesh": {"plane": {}}, "position": "0 0 0",
        "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1", "fragment_function": "phong",
        "material": {"ka": "0 0 0", "kd": "1 1 1", "ks": "0 0 0", "glossiness": 1)" +
                                             material + "}}]}}"},
                              {"t.png", png_bytes(1, 1, 3, 8, {255, 0, 0})}});
    NoteList notes;
    shadow = read_scene(folder / "s.json", {.notes = &notes}).direction_lights.at(0).shadow.kind;
    std::string text;
    for (const Note& note : notes.notes()) text += note.text() + "\n";
    return text;
  };
  const std::string opacity = ", \"opacity_map\": \"t.png\"", exact = ", \"shadow\": \"exact\"";
  const std::string note = "opacity_map, makes no holes in shadows: triangles cast them whole";
  Shadow shadow = Shadow::exact;
  CHECK(noted("", opacity, shadow).empty());
  CHECK(shadow == Shadow::none);
  CHECK(noted(", \"shadow\": \"none\"", opacity, shadow).empty());
  CHECK(shadow == Shadow::none);
  CHECK(noted(exact, "", shadow).empty());
  CHECK(shadow == Shadow::exact);
  const std::string found = noted(exact, opacity, shadow);
  CHECK_MESSAGE(found.find(note) != std::string::npos, found);
  CHECK_THROWS_WITH_AS(
      noted(", \"shadow\": \"soft\"", "", shadow),
      doctest::Contains(
          "/scene/direction_lights/0/shadow: found \"soft\", expected \"none\" or \"exact\" or \"map\" or an object "
          "with map"),
      InputError);
}

TEST_CASE("norm is a normal map, map_Bump and bump are heights, with their options; their mesh gets tangents") {
  for (const std::string key : {"map_Bump", "map_bump", "bump"}) {
    ModelFolder folder("",
                       "newmtl green\nnorm -s 2 3 t.png\n" + key + " -bm -0.25 -imfchan g -o 0.5 -clamp on t.png\n");
    const Object object = folder.object();
    const Material& material = material_of(object, 4);
    CHECK(material.normal_map.scale == Double2(2, 3));
    CHECK(material.normal_map.filter == TextureFilter::trilinear);
    CHECK(material.normal_map.texture->full_scale == 255); // values, not colours
    CHECK(material.normal_scale == 1);
    CHECK(material.bump_map.offset == Double2(0.5, 0));
    CHECK(material.bump_map.wrap == TextureWrap::clamp);
    CHECK(material.bump_scale == -0.25);
    const auto& rgb = material.bump_map.texture->levels[0].rgb;
    CHECK(rgb[0] == material.normal_map.texture->levels[0].rgb[1]); // green
    CHECK(rgb[0] == rgb[2]);
    CHECK(object.mesh->tangents.size() == object.mesh->uvs.size());
    CHECK(folder.noted().find("shown yet") == std::string::npos);
  }
  // Without -bm and -imfchan: as high as the image's luminance; and where there is neither, no tangents.
  ModelFolder plain("", "newmtl green\nbump t.png\n");
  const Object object = plain.object();
  CHECK(material_of(object, 4).bump_scale == 1);
  CHECK_FALSE(material_of(object, 4).normal_map.texture);
  CHECK(!object.mesh->tangents.empty());
  CHECK(ModelFolder("", "newmtl green\nmap_Kd t.png\n").object().mesh->tangents.empty());
}

TEST_CASE("a texture is found with / for \\, by its last component, without regard to case; never outside") {
  const auto found = [](const std::string& written, Outside outside = Outside::refused) {
    ModelFolder folder("", "newmtl green\nmap_Kd " + written + "\n");
    std::filesystem::create_directory(folder.path / "Images");
    write_files(folder.path, {{"Images/Wall 1.png", png_bytes(1, 1, 3, 8, {0, 255, 0})}});
    const std::string beside = folder.path.string() + ".png"; // outside, next to the folder
    std::filesystem::copy_file(folder.path / "t.png", beside);
    std::filesystem::create_symlink(beside, folder.path / "link.png");
    folder.options.outside = outside;
    const bool is_there = material_of(folder.object(), 4).diffuse_map.texture != nullptr;
    std::filesystem::remove(beside);
    std::string noted = folder.noted();
    const std::size_t begin = noted.find("m.mtl:2: ");
    noted = begin == std::string::npos ? "" : noted.substr(begin, noted.find('\n', begin) - begin);
    const std::size_t comma = noted.rfind("\", ");
    return (is_there ? "there" : "none") + (noted.empty() ? "" : ": " + noted.substr(comma + 3));
  };
  CHECK(found("t.png") == "there");
  CHECK(found("t.png # a comment") == "there");
  CHECK(found("Images/Wall 1.png") == "there");
  CHECK(found("Images\\Wall 1.png") == "there: read with / for \\");
  CHECK(found("C:\\Users\\me\\t.png") == "there: its last component is read, beside the model");
  CHECK(found("/nowhere/at/all/t.png") == "there: its last component is read, beside the model");
  CHECK(found("T.PNG") == "there: read without regard to case");
  CHECK(found("images\\wall 1.PNG") == "there: read without regard to case");
  const std::string outside = "none: outside the model's folder: drawn without it; --allow-outside reads it";
  CHECK(found("../x.png") == outside);
  CHECK(found("link.png") == outside);
  CHECK(found("link.png", Outside::allowed) == "there");
  CHECK(found("x.png") == "none: there is no such file: drawn without it");
}

TEST_CASE("a library's name may have blanks, and one mtllib may name several") {
  const auto colours = [](const std::string& named) {
    ModelFolder folder("", "", "mtllib " + named + "\n" + squares.substr(squares.find('\n') + 1));
    write_files(folder.path, {{"my red.mtl", "newmtl red\nKd 1 0 0\n"}, {"g.mtl", "newmtl green\nKd 0 1 0\n"}});
    const Object object = folder.object();
    return std::pair(kd(object, 2), kd(object, 4));
  };
  CHECK(colours("my red.mtl") == std::pair(red, grey));
  CHECK(colours("g.mtl # of the garden") == std::pair(grey, green));
  CHECK(colours("my red.mtl\nmtllib g.mtl") == std::pair(red, green));
  CHECK(colours("none.mtl G.MTL") == std::pair(grey, green));
}

TEST_CASE("a mesh out of the cache has its materials") {
  ModelFolder folder("", red_and_green, squares + std::string(2 << 20, '\n'));
  folder.options.mesh_cache = folder / "cache";
  std::filesystem::create_directory(folder.options.mesh_cache);
  for (int i = 0; i < 2; ++i) {
    const Object object = folder.object();
    CHECK(kd(object, 2) == red);
    CHECK(kd(object, 4) == green);
    CHECK(object.mesh->material_runs.size() == 4);
    CHECK(object.mesh->material_libraries.at(0).text == "m.mtl");
  }
}

} // namespace refraster::test
