// obj_reader FILE [THREADS]: reads a file once, as a program that has just started does, and prints milliseconds, those
// of CPU time, the most memory that it took in MiB, triangles and vertices, and a hash of the mesh.
// bench/obj_reader/run builds it with this code base's reader, with the one of an earlier revision, and with
// tinyobjloader: neither has threads, and tinyobjloader neither welds nor has normals.
#ifdef REFRASTER_TINYOBJ
#include <tiny_obj_loader.h>
#else
#include REFRASTER_OBJ_HEADER
#endif

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
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

/// Begins when it is made.
class Stopwatch {
public:
  void stop() { ms_ = now_ms() - ms_, cpu_ms_ = cpu_now_ms() - cpu_ms_; }
  double ms() const { return ms_; }
  double cpu_ms() const { return cpu_ms_; }

private:
  static double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  /// Of all threads, in the program and in the system.
  static double cpu_now_ms() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto milliseconds = [](const timeval& time) {
      return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
  }

  double ms_ = now_ms(), cpu_ms_ = cpu_now_ms();
};

#ifdef REFRASTER_TINYOBJ
Reading read(const char* path, int, Stopwatch& stopwatch) {
  tinyobj::attrib_t points;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  stopwatch = {};
  if (!tinyobj::LoadObj(&points, &shapes, &materials, &warning, &error, path)) throw std::runtime_error(error);
  stopwatch.stop();
  Reading result{0, points.vertices.size() / 3, 0};
  for (const tinyobj::shape_t& shape : shapes) result.triangles += shape.mesh.num_face_vertices.size();
  return result;
}
#else
Reading read(const char* path, [[maybe_unused]] int threads, Stopwatch& stopwatch) {
  stopwatch = {};
#ifdef REFRASTER_OBJ_THREADS
  const refraster::Mesh mesh = refraster::read_obj(path, {.threads = threads});
#else
  const refraster::Mesh mesh = refraster::read_obj(path);
#endif
  stopwatch.stop();
  Hash hash;
  hash.add(mesh.positions), hash.add(mesh.normals), hash.add(mesh.uvs), hash.add(mesh.triangles);
  return {mesh.triangles.size(), mesh.positions.size(), hash.value()};
}
#endif

} // namespace

int main(int count, char** words) try {
  if (count < 2 || count > 3) {
    std::fprintf(stderr, "usage: obj_reader FILE [THREADS]\n");
    return 2;
  }
  Stopwatch stopwatch;
  const Reading reading = read(words[1], count == 3 ? std::atoi(words[2]) : 0, stopwatch);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%.2f %.2f %.1f %zu %zu %016llx\n", stopwatch.ms(), stopwatch.cpu_ms(),
              static_cast<double>(usage.ru_maxrss) / 1024, reading.triangles, reading.vertices,
              static_cast<unsigned long long>(reading.hash));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
