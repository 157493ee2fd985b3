// obj_reader FILE: reads a file once, as a program that has just started does, and prints milliseconds, the most memory
// that it took in MiB, triangles and vertices, and a hash of the mesh. bench/obj_reader/run builds it with this code
// base's reader, with the one of an earlier revision, and with tinyobjloader, of which neither welds nor has normals.
#ifdef REFRASTER_TINYOBJ
#include <tiny_obj_loader.h>
#else
#include REFRASTER_OBJ_HEADER
#endif

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace {

/// FNV-1a, Fowler, Noll, Vo, over words of 32 bits.
class Hash {
public:
  template <class T>
  void add(const std::vector<T>& list) {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    const auto* const words = reinterpret_cast<const std::uint32_t*>(list.data());
    for (std::size_t i = 0; i < list.size() * (sizeof(T) / sizeof(std::uint32_t)); ++i)
      value_ = (value_ ^ words[i]) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

struct Reading {
  std::size_t triangles = 0, vertices = 0;
  std::uint64_t hash = 0;
};

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

#ifdef REFRASTER_TINYOBJ
Reading read(const char* path, double& ms) {
  tinyobj::attrib_t points;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  const double begin = now_ms();
  if (!tinyobj::LoadObj(&points, &shapes, &materials, &warning, &error, path)) throw std::runtime_error(error);
  ms = now_ms() - begin;
  Reading result{0, points.vertices.size() / 3, 0};
  for (const tinyobj::shape_t& shape : shapes) result.triangles += shape.mesh.num_face_vertices.size();
  return result;
}
#else
Reading read(const char* path, double& ms) {
  const double begin = now_ms();
  const refraster::Mesh mesh = refraster::read_obj(path);
  ms = now_ms() - begin;
  Hash hash;
  hash.add(mesh.positions), hash.add(mesh.normals), hash.add(mesh.uvs), hash.add(mesh.triangles);
  return {mesh.triangles.size(), mesh.positions.size(), hash.value()};
}
#endif

} // namespace

int main(int count, char** words) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: obj_reader FILE\n");
    return 2;
  }
  double ms = 0;
  const Reading reading = read(words[1], ms);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%.2f %.1f %zu %zu %016llx\n", ms, static_cast<double>(usage.ru_maxrss) / 1024, reading.triangles,
              reading.vertices, static_cast<unsigned long long>(reading.hash));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
