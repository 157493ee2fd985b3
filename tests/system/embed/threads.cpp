// embed_threads: as a program that embeds the library, from several threads at once: they render one scene that they
// share, and scenes of their own; read scenes, images and files that are refused; and write images. Each must get what
// one thread alone gets. Built with the preset tsan it shows data races; see run_tsan.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "math/exact.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/invariants.h"
#include "tests/support/scenes/random_scene.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>
#include <vector>

namespace {
using namespace refraster;
using namespace refraster::test;

constexpr int threads = 4, rounds = 6;

void require(const std::string& fault, const char* law) {
  if (fault.empty()) return;
  std::fprintf(stderr, "embed_threads: %s: %s\n", law, fault.c_str());
  std::exit(1);
}

struct Work {
  Scene scene;
  RenderOptions options;
  Frame alone; // as one thread renders it
};

Work make_work(std::uint64_t seed, int render_threads) {
  Random random(seed);
  Work work{random_scene(random), random_options(random), {}};
  work.options.threads = render_threads;
  work.alone = render(work.scene, work.options);
  return work;
}

/// What is said of a malformed file; "" if it is accepted.
std::string complaint(Reader reader, const std::string& path) {
  try {
    if (reader == Reader::scene) read_scene(path);
    else if (reader == Reader::image) read_image(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

struct Files {
  TemporaryFolder folder;
  std::vector<std::pair<Reader, std::string>> paths;
  std::vector<std::string> said; // of each, by one thread alone

  Files() {
    int number = 0;
    for (const MalformedInput& input : malformed_inputs()) {
      const bool is_small = std::all_of(input.files.begin(), input.files.end(),
                                        [](const TestFile& file) { return file.size_bytes < 1 << 16; });
      if (!is_small || (input.reader != Reader::scene && input.reader != Reader::image)) continue;
      const std::filesystem::path own = folder.path / std::to_string(number++);
      std::filesystem::create_directory(own);
      write_files(own, input.files);
      paths.emplace_back(input.reader, (own / input.input).string());
      said.push_back(complaint(input.reader, paths.back().second));
      require(said.back().empty() ? "accepted" : "", input.name.c_str());
    }
    write_files(folder.path, {{"s.json", scene_with("0.5 0.5 0.5", "1 1 1")}});
  }
};

/// The first functions of 60 digits that the program calls, in all threads at once: they look up limits that Boost makes at
/// their first use.
void first_functions_of_60_digits() {
  const auto values = [] {
    const Exact x(0.3);
    return std::vector{log2(x), exp2(x), pow(x, 2.5), atan2(x, Exact(0.7)), sqrt(x)};
  };
  std::vector<std::vector<Exact>> found(threads);
  std::vector<std::thread> all;
  for (std::vector<Exact>& own : found) all.emplace_back([&own, &values] { own = values(); });
  for (std::thread& thread : all) thread.join();
  for (const std::vector<Exact>& own : found)
    require(own == values() ? "" : "other values", "functions of 60 digits in several threads");
}

void one_thread(int number, const std::vector<Work>& shared, const Files& files) {
  Renderer renderer;
  Frame frame;
  for (int round = 0; round < rounds; ++round) {
    for (const Work& work : shared) {
      renderer.render(work.scene, work.options, frame);
      require(difference(frame, work.alone), "a shared scene");
    }
    const Scene own = read_scene(files.folder / "s.json");
    RenderOptions options;
    options.width = options.height = 32;
    options.threads = 1 + round % 2;
    options.want_radiance = true;
    const Frame drawn = render(own, options);
    const std::string path = files.folder / (std::to_string(number) + ".png");
    write_image(path, drawn.rgb8);
    const ImageFile read = read_image(path);
    require(std::equal(drawn.rgb8.values.begin(), drawn.rgb8.values.end(), read.values.values.begin(),
                       [](std::uint8_t a, float b) { return static_cast<float>(a) == b; })
                ? ""
                : "another image",
            "what was written is read");
    for (const char* const format : {".exr", ".hdr"}) {
      write_image(path + format, drawn.radiance);
      read_image(path + format);
    }
    for (std::size_t i = 0; i < files.paths.size(); ++i)
      require(complaint(files.paths[i].first, files.paths[i].second) == files.said[i] ? "" : files.said[i],
              "a refusal is worded as it was");
  }
}

} // namespace

int main() {
  first_functions_of_60_digits();
  std::vector<Work> shared;
  for (std::uint64_t seed = 0; seed < 24; ++seed) shared.push_back(make_work(seed, 1 + static_cast<int>(seed % 3)));
  const Files files;
  std::vector<std::thread> all;
  for (int number = 0; number < threads; ++number)
    all.emplace_back(one_thread, number, std::cref(shared), std::cref(files));
  for (std::thread& thread : all) thread.join();
  std::printf("%d threads, %d rounds: %zu shared scenes, %zu refused files: each as alone\n", threads, rounds,
              shared.size(), files.paths.size());
}
