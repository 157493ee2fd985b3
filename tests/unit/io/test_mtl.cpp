// Material libraries: each key of the format, and what is noted of those that are unusual.

#include "io/mesh/mtl_file.h"
#include "io/scene/model/mtl_material.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace refraster {
namespace {

struct Read {
  std::vector<MeshMaterial> materials;
  NoteList notes;

  const MeshMaterial& one() const {
    REQUIRE(materials.size() == 1);
    return materials[0];
  }
  std::string noted() const {
    std::string text;
    for (const Note& note : notes.notes()) text += note.text() + "\n";
    return text;
  }
};

Read read(const std::string& text) {
  Read result;
  result.materials = parse_mtl("a.mtl", text, result.notes);
  return result;
}
/// Of a material `m` with these statements, from line 2 on.
Read statements(const std::string& text) {
  return read("newmtl m\n" + text);
}
PhongParameters shown(const std::string& text) {
  return phong_parameters(statements(text).one());
}
std::string not_shown(const std::string& text) {
  Read result = statements(text);
  CHECK(result.notes.empty());
  note_what_is_not_shown(result.one(), FileFunction::blinn_phong, result.notes);
  return result.noted();
}

} // namespace

TEST_CASE("Kd is kd; without it 0.8, and 1 beside a texture") {
  CHECK(shown("Kd 0.1 0.2 3e-1\n").kd == Double3(0.1, 0.2, 0.3));
  CHECK(shown("Kd 0.5 # grey\n").kd == Double3(0.5));
  CHECK(shown("").kd == Double3(0.8));
  CHECK(shown("map_Kd a.png\n").kd == Double3(1));
  CHECK(shown("map_Kd a.png\nKd 0.25 0.5 0.75\n").kd == Double3(0.25, 0.5, 0.75));
}

TEST_CASE("Ks is ks and Ns the glossiness: no highlight without Ks, one of 30 without Ns, none with Ns 0") {
  const PhongParameters both = shown("Ks 0.5 0.25 0\nNs 96.078431\n");
  CHECK(both.ks == Double3(0.5, 0.25, 0));
  CHECK(both.glossiness == 96.078431);
  CHECK(both.specular_gate == SpecularGate::cut_below_horizon);
  CHECK(shown("Ns 10\n").ks == Double3(0));
  CHECK(shown("Ks 1 1 1\n").glossiness == 30);
  CHECK(shown("Ks 1 1 1\nNs 0\n").ks == Double3(0));
  CHECK(not_shown("Ks 1 1 1\nNs 0\n") == "a.mtl:1: found material \"m\" with Ns 0, drawn without a highlight\n");
}

TEST_CASE("Ka is a tenth of ka; where it says nothing, none, 0 or 1, Kd takes its place") {
  CHECK(shown("Ka 0.5 0.25 1\nKd 1 1 1\n").ka == Double3(0.5, 0.25, 1) * 0.1);
  for (const char* const ka : {"", "Ka 0 0 0\n", "Ka 1 1 1\n"})
    CHECK(shown(std::string(ka) + "Kd 0.5 0.5 0.25\n").ka == Double3(0.5, 0.5, 0.25) * 0.1);
}

TEST_CASE("illum 0 is a constant colour, 1 has no highlight, 2 has one, and all beyond are drawn as 2") {
  const std::string all = "Ka 0.5 0.5 0.5\nKd 0.2 0.4 0.6\nKs 1 1 1\nNs 8\n";
  const PhongParameters constant = shown(all + "illum 0\n"), matt = shown(all + "illum 1\n");
  CHECK(constant.ka == Double3(0.2, 0.4, 0.6));
  CHECK(constant.kd == Double3(0));
  CHECK(constant.ks == Double3(0));
  CHECK(matt.ka == Double3(0.05));
  CHECK(matt.kd == Double3(0.2, 0.4, 0.6));
  CHECK(matt.ks == Double3(0));
  CHECK(shown(all + "illum 2\n").ks == Double3(1));
  CHECK(not_shown(all + "illum 2\n") == "");
  CHECK(shown(all + "illum 7\n").ks == Double3(1));
  CHECK(not_shown(all + "illum 7\n") ==
        "a.mtl:1: found material \"m\" with illum 7, read as illum 2: nothing is mirrored or seen through\n");
}

TEST_CASE("d and Tr say how opaque a material is, d before Tr; it is drawn opaque, with a note") {
  CHECK(statements("d 0.25\n").one().dissolve == 0.25);
  CHECK(statements("d -halo 0.25\n").one().dissolve == 0.25);
  CHECK(statements("Tr 0.25\n").one().dissolve == 0.75);
  CHECK(statements("Tr 0.25\nd 0.5\n").one().dissolve == 0.5);
  CHECK(statements("d 0.5\nTr 0.25\n").one().dissolve == 0.5);
  CHECK(not_shown("d 1\n") == "");
  CHECK(not_shown("d 0.5\n") == "a.mtl:1: found material \"m\" with d below 1, drawn opaque: there is no blending\n");
}

TEST_CASE("Pr, Pm and their maps are kept, with a note") {
  const MeshMaterial& of = statements("Pr 0.25\nPm 0.75\nmap_Pr r.png\nmap_Pm m.png\n").one();
  CHECK(of.roughness == 0.25);
  CHECK(of.metallic == 0.75);
  CHECK(of.roughness_map.path == "r.png");
  CHECK(of.metallic_map.path == "m.png");
  for (const char* const key : {"Pr 0.5\n", "Pm 0.5\n", "map_Pr a.png\n", "map_Pm a.png\n"})
    CHECK(not_shown(key).find("roughness and metalness are for the fragment function microfacet") != std::string::npos);
}

TEST_CASE("of microfacets Kd is the base colour, Pr and Pm are roughness and metallic") {
  const auto of = [](const std::string& text) { return microfacet_parameters(statements(text).one()); };
  const Microfacet full = of("Kd 0.5 0.25 2\nPr 0.3\nPm 0.75\nKs 1 1 1\nNs 1000\n");
  CHECK(full.base_color == Double3(0.5, 0.25, 1));
  CHECK(full.roughness == 0.3);
  CHECK(full.metallic == 0.75);
  CHECK(of("Pr 3\n").roughness == 1);
  CHECK(of("map_Pr a.png\n").roughness == 1);
  CHECK(of("map_Pm a.png\n").metallic == 1);
  CHECK(of("map_Pm a.png\nPm 0.5\n").metallic == 0.5);
  CHECK(of("").metallic == 0);
  CHECK(of("").base_color == Double3(0.8));
  CHECK(of("Ns 6\n").roughness == doctest::Approx(std::sqrt(0.5))); // alpha^2 = 2 / 8
  CHECK(of("Ns 0\n").roughness == 1);
  CHECK(of("illum 0\nKd 0.5 0.5 0.5\n").base_color == Double3(0.5));
}

TEST_CASE("each map is kept under its key") {
  const MeshMaterial of = statements("map_Ka ka.png\nmap_Kd kd.png\nmap_Ks ks.png\nmap_Ke ke.png\nmap_d d.png\n"
                                     "map_Bump b.png\nnorm n.png\nKe 1 2 3\n")
                              .one();
  CHECK(of.ambient_map.path == "ka.png");
  CHECK(of.diffuse_map.path == "kd.png");
  CHECK(of.specular_map.path == "ks.png");
  CHECK(of.emissive_map.path == "ke.png");
  CHECK(of.dissolve_map.path == "d.png");
  CHECK(of.bump_map.path == "b.png");
  CHECK(of.normal_map.path == "n.png");
  CHECK(of.emissive == Double3(1, 2, 3));
  for (const char* const key : {"map_bump", "bump"})
    CHECK(statements(std::string(key) + " x.png\n").one().bump_map.path == "x.png");
  CHECK(not_shown("map_Ka a.png\nmap_Kd a.png\n") == "");
  CHECK(not_shown("map_Ka a.png\n") == "a.mtl:1: found material \"m\" with map_Ka, read without map_Ka: ambient light "
                                       "is coloured by map_Kd\n");
}

TEST_CASE("a map has options, one to three numbers where there may be three, and a name with blanks") {
  const MeshTexture map =
      statements("map_Kd -s 2 3 1 -o 0.5 -clamp on -bm 0.25 -imfchan r a wall 2.png \r\n").one().diffuse_map;
  CHECK(map.path == "a wall 2.png");
  CHECK(map.scale == Double2(2, 3));
  CHECK(map.offset == Double2(0.5, 0));
  CHECK(map.clamp);
  CHECK(map.bump_multiplier == 0.25);
  CHECK(map.channel == 'r');
  CHECK(map.line == 2);
  const MeshTexture two = statements("bump -o 1 2 -s 4 wall.png\n").one().bump_map; // of which tinyobjloader loses it
  CHECK(two.path == "wall.png");
  CHECK(two.offset == Double2(1, 2));
  CHECK(two.scale == Double2(4, 1));
  CHECK_FALSE(two.clamp);
  const Read other = statements("map_Kd -blendu off -mm 0 1 -t 1 1 1 -boost 2 a.png\n");
  CHECK(other.one().diffuse_map.path == "a.png");
  CHECK(other.noted() == "a.mtl:2: found \"-blendu\", -blendu is not used\na.mtl:2: found \"-mm\", -mm is not used\n"
                         "a.mtl:2: found \"-t\", -t is not used\na.mtl:2: found \"-boost\", -boost is not used\n");
  CHECK(statements("map_Kd -1.png\n").one().diffuse_map.path == "-1.png");
}

TEST_CASE("a material's name may have blanks; the first of a name counts") {
  const Read result = read("\xef\xbb\xbf# made by hand\r\nnewmtl a wooden door \r\n\tKd 1 0 0\r\n\nnewmtl b\rKd 0 1 0\r"
                           "newmtl a wooden door\nKd 0 0 1\n");
  REQUIRE(result.materials.size() == 2);
  CHECK(result.materials[0].name == "a wooden door");
  CHECK(result.materials[0].line == 2);
  CHECK(result.materials[0].diffuse == Double3(1, 0, 0));
  CHECK(result.materials[1].name == "b");
  CHECK(result.materials[1].diffuse == Double3(0, 1, 0));
  CHECK(result.noted() == "a.mtl:7: found \"newmtl a wooden door\", skipped: there is a material of that name\n");
}

TEST_CASE("what cannot be read is left out, each kind with one note") {
  CHECK(read("Kd 1 0 0\nnewmtl m\n").noted() == "a.mtl:1: found \"Kd 1 0 0\", skipped: it stands before any newmtl\n");
  CHECK(read("newmtl\nKd 1 0 0\n").noted() == "a.mtl:1: found \"newmtl\", skipped: the material has no name\n");
  const Read result = statements("Kd 1 nan 0\nKs spectral a.rfl\nKa 1 2\nKe -1 0 0\nNs 1e999\nillum 2.5\nmap_Kd\n"
                                 "disp a.png\nNi 1.45\nTf 1 1 1\nkd 1 1 1\nfoo\n");
  CHECK_FALSE(result.one().diffuse);
  CHECK_FALSE(result.one().specular);
  CHECK_FALSE(result.one().ambient);
  CHECK_FALSE(result.one().emissive);
  CHECK_FALSE(result.one().exponent);
  CHECK_FALSE(result.one().illumination);
  CHECK(result.noted() == "a.mtl:2: found \"Kd 1 nan 0\", skipped: a colour is three numbers of 0 or more (4 times)\n"
                          "a.mtl:6: found \"Ns 1e999\", skipped: it has a number of 0 or more\n"
                          "a.mtl:7: found \"illum 2.5\", skipped: a model is a whole number from 0 to 10\n"
                          "a.mtl:8: found \"map_Kd\", skipped: it names no file\n"
                          "a.mtl:9: found \"disp a.png\", disp is not used\n"
                          "a.mtl:12: found \"kd 1 1 1\", skipped: the format has no such statement (2 times)\n");
  CHECK(read(std::string("\xff\xfen\0e\0", 6)).noted() ==
        "a.mtl: found UTF-16 text, not read: a material library is ASCII or UTF-8 text\n");
}

} // namespace refraster
