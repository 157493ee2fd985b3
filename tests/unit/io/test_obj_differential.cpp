// Our reader of OBJ files beside tinyobjloader, on files that both take for the same: no fault, no number that is not
// finite, no `fo`, no corner with an empty slot, no broken line.

#include "io/file/input_file.h"
#include "io/mesh/obj_file.h"
#include "io/mesh/obj_text.h"
#include "io/scene/shape_mesh.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/for_all.h"

#include <doctest/doctest.h>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <sstream>

namespace refraster::test {
namespace {

/// A file as tinyobjloader reads it.
struct OtherReading {
  tinyobj::attrib_t points;
  std::vector<tinyobj::index_t> corners; // of all faces, in the order of the file
  std::vector<std::uint32_t> begin{0};   // of each face its first corner; then the number of corners
};

OtherReading read_by_other(const std::string& text) {
  OtherReading result;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(text);
  REQUIRE(tinyobj::LoadObj(&result.points, &shapes, &materials, &warning, &error, &stream, nullptr, false));
  CHECK(error.empty());
  for (const tinyobj::shape_t& shape : shapes) {
    result.corners.insert(result.corners.end(), shape.mesh.indices.begin(), shape.mesh.indices.end());
    for (const unsigned corners : shape.mesh.num_face_vertices) result.begin.push_back(result.begin.back() + corners);
  }
  return result;
}

/// Whether both hold the same numbers. tinyobjloader rounds a decimal number several times, so that its own may be the
/// float beside the nearest one.
template <glm::length_t N>
bool same_points(const RawVector<glm::vec<N, float, glm::defaultp>>& ours, const std::vector<float>& others) {
  if (others.size() != ours.size() * static_cast<std::size_t>(N)) return false;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const float a = ours[i / N][static_cast<glm::length_t>(i % N)], b = others[i];
    if (a != b && std::nextafter(a, b) != b) return false;
  }
  return true;
}

void check_same(const std::string& text) {
  NoteList notes;
  const ObjText ours = parse_obj("m.obj", text, notes);
  const OtherReading other = read_by_other(text);
  CHECK(same_points(ours.v, other.points.vertices));
  CHECK(same_points(ours.vn, other.points.normals));
  CHECK(same_points(ours.vt, other.points.texcoords));
  CHECK(std::equal(ours.faces.begin.begin(), ours.faces.begin.end(), other.begin.begin(), other.begin.end()));
  REQUIRE(ours.faces.corners.size() == other.corners.size());
  for (std::size_t i = 0; i < other.corners.size(); ++i) {
    CAPTURE(i);
    CHECK(ours.faces.corners[i].v == other.corners[i].vertex_index);
    CHECK(ours.faces.corners[i].vt == other.corners[i].texcoord_index);
    CHECK(ours.faces.corners[i].vn == other.corners[i].normal_index);
  }

  const Mesh mesh = mesh_of_obj("m.obj", text, {});
  CHECK(mesh.triangles.size() == other.corners.size() - 2 * (other.begin.size() - 1));
  if (mesh.triangles.size() != other.begin.size() - 1) return; // a polygon may be cut in several ways
  for (std::size_t i = 0; i < other.corners.size(); ++i) {
    const std::size_t ours_at = mesh.triangles[i / 3][i % 3];
    const auto v = static_cast<std::size_t>(other.corners[i].vertex_index);
    CHECK(mesh.positions[ours_at] == ours.v[v]);
    if (const int vn = other.corners[i].normal_index; vn >= 0)
      CHECK(mesh.normals[ours_at] == ours.vn[static_cast<std::size_t>(vn)]);
  }
}

/// Statements in any order, as programs write them and as they might.
class RandomObj {
public:
  explicit RandomObj(Random& random) : random_(random) {
    line_end_ = random.below(3) == 0 ? "\r\n" : "\n";
    max_corners_ = random.below(2) == 0 ? 3 : 7;
    for (int i = 0; i < 4; ++i) points("v", v_, 3, random_.below(4) == 0 ? 4 : 3);
  }

  std::string text(int statements) {
    for (int i = 0; i < statements; ++i) statement();
    face(true);
    return text_;
  }

private:
  void word(const std::string& word) { text_ += word + (random_.below(8) == 0 ? "\t " : " "); }
  void end() { text_ += random_.below(8) == 0 ? " " + line_end_ : line_end_; }

  std::string number() {
    const double value = random_.sign() * random_.below(4096) / 64.0;
    std::ostringstream text;
    if (random_.below(6) == 0) text << std::scientific;
    text << value;
    return text.str();
  }

  void points(const char* keyword, int& count, int least, int most) {
    word(keyword);
    for (int i = least + random_.below(most - least + 1); i > 0; --i) word(number());
    end();
    ++count;
  }

  /// Counted from 1, or back from the last given.
  std::string index(int count) {
    const int i = random_.below(count);
    return std::to_string(random_.below(3) == 0 ? i - count : i + 1);
  }

  /// All corners of a face have one form: what to do with a face of several is a choice of our own.
  void face(bool must_be_one = false) {
    const bool vt = vt_ > 0 && random_.below(2) == 0, vn = vn_ > 0 && random_.below(2) == 0;
    if (v_ < 3 && !must_be_one) return;
    word("f");
    for (int corners = 3 + random_.below(max_corners_ - 2); corners > 0; --corners)
      word(index(v_) + (vt ? "/" + index(vt_) : vn ? "/" : "") + (vn ? "/" + index(vn_) : ""));
    end();
  }

  void statement() {
    switch (random_.below(12)) {
    case 0:
    case 1:
      return points("v", v_, 3, 3);
    case 2:
      return points("vt", vt_, 2, 3);
    case 3:
      return points("vn", vn_, 3, 3);
    case 4:
      text_ += "# f 1 2 3 and v 1 2 3" + line_end_;
      return;
    case 5:
      return end();
    case 6:
      text_ += (random_.below(2) == 0 ? "o part" : "g left right") + line_end_;
      return;
    case 7:
      text_ += (random_.below(2) == 0 ? "s off" : "s 3") + line_end_;
      return;
    case 8:
      text_ += (random_.below(2) == 0 ? "usemtl brass" : "l 1 2") + line_end_;
      return;
    default:
      return face();
    }
  }

  Random& random_;
  std::string text_, line_end_;
  int v_ = 0, vt_ = 0, vn_ = 0, max_corners_ = 3;
};

} // namespace

TEST_CASE("our reader and tinyobjloader find the same points, faces and indices in a random OBJ file") {
  for_all(300, [](Random& random) {
    const std::string text = RandomObj(random).text(40);
    CAPTURE(text);
    check_same(text);
  });
}

TEST_CASE("our reader and tinyobjloader find the same in an index to what comes later, and in a file of one line end") {
  check_same("f 1/2/3 2/1/1 3/2/2\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.5\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n");
  check_same("v 0 0 0\rv 1 0 0\rv 0 1 0\rf -3 -2 -1\r");
  check_same("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
}

TEST_CASE("our reader and tinyobjloader find the same in every OBJ file of the repository") {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(REFRASTER_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".obj" || entry.file_size() > 1 << 20) continue;
    CAPTURE(entry.path());
    ++files;
    check_same(read_file(entry.path().string(), "an OBJ file", 1 << 20));
  }
  CHECK(files >= 1);
}

TEST_CASE("our reader and tinyobjloader find the same in meshes that we write") {
  const TemporaryFolder folder;
  for (const Shape& shape : {Shape(SphereShape{7, 5}), Shape(CubeShape{}), Shape(TorusShape{5, 8, 0.4})}) {
    write_obj(folder / "m.obj", *make_mesh(shape));
    check_same(read_file(folder / "m.obj", "an OBJ file", 1 << 20));
  }
}

} // namespace refraster::test
