// Renders scenes and prints one hash for each scene and precision. Where the same source gives another hash, on another
// machine, from another compiler, with other flags, the promise of one image everywhere is broken.

#include <refraster/files.h>
#include <refraster/notes.h>
#include <refraster/render.h>

#include "math/precisions.h"
#include "tests/support/scenes/hashed_scenes.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <tuple>

namespace refraster::test {
namespace {

constexpr const char* usage = R"(usage: hash_scenes [--threads N] [--tile N] [SCENE.json ...]
       hash_scenes --golden FILE
The first form prints "hash precision scene" for the scenes built in and for the files named. The second compares the scenes
built in with FILE, for several numbers of threads and tile sizes, and fails where a hash differs.
)";

/// FNV-1a with 128 bits: Fowler, Noll, Vo, Eastlake, "The FNV non-cryptographic hash algorithm". Not against an
/// adversary: against a bit that differs.
class Fnv128 {
public:
  void add(const void* data, std::size_t bytes) {
    const auto* at = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) state_ = (state_ ^ at[i]) * prime;
  }
  template <class Value>
  void add(const Image<Value>& image) {
    for (const int side : {image.width, image.height, image.channels}) add(&side, sizeof side);
    add(image.values.data(), image.values.size() * sizeof(Value));
  }
  std::string text() const {
    std::array<char, 33> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx%016llx", static_cast<unsigned long long>(state_ >> 64),
                  static_cast<unsigned long long>(state_));
    return digits.data();
  }

private:
  using Word = unsigned __int128;
  static constexpr Word prime = (Word{1} << 88) + 0x13b;
  Word state_ = (Word{0x6c62272e07bb0142} << 64) + 0x62b821756295c58d;
};

std::string hash_of(const HashedScene& hashed, Precision precision, int threads, int tile_size) {
  RenderOptions options;
  options.width = hashed_width, options.height = hashed_height;
  options.precision = precision;
  options.samples = hashed.samples;
  options.threads = threads;
  options.tile_size = tile_size;
  options.want_radiance = true;
  options.transfer = Transfer::srgb; // linear levels follow from radiance
  options.aovs = {Aov::depth, Aov::normal, Aov::position, Aov::uv, Aov::albedo, Aov::triangle, Aov::object};
  const Frame frame = render(hashed.scene, options);
  Fnv128 hash;
  hash.add(frame.radiance);
  hash.add(frame.rgb8);
  for (const Image<float>& aov : frame.aovs) hash.add(aov);
  return hash.text();
}

/// body(precision) for each precision that promises bits.
template <class Body>
void for_each_precision(Body&& body) {
  // A fast precision promises no bits.
  const auto strict = [&](auto precision) {
    if constexpr (!is_fast<typename decltype(precision)::Number>) body(precision.id);
  };
  std::apply([&](auto... precision) { (strict(precision), ...); }, LanePrecisions{});
}

/// Both by "precision scene".
std::map<std::string, std::string> golden_hashes(const std::string& path) {
  std::ifstream file(path);
  std::map<std::string, std::string> result;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::string hash, precision, name;
    words >> hash >> precision >> name;
    result[precision + " " + name] = hash;
  }
  return result;
}

int compare(const std::string& path) {
  struct Way {
    int threads, tile_size;
  };
  // One change at a time, and some together.
  constexpr Way ways[] = {{1, 64}, {2, 64}, {3, 64}, {7, 64}, {1, 8}, {2, 16}, {3, 32}, {7, 128}};
  constexpr std::size_t shown = 10; // differences that are printed
  std::map<std::string, std::string> golden = golden_hashes(path);
  std::size_t compared = 0, different = 0;
  for (const HashedScene& hashed : hashed_scenes())
    for_each_precision([&](Precision precision) {
      const std::string key = std::string(name_of(precision)) + " " + hashed.name;
      for (const Way& way : ways) {
        const std::string hash = hash_of(hashed, precision, way.threads, way.tile_size);
        ++compared;
        if (golden[key] == hash) continue;
        if (++different > shown) continue;
        std::cout << key << ", " << way.threads << " threads, tiles of " << way.tile_size << ": " << hash
                  << ", expected " << (golden[key].empty() ? "none" : golden[key]) << "\n";
      }
    });
  std::cout << "renders: " << compared << ", with another hash than in " << path << ": " << different << "\n";
  return different == 0 ? 0 : 1;
}

void print(const std::vector<HashedScene>& scenes, int threads, int tile_size) {
  for (const HashedScene& hashed : scenes)
    for_each_precision([&](Precision precision) {
      std::cout << hash_of(hashed, precision, threads, tile_size) << " " << name_of(precision) << " " << hashed.name
                << "\n";
    });
}

int run(const std::vector<std::string>& arguments) {
  int threads = 1, tile_size = 64;
  std::vector<HashedScene> from_files;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const bool is_option = argument.starts_with("--");
    if (is_option && i + 1 == arguments.size()) return std::cerr << usage, 2;
    if (argument == "--golden") return compare(arguments[i + 1]);
    if (!is_option) {
      from_files.push_back({argument, read_scene(argument)});
      continue;
    }
    int& value = argument == "--threads" ? threads : tile_size;
    const std::string& text = arguments[++i];
    const bool is_number = std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{};
    if ((argument != "--threads" && argument != "--tile") || !is_number) return std::cerr << usage, 2;
  }
  print(hashed_scenes(), threads, tile_size);
  print(from_files, threads, tile_size);
  return 0;
}

} // namespace
} // namespace refraster::test

int main(int argc, char** argv) {
  try {
    return refraster::test::run({argv + 1, argv + argc});
  } catch (const refraster::InputError& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}
