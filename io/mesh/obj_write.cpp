#include <refraster/files.h>

#include "io/file/atomic_file.h"

#include <array>
#include <charconv>

namespace refraster {
namespace {

/// Text that goes to the file in pieces of a megabyte, however large the mesh is.
class ObjWriter {
public:
  explicit ObjWriter(const std::string& path) : file_(path) {}

  ObjWriter& operator<<(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= 1 << 20) flush();
    return *this;
  }
  /// The shortest digits that read back as the same number.
  template <class Value>
  requires std::is_arithmetic_v<Value> ObjWriter& operator<<(Value value) {
    std::array<char, 32> text;
    const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return *this << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
  }
  void commit() {
    flush();
    file_.commit();
  }

private:
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }
  AtomicFile file_;
  std::string buffer_;
};

} // namespace

void write_obj(const std::string& path, const Mesh& mesh) {
  ObjWriter out(path);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Float3& p = mesh.positions[i];
    out << "v " << p.x << " " << p.y << " " << p.z;
    if (i < mesh.colours.size())
      out << " " << mesh.colours[i].x << " " << mesh.colours[i].y << " " << mesh.colours[i].z;
    out << "\n";
  }
  for (const Float2& uv : mesh.uvs) out << "vt " << uv.x << " " << uv.y << "\n";
  for (const Float3& n : mesh.normals) out << "vn " << n.x << " " << n.y << " " << n.z << "\n";
  for (const auto& triangle : mesh.triangles) {
    out << "f";
    const bool textured = has_uvs(mesh, triangle);
    for (const std::uint32_t vertex : triangle) {
      out << " " << vertex + 1 << "/";
      if (textured) out << vertex + 1;
      out << "/" << vertex + 1;
    }
    out << "\n";
  }
  out.commit();
}

} // namespace refraster
