// The story of a pixel, on scenes small enough to work out by hand.

#include "tests/support/text.h"
#include "verify/explain/explain_pixel.h"

#include <refraster/fragment_kit.h>
#include <refraster/mesh.h>

#include "tests/support/shading/merl_tables.h"
#include "verify/explain/story_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace own {
using namespace refraster;

/// Reflects what a light sends, halved, whatever its direction.
struct Halving {
  static constexpr std::string_view name = "halving";
  double glow = 0.25;
  static void fields(auto& self, auto&& field) { field("glow", self.glow, Range{}, "without any light"); }
};
template <Number T>
Rgb<T> ambient(const Halving& halving, const Fragment<T>&) {
  return Rgb<T>(as<T>(halving.glow));
}
template <Number T>
Rgb<T> reflected(const Halving&, const Fragment<T>&, const Incident<T>& light) {
  return light.radiance * as<T>(0.5);
}

} // namespace own

namespace {

using namespace refraster;

constexpr int side = 8; // pixels of the image

/// What a camera at the origin sees that looks along -z with a field of view of 90 degrees: clip coordinates are
/// (x, y, ., -z). The window's depth at a distance of w is 1.25 (1 - 1 / w).
Scene window_scene() {
  Scene scene;
  scene.camera.fov_y_degrees = 90;
  scene.camera.near = 1, scene.camera.far = 5;
  scene.background = Double3(0.75);
  return scene;
}

/// The point seen at window (x, y), in pixels, at a distance of w.
Float3 place(double x, double y, double w) {
  const double half = side / 2.0;
  return {static_cast<float>((x - half) / half * w), static_cast<float>((half - y) / half * w), static_cast<float>(-w)};
}

/// Three corners, counter-clockwise in the image if they are given so; shines in grey.
Object& add_triangle(Scene& scene, const std::array<Float3, 3>& corners, double grey) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions.assign(corners.begin(), corners.end());
  mesh->normals.assign(3, Float3(0, 0, 1));
  mesh->uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh->triangles = {{0, 1, 2}};
  Phong shining;
  shining.ka = Double3(grey), shining.kd = Double3(0), shining.ks = Double3(0);
  Object object;
  object.mesh = mesh;
  object.material.fragment_function = shining;
  scene.objects.push_back(object);
  return scene.objects.back();
}

/// It covers the whole image at a distance of w: the weights at window (x, y) are 1 less the others, x / 16 and
/// (8 - y) / 16.
Object& add_cover(Scene& scene, double w, double grey = 0.5) {
  return add_triangle(scene, {place(0, 8, w), place(16, 8, w), place(0, -8, w)}, grey);
}

PixelStory story_at(const Scene& scene, int x, int y, const std::optional<ActualPixel>& actual = {}, int samples = 1) {
  return explain_pixel(scene, {x, y, side, side, samples}, actual);
}

ActualPixel float_pixel(const Double3& radiance) {
  return {"actual.pfm", radiance, 1, StoredPrecision::floats(0x1p-24)};
}
ActualPixel level_pixel(const Double3& levels) {
  return {"actual.png", levels, 255, StoredPrecision::integers(255)};
}

/// A matt and shining surface under a point light and a direction light.
Scene lit_scene() {
  Scene scene = window_scene();
  Phong phong;
  phong.ka = Double3(0.03, 0.04, 0.05), phong.kd = Double3(0.3, 0.2, 0.1), phong.ks = Double3(0.25, 0.25, 0.25);
  phong.glossiness = 6;
  add_cover(scene, 2).material.fragment_function = phong;
  scene.point_lights = {{.position = {0.5, 1, 0}, .radiance = {1, 0.9, 0.7}, .quadratic = 0.25}};
  scene.direction_lights = {{{-0.5, -0.25, -1}, {0.2, 0.3, 0.5}}};
  return scene;
}
Phong& phong_of(Scene& scene) {
  return std::get<Phong>(scene.objects[0].material.fragment_function);
}

/// The likeliest explanation of what another scene has at the pixel (2, 3).
WouldBe likeliest(const Scene& scene, const Scene& other) {
  const ActualPixel actual = float_pixel(story_at(other, 2, 3).in(Precision::double_).radiance);
  const PixelStory story = story_at(scene, 2, 3, actual);
  REQUIRE_FALSE(story.actual->same);
  REQUIRE_FALSE(story.actual->would_be.empty());
  return story.actual->would_be.front();
}

} // namespace

TEST_CASE(
    "a sample's candidates are those that cover it, from near to far, with depth, weights and what became of them") {
  Scene scene = window_scene();
  add_cover(scene, 4);   // 1: hidden
  add_cover(scene, 10);  // 2: beyond the far plane
  add_cover(scene, 2);   // 3: seen
  add_cover(scene, 0.5); // 4: before the near plane
  add_triangle(scene, {place(0, -8, 3), place(16, 8, 3), place(0, 8, 3)}, 1).cull = Cull::back; // 5
  add_triangle(scene, {place(3, 8, 2), place(8, 8, 2), place(3, 0, 2)}, 1);                     // 6: beside it
  const PixelStory story = story_at(scene, 2, 3);
  REQUIRE(story.sample_stories.size() == 1);
  const std::vector<CoveringTriangle>& found = story.sample_stories[0].candidates;
  REQUIRE(found.size() == 5);
  constexpr std::uint32_t objects[] = {4, 3, 5, 1, 2};
  constexpr double distances[] = {0.5, 2, 3, 4, 10};
  constexpr CandidateFate fates[] = {CandidateFate::before_near, CandidateFate::seen, CandidateFate::culled,
                                     CandidateFate::hidden, CandidateFate::beyond_far};
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i].of.object == objects[i]);
    CHECK(found[i].fate == fates[i]);
    CHECK(found[i].side == (i == 2 ? Side::back : Side::front));
    CHECK(found[i].depth == doctest::Approx(1.25 * (1 - 1 / distances[i])));
    REQUIRE(found[i].weights);
    const std::array<double, 3>& w = *found[i].weights;
    CHECK(w[i == 2 ? 2 : 0] == doctest::Approx(0.5625));
    CHECK(w[1] == doctest::Approx(0.15625));
    CHECK(w[i == 2 ? 0 : 2] == doctest::Approx(0.28125));
  }
  CHECK(story.fragments.front().of.object == 3);
}

TEST_CASE("a triangle that is cut out there says so, with its opacity and the threshold") {
  Scene scene = window_scene();
  add_cover(scene, 2); // 1: cut out, or not
  add_cover(scene, 4); // 2: behind it
  Material& material = scene.objects[0].material;
  material.opacity_map.texture = std::make_shared<const Texture>(Texture{255, {TextureLevel{1, 1, {102, 102, 102}}}});
  Mesh mesh = *scene.objects[0].mesh;
  mesh.uvs.assign(mesh.positions.size(), Float2(0.5f));
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  const PixelStory cut = story_at(scene, 2, 3);
  CHECK(cut.sample_stories[0].candidates.at(0).fate == CandidateFate::cut_out);
  CHECK(cut.sample_stories[0].candidates.at(0).opacity.value().value == doctest::Approx(0.4));
  CHECK(cut.sample_stories[0].candidates.at(1).fate == CandidateFate::seen);
  CHECK(holds(story_text(cut), "0.4, below the threshold, 0.5"));
  material.opacity_threshold = 0.25;
  const PixelStory there = story_at(scene, 2, 3);
  CHECK(there.sample_stories[0].candidates.at(0).fate == CandidateFate::seen);
  CHECK(holds(story_text(there), "0.4, not below the threshold, 0.25"));
}

TEST_CASE("a triangle that crosses the eye plane is a candidate like any other") {
  Scene scene = window_scene();
  // A floor below the eye, from behind it to the far plane.
  add_triangle(scene, {Float3(-9, -1, 4), Float3(9, -1, 4), Float3(0, -1, -60)}, 0.5);
  const PixelStory story = story_at(scene, 4, 7);
  REQUIRE(story.fragments.size() == 1);
  const CoveringTriangle& candidate = story.sample_stories[0].candidates.front();
  CHECK(candidate.fate == CandidateFate::seen);
  // The ray through window (4.5, 7.5) falls by 7/8 of its way and meets the floor at w = 8/7: at x = 1/8 w.
  // Its far corner is snapped to the lattice, by half a subpixel at most: the ray's fall, 1 / w, by a quarter of that.
  constexpr double fall = 0.5 / 256 / 4, w = 8.0 / 7;
  CHECK(std::abs(candidate.depth - 1.25 * (1 - 1 / w)) <= 1.25 * fall);
  const Double3 at(w / 8, -1, -w);
  for (int c = 0; c < 3; ++c) CHECK(std::abs(story.fragments[0].position[c] - at[c]) <= w * w * fall);
}

TEST_CASE("where the background shows, the nearest outline is named with its distance in pixels") {
  Scene scene = window_scene();
  add_triangle(scene, {place(6, 16, 2), place(6, -8, 2), place(-8, 4, 2)}, 0.5).name = "left of it";
  PixelStory story = story_at(scene, 7, 3); // its centre is (7.5, 3.5)
  CHECK(story.fragments.empty());
  CHECK(story.background_samples == 1);
  REQUIRE(story.near_misses.size() == 1);
  CHECK(story.near_misses[0].dx == doctest::Approx(-1.5));
  CHECK(story.near_misses[0].dy == doctest::Approx(0));
  const std::string text = story_text(story);
  CHECK(holds(text, "shows the background"));
  CHECK(holds(text, "left of it"));
  CHECK(holds(text, "1.5 pixels"));

  scene.objects[0].cull = Cull::back; // its corners run counter-clockwise
  CHECK(story_at(scene, 7, 3).near_misses.size() == 1);
  Mesh turned = *scene.objects[0].mesh;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  scene.objects[0].mesh = std::make_shared<const Mesh>(turned);
  CHECK(story_at(scene, 7, 3).near_misses.empty());
  CHECK(holds(story_text(story_at(scene, 7, 3)), "No triangle of the scene covers"));
  add_cover(scene, 0.25);
  story = story_at(scene, 7, 3);
  CHECK(story.sample_stories[0].candidates[0].fate == CandidateFate::before_near);
  CHECK(holds(story_text(story), "none is drawn there"));
}

TEST_CASE(
    "the term that another renderer has otherwise is the likeliest explanation, and what it has is in the range") {
  const Scene scene = lit_scene();
  const auto explained = [&](auto&& change) {
    Scene other = scene;
    change(other);
    return likeliest(scene, other);
  };
  WouldBe found = explained([](Scene& s) { s.point_lights[0].quadratic = 0, s.point_lights[0].constant = 0; });
  CHECK(found.what == "the attenuation of point light 0");
  CHECK(found.remark == "as if it were not attenuated");
  CHECK((found.least[0] <= 1 && 1 <= found.most[0]));

  found = explained([](Scene& s) { phong_of(s).ka = Double3(0); });
  CHECK(found.what == "the ambient term, times");
  CHECK(found.remark == "as if it were left out");

  found = explained([](Scene& s) { phong_of(s).ka *= 2.0; });
  CHECK(found.what == "the ambient term, times");
  CHECK(found.remark == "as if it were added twice");

  found = explained([](Scene& s) { phong_of(s).ks = Double3(0); });
  CHECK(found.what == "the specular terms of all lights, times");
  CHECK(found.remark == "as if it were left out");

  found = explained([](Scene& s) { s.direction_lights.clear(); });
  CHECK(found.what == "all of direction light 0, times");
  CHECK(found.remark == "as if it were left out");

  found = explained([](Scene& s) { phong_of(s).glossiness = 11; });
  CHECK(found.what == "the glossiness");
  CHECK(found.now[0] == 6);
  CHECK((found.least[0] <= 11 && 11 <= found.most[0]));
  CHECK(found.most[0] - found.least[0] < 1e-3);

  found = explained([](Scene& s) { phong_of(s).kd.y = 0.3; });
  CHECK(found.what == "kd");
  CHECK((found.differs == std::array{false, true, false}));
  CHECK((found.least[1] <= 0.3 && 0.3 <= found.most[1]));

  found = explained([](Scene& s) { s.objects.clear(); });
  CHECK(found.what == "the background");
}

TEST_CASE("a term that is another in all triangles of an object is found where a pixel sees several of them") {
  Scene scene = lit_scene(), other = lit_scene();
  // A fold through the pixel's middle: half of the samples on either side.
  Mesh fold;
  fold.positions = {place(2.5, -8, 2), place(2.5, 16, 2), place(-16, 4, 3), place(24, 4, 3)};
  fold.normals = {{0, 0, 1}, {0, 0.2f, 1}, {-0.4f, 0, 1}, {0.5f, 0, 1}};
  fold.triangles = {{0, 2, 1}, {0, 1, 3}};
  for (Scene* const each : {&scene, &other}) each->objects[0].mesh = std::make_shared<const Mesh>(fold);
  phong_of(other).glossiness = 11;
  const ActualPixel actual = float_pixel(story_at(other, 2, 3, {}, 4).in(Precision::double_).radiance);
  const PixelStory story = story_at(scene, 2, 3, actual, 4);
  REQUIRE(story.fragments.size() == 2);
  const WouldBe& found = story.actual->would_be.front();
  CHECK(found.what == "the glossiness");
  CHECK((found.least[0] <= 11 && 11 <= found.most[0]));
}

TEST_CASE("what hides behind is an explanation, if the other renderer shows just that") {
  Scene scene = window_scene();
  add_cover(scene, 2, 0.5);
  add_cover(scene, 3, 0.125);
  const PixelStory story = story_at(scene, 2, 3, float_pixel(Double3(0.125)));
  const auto& found = story.actual->would_be;
  CHECK(std::any_of(found.begin(), found.end(), [](const WouldBe& w) {
    return w.kind == WouldBe::Kind::pixel && holds(w.what, "object 2") && holds(w.remark, "depth test");
  }));
}

TEST_CASE("a measured reflection without its cosine is named as that") {
  Scene scene = lit_scene();
  scene.direction_lights.clear();
  Merl merl;
  merl.table = table_of([](int h, int d, int p) { return Rgb<double>(0.5 + 0.01 * h, 0.4 + 0.01 * d, 0.001 * p); });
  scene.objects[0].material.fragment_function = merl;
  const FragmentStory fragment = story_at(scene, 2, 3).fragments.front();
  const LightStory& light = fragment.lights.front();
  REQUIRE(light.merl);
  const PixelStory story = story_at(scene, 2, 3, float_pixel(light.merl->f * light.arriving));
  const auto& found = story.actual->would_be;
  CHECK(std::any_of(found.begin(), found.end(), [](const WouldBe& w) {
    return w.what == "n.l of point light 0" && w.remark == "as if the cosine were left out";
  }));
  CHECK(holds(story_text(story), "f <n.l> C"));
}

TEST_CASE(
    "a level stands for all that rounds to it, the greatest for what is beyond too; floats for what rounds to them") {
  Scene scene = window_scene();
  add_cover(scene, 2, 100.4 / 255);
  CHECK(story_at(scene, 2, 3, level_pixel(Double3(100))).actual->same);
  CHECK_FALSE(story_at(scene, 2, 3, level_pixel(Double3(101))).actual->same);
  CHECK(story_at(scene, 2, 3, level_pixel(Double3(100))).actual->difference.x == doctest::Approx(-0.4));
  const auto exactly = static_cast<double>(static_cast<float>(100.4 / 255));
  CHECK(story_at(scene, 2, 3, float_pixel(Double3(exactly))).actual->same);
  CHECK_FALSE(story_at(scene, 2, 3, float_pixel(Double3(exactly * (1 + 0x1p-22)))).actual->same);
  Scene bright = window_scene();
  add_cover(bright, 2, 7);
  CHECK(story_at(bright, 2, 3, level_pixel(Double3(255))).actual->same);
  // Half of full scale is 188 through the sRGB curve: IEC 61966-2-1.
  Scene half = window_scene();
  add_cover(half, 2, 0.5);
  const PixelStory story = explain_pixel(half, {2, 3, side, side, 1, Transfer::srgb}, level_pixel(Double3(188)));
  CHECK(story.actual->same);
  CHECK(story.in(Precision::double_).levels == std::array{128, 128, 128});
  CHECK(story.in(Precision::double_).srgb == std::array{188, 188, 188});
}

TEST_CASE("where no single term can explain a value, that is said") {
  Scene scene = window_scene();
  Phong phong;
  phong.ka = Double3(0.25), phong.kd = Double3(0), phong.ks = Double3(0);
  add_cover(scene, 2).material.fragment_function = phong;
  const PixelStory story = story_at(scene, 2, 3, float_pixel(Double3(-0.5, 0.25, 0.25)));
  CHECK(story.actual->would_be.empty());
  CHECK(holds(story_text(story), "No single term explains it"));
}

TEST_CASE("of a fragment function of one's own each light's term is told, by asking with that light alone") {
  Scene scene = lit_scene();
  scene.objects[0].material.user_function = user_function(own::Halving{});
  const PixelStory story = story_at(scene, 2, 3);
  const FragmentStory& fragment = story.fragments.front();
  CHECK(fragment.user_function);
  CHECK(fragment.function == "halving");
  REQUIRE(fragment.parameters.size() == 1);
  CHECK(fragment.parameters[0].name == "glow");
  CHECK(fragment.ambient == Double3(0.25));
  REQUIRE(fragment.lights.size() == 2);
  for (const LightStory& light : fragment.lights)
    for (int c = 0; c < 3; ++c) CHECK(light.reflected[c] == doctest::Approx(light.arriving[c] / 2));
  CHECK(fragment.radiance == story.in(Precision::double_).radiance);
  CHECK(holds(story_text(story), "The formula is not known here"));
}

TEST_CASE("with several samples each is told by itself, and the pixel is their mean") {
  Scene scene = window_scene();
  add_triangle(scene, {place(2.5, 16, 2), place(2.5, -16, 2), place(-16, 0, 2)}, 0.25); // the left half of pixel 2
  const PixelStory story = story_at(scene, 2, 3, {}, 4);
  REQUIRE(story.sample_stories.size() == 4);
  REQUIRE(story.fragments.size() == 1);
  CHECK(story.fragments[0].samples == 2); // two of the four standard positions lie left of the middle
  CHECK(story.background_samples == 2);
  CHECK(story.in(Precision::double_).radiance.x == doctest::Approx((0.25 + 0.75) / 2));
  CHECK(holds(story_text(story), "the mean of 4 samples"));
}

TEST_CASE("undefined cases are counted where they are met, and told in words") {
  Scene scene = lit_scene();
  phong_of(scene).glossiness = 0;
  scene.direction_lights = {{{0, 0, 1}, Double3(1)}}; // from behind: r.v < 0
  const FragmentStory fragment = story_at(scene, 3, 3).fragments.front();
  CHECK(fragment.undefined[Undefined::zero_to_the_zero] == 1);
  CHECK(fragment.lights[1].undefined[Undefined::zero_to_the_zero] == 1);
  CHECK(holds(story_text(story_at(scene, 3, 3)), "zero_to_the_zero"));
}

TEST_CASE("bounds are told, if anyone gives them") {
  Scene scene = window_scene();
  add_cover(scene, 2);
  PixelStory story = story_at(scene, 2, 3);
  CHECK_FALSE(holds(story_text(story), "BOUNDS"));
  story.bounds = BoundsStory{Double3(0.25), Double3(0.75), {{"sample shift", 0.61}, {"pow", 0.3}}};
  const std::string text = story_text(story);
  CHECK(holds(text, "BOUNDS"));
  CHECK(holds(text, "61 %"));
}
