// Hypotheses of what is wrong with an image, and how they are ranked: without OpenGL.

#include "math/vec.h"
#include "shading/srgb_curve.h"
#include "tests/support/scenes/fault_scenes.h"
#include "verify/hypotheses/hypothesis_list.h"
#include "verify/hypotheses/pixel_colours.h"
#include "verify/hypotheses/rank.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

using namespace refraster;
using namespace refraster::hypotheses;

namespace {

const Scene& plastics() {
  return fault_scenes()[0].scene;
}

constexpr int width = 96, height = 72;

Image<double> drawn(const Scene& scene, int samples = 1) {
  RenderOptions options;
  options.width = width, options.height = height, options.samples = samples;
  options.want_rgb8 = false, options.want_radiance_double = true;
  return render(scene, options).radiance_double;
}

Double3 at(const Image<double>& image, int x, int y) {
  const double* const p = image.at(x, y);
  return {p[0], p[1], p[2]};
}

/// As it is stored, in values of 8 bits.
Double3 rounded(Double3 value, Transfer transfer) {
  for (int c = 0; c < 3; ++c) {
    value[c] = std::clamp(value[c], 0.0, 1.0);
    if (transfer == Transfer::srgb) value[c] = srgb_encoded(value[c]);
    value[c] = std::nearbyint(255 * value[c]) / 255;
  }
  return value;
}

/// What is asked about an image of 8 bits that the product itself has drawn of another scene.
RankRequest request_about(const Scene& right, const Image<double>& actual, int samples = 1,
                          Transfer transfer = Transfer::linear) {
  RankRequest request{right, width, height, samples};
  request.transfer = transfer;
  const Image<double> reference = drawn(right, samples);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      JudgedPixel pixel{x, y, rounded(at(actual, x, y), transfer), rounded(at(reference, x, y), transfer)};
      pixel.half_width = Double3(0.6 / 255); // its actual value is right by half a level; the reference too
      const Double3 apart = pixel.actual - pixel.reference;
      const bool same = std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <= 1e-9;
      (same ? request.explained : request.unexplained).push_back(pixel);
    }
  // Of each kind no more than are looked at, from all over the image.
  for (auto* const pixels : {&request.unexplained, &request.explained}) {
    std::vector<JudgedPixel> some;
    const std::size_t step = pixels->size() / max_judged_pixels + 1;
    for (std::size_t i = 0; i < pixels->size(); i += step) some.push_back((*pixels)[i]);
    *pixels = some;
  }
  return request;
}

/// The first cause's keys.
std::vector<std::string> first_cause(const Ranking& ranking) {
  return ranking.causes.empty() ? std::vector<std::string>{} : ranking.causes.front().keys;
}

} // namespace

TEST_CASE("hypotheses have keys of their own, and each changes one step, but those of each object and each light") {
  std::set<std::string_view> keys;
  for (const Declared& entry : declared_hypotheses()) {
    CHECK_MESSAGE(keys.insert(entry.key).second, entry.key);
    Steps steps;
    entry.change(steps);
    int changed = 0;
    for_each_step([&](auto Steps::*member) { changed += !(steps.*member == Steps{}.*member); });
    const bool of_each = entry.concerns == Concerns::each_object || entry.concerns == Concerns::each_light;
    CHECK_MESSAGE(changed == (of_each ? 0 : 1), entry.key);
  }
  CHECK(keys.size() >= 60);
}

TEST_CASE("no two hypotheses are the same, and what is of each object or light is there for each") {
  const std::vector<Hypothesis> all = hypotheses_for(plastics());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK_FALSE(all[i].steps == Steps{});
    for (std::size_t j = i + 1; j < all.size(); ++j) CHECK_MESSAGE(!(all[i].steps == all[j].steps), all[i].key);
  }
  const auto count = [&](std::string_view key) {
    return std::count_if(all.begin(), all.end(), [&](const Hypothesis& h) { return h.key == key; });
  };
  CHECK(count("object_missing") == static_cast<std::ptrdiff_t>(plastics().objects.size()));
  CHECK(count("light_missing") == static_cast<std::ptrdiff_t>(light_count(plastics())));
  CHECK(count("merl_cosine_missing") == 0); // nothing measured is in the scene
}

TEST_CASE("every step is visited") {
  // A step that pairs do not know of would be lost from them.
  std::size_t bytes = 0;
  for_each_step([&]<class Value>(Value Steps::*) { bytes += sizeof(Value); });
  CHECK(bytes > sizeof(Steps) - alignof(Steps));
  CHECK(bytes <= sizeof(Steps));
}

TEST_CASE("docs/hypotheses.md has the table of the declared list") {
  std::ifstream file(REFRASTER_SOURCE_DIR "/docs/hypotheses.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  CHECK(page.find(hypotheses_markdown()) != std::string::npos);
}

TEST_CASE("a fault of one object is found, though others of the same kind are right, and the sentence names it") {
  Scene wrong = plastics();
  auto& torus = std::get<BlinnPhong>(wrong.objects[2].material.fragment_function);
  wrong.objects[2].material.fragment_function = Phong{torus};
  const RankRequest request = request_about(plastics(), drawn(wrong));
  const Ranking ranking = rank_hypotheses(request);
  CHECK(first_cause(ranking) == std::vector<std::string>{"phong_exchanged"});
  CHECK(ranking.objects == std::vector<std::uint32_t>{2});
  CHECK_FALSE(ranking.background);
  const std::string text = sentence(ranking.causes.at(0), ranking, plastics());
  CHECK(text.find("Phong's highlight where Blinn-Phong's is asked for") == 0);
  CHECK(text.find(" unexplained pixels of `torus`") != std::string::npos);
}

TEST_CASE("what no hypothesis covers is explained by none: no cause is named") {
  Scene wrong = plastics();
  for (Object& object : wrong.objects)
    std::visit(
        [](auto& function) {
          if constexpr (requires { function.kd; }) function.kd *= Double3(0.9, 0.8, 0.95), function.glossiness += 7;
        },
        object.material.fragment_function);
  const Ranking ranking = rank_hypotheses(request_about(plastics(), drawn(wrong)));
  CHECK(ranking.named() == nullptr);
  for (const Cause& cause : ranking.causes) CHECK_MESSAGE(cause.explained <= 0.5, cause.text);
}

TEST_SUITE("slow") {
  TEST_CASE(
      "with nothing changed a pixel has the frame's colour, whatever is seen there and with any number of samples") {
    for (const FaultScene& place : fault_scenes())
      for (const int samples : {1, 4}) {
        const Scene& scene = place.scene;
        const Image<double> frame = drawn(scene, samples);
        const WindowGeometry geometry(scene, width, height, 2);
        const Prepared prepared(scene);
        const Setting setting{scene, prepared, Transfer::linear, 1, std::vector<bool>(scene.objects.size(), true),
                              true};
        struct Pixel {
          int x, y;
          std::vector<Tap> taps;
        };
        std::vector<Pixel> pixels;
        std::vector<WindowPoint> points;
        for (int y = 0; y < height; y += 3)
          for (int x = y % 5; x < width; x += 5) {
            pixels.push_back({x, y, taps_of(View::right, scene, {width, height, samples}, {}, x, y)});
            for (const Tap& tap : pixels.back().taps) points.push_back(tap.seen);
          }
        const auto covering = geometry.covering(points);
        const std::span<const std::vector<Covering>> all(covering);
        std::size_t next = 0;
        int different = 0;
        for (const Pixel& pixel : pixels) {
          PixelColours colours(setting, geometry, pixel.taps, all.subspan(next, pixel.taps.size()));
          next += pixel.taps.size();
          const Double3 apart = colours.stored({}, 0) - at(frame, pixel.x, pixel.y);
          // Roundings of double only: of a power with exponents up to 45, and of the table's cells.
          different += !(std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <= 1e-10);
        }
        CHECK_MESSAGE(different == 0, std::string(place.name) << " with " << samples);
      }
  }

  TEST_CASE("an image that passes is given no fault") {
    for (const FaultScene& place : fault_scenes()) {
      const Ranking ranking = rank_hypotheses(request_about(place.scene, drawn(place.scene)));
      CHECK(ranking.causes.empty());
      CHECK(ranking.named() == nullptr);
      CHECK(ranking.tried == 0);
    }
  }

  TEST_CASE("the cause is found whatever the number of samples and the curve of the image") {
    Scene wrong = plastics();
    for (PointLight& light : wrong.point_lights) light.quadratic = 0;
    for (const int samples : {1, 4})
      for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
        const Ranking ranking = rank_hypotheses(request_about(plastics(), drawn(wrong, samples), samples, transfer));
        CHECK(first_cause(ranking) == std::vector<std::string>{"attenuation_without_square"});
        REQUIRE(ranking.named() != nullptr);
        CHECK(ranking.named()->explained > 0.98);
        CHECK(ranking.named()->kept > 0.98);
      }
  }

  TEST_CASE("two faults at once are found as a pair, and one of them that does not show leaves the other alone") {
    Scene wrong = plastics();
    for (PointLight& light : wrong.point_lights) light.quadratic = light.linear = 0, light.constant = 1;
    for (Object& object : wrong.objects)
      std::visit(
          [](auto& function) {
            if constexpr (requires { function.ka; }) function.ka *= 2.0;
          },
          object.material.fragment_function);
    const Ranking both = rank_hypotheses(request_about(plastics(), drawn(wrong)));
    REQUIRE(!both.causes.empty());
    CHECK(std::set<std::string>(both.causes[0].keys.begin(), both.causes[0].keys.end()) ==
          std::set<std::string>{"attenuation_missing", "ambient_twice"});
    CHECK(both.causes[0].explained > 0.97);

    // A material without an ambient term has none to be added twice.
    Scene dark = plastics(), wrong_dark = dark;
    for (Scene* const scene : {&dark, &wrong_dark})
      for (Object& object : scene->objects)
        std::visit(
            [](auto& function) {
              if constexpr (requires { function.ka; }) function.ka = Double3(0);
            },
            object.material.fragment_function);
    wrong_dark.point_lights = wrong.point_lights;
    CHECK(first_cause(rank_hypotheses(request_about(dark, drawn(wrong_dark)))) ==
          std::vector<std::string>{"attenuation_missing"});
  }

  TEST_CASE("the ranking does not depend on the number of threads") {
    Scene wrong = plastics();
    wrong.camera.fov_y_degrees /= 2;
    RankRequest request = request_about(plastics(), drawn(wrong));
    std::vector<std::string> told;
    for (const int threads : {1, 3}) {
      request.threads = threads;
      const Ranking ranking = rank_hypotheses(request);
      std::string text;
      for (const Cause& cause : ranking.causes) text += sentence(cause, ranking, plastics()) + "\n";
      told.push_back(text);
    }
    CHECK(told[0] == told[1]);
    CHECK(told[0].find("half the field of view: explains") == 0);
  }
}
