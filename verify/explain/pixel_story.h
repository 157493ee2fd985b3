#pragma once
// Everything that makes a pixel, as plain data: what story_text() and story_json() write. All colours and terms are
// linear; window positions are in pixels from the image's top left corner, y down.

#include <refraster/frame.h>
#include <refraster/material.h>
#include <refraster/render.h>
#include <refraster/scene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// What becomes of a triangle at a sample that it covers.
/// cut_out: where the pixel's centre is, the material's opacity is below its threshold.
enum class CandidateFate { seen, hidden, culled, cut_out, before_near, beyond_far };

template <>
struct EnumNames<CandidateFate> {
  static constexpr std::pair<CandidateFate, std::string_view> names[] = {{CandidateFate::seen, "seen"},
                                                                         {CandidateFate::hidden, "hidden"},
                                                                         {CandidateFate::culled, "culled"},
                                                                         {CandidateFate::cut_out, "cut out"},
                                                                         {CandidateFate::before_near, "before near"},
                                                                         {CandidateFate::beyond_far, "beyond far"}};
};

enum class Side { front, back }; // of a triangle; front: its corners run counter-clockwise in the image

template <>
struct EnumNames<Side> {
  static constexpr std::pair<Side, std::string_view> names[] = {{Side::front, "front"}, {Side::back, "back"}};
};

/// A triangle of the scene. Both numbers count from 1, as in the AOVs `object` and `triangle`.
struct NamedTriangle {
  std::uint32_t object = 0, triangle = 0;
  std::string name; // of the object; may be empty
};

/// How much of a surface is there, by its material's opacity_map, and how much must be.
struct OpacityStory {
  double value = 1, threshold = 0.5;
};

/// A triangle that covers a sample.
struct CoveringTriangle {
  NamedTriangle of;
  Side side = Side::front;
  CandidateFate fate = CandidateFate::hidden;
  double depth = 0; // in the window: 0 at the near plane, 1 at the far plane
  /// Perspective-correct weights of its corners at the sample, in the order of the mesh; nothing of a triangle that is
  /// not drawn and crosses the eye plane.
  std::optional<std::array<double, 3>> weights;
  /// What the pixel would be if this triangle were seen there: of one sample a pixel, and the nearest few.
  std::optional<Double3> radiance;
  std::optional<OpacityStory> opacity; // of a material with cut-outs, at the pixel's centre
};

/// One of the pixel's samples, and all triangles that cover it, from the nearest to the farthest.
struct SampleStory {
  double x = 0, y = 0;
  std::vector<CoveringTriangle> candidates;
};

/// A triangle that is drawn beside a pixel which shows the background.
struct NearMiss {
  NamedTriangle of;
  double dx = 0, dy = 0; // from the pixel's centre to the nearest point of the triangle's outline, pixels
};

/// A texel that was read, and the weight with which it enters the colour.
struct Texel {
  int level = 0, i = 0, j = 0; // mip level; column, row from v = 0 upward
  double weight = 0;
  Double3 value{0}; // 1 is full scale
};

/// How a texture was read.
struct TextureStory {
  TextureFilter filter = TextureFilter::bilinear;
  int width = 0, height = 0, levels = 1;
  /// Of TextureFilter::trilinear: log2 of the longer side of the pixel's footprint in texels, before it is clamped to
  /// the levels there are; and how uv changes by a pixel to the right and down.
  std::optional<double> level_of_detail;
  Double2 uv_right{0}, uv_down{0};
  std::vector<Texel> texels; // by level, row and column
};

/// A sample of a measured table that was read.
struct MerlTap {
  int theta_h = 0, theta_d = 0, phi_d = 0; // bins
  double weight = 0;                       // 0 where it was never measured; the others then count for more
  Double3 f{0};                            // 1/sr, as the table has it
  bool unmeasured = false;
};

/// How a measured table was read for one light.
struct MerlStory {
  double theta_h = 0, theta_d = 0, phi_d = 0; // radians
  double u = 0, v = 0, w = 0;                 // the same in bins
  std::vector<MerlTap> taps;
  Double3 f{0};            // the value, 1/sr
  bool unmeasured = false; // no tap was ever measured: f is 0 by convention
  bool lit = false;        // n.l > 0 and n.v > 0, else nothing is reflected
};

/// What microfacets make of one light: docs/microfacet.md.
struct MicrofacetStory {
  double alpha = 0;               // the width of the density
  double density = 0;             // D(h), per steradian
  double cosine_over_divisor = 0; // G2 n.l / (4 n.l n.v)
  Double3 fresnel{0};             // F(h.l)
  bool lit = false;               // n.l > 0 and n.v > 0, else nothing is reflected
};

/// The highlight of Phong or Blinn-Phong for one light.
struct LobeStory {
  std::string_view vector_name, cosine_name; // "r" and "r.v", or "h" and "n.h"
  Double3 vector{0};                         // r or h
  double cosine = 0;                         // r.v or n.h
  double value = 0;                          // <cosine>^s, after the specular gate
};

/// A parameter of a material or a light, as a scene file has it.
struct ParameterStory {
  std::string name;
  std::vector<double> numbers; // one, or three channels
  std::string word;            // of a choice
};

/// A comparison with a texel of a shadow map.
struct ShadowTapStory {
  int column = 0, row = 0; // from the lower left corner of the map, or of the face
  double weight = 1;
  std::optional<double> stored; // window depth; none beside the map, where all is lit
  bool lit = true;
};

/// How a shadow map was asked.
struct ShadowMapStory {
  std::string face;    // of a point light: "+x"
  double u = 0, v = 0; // in texels from the lower left corner
  double depth = 0;    // window depth that is compared, with the bias
  std::vector<ShadowTapStory> taps;
};

/// Whether a light with a shadow is seen from the surface.
struct ShadowStory {
  double visibility = 1;
  std::optional<ShadowMapStory> map;
  std::optional<NamedTriangle> between; // of an exact one that is 0: of the triangles that take it the one drawn first
  std::optional<Double3> reflected;     // below 1: what it would give without; of a formula that is known here
};

/// What one light gives.
struct LightStory {
  std::string type;      // "point light", "direction light"
  std::size_t index = 0; // in its list, from 0
  Double3 direction{0};  // l: unit, from the surface to the light
  double n_l = 0;        // n.l
  std::vector<ParameterStory> parameters;
  Double3 arriving{0};                         // C: radiance times attenuation times visibility
  std::optional<double> distance, attenuation; // of a light that has a place
  std::optional<LobeStory> lobe;
  /// Of a function with kd and ks, per unit of C: kd t <n.l> and ks <r.v>^s; of microfacets their two lobes.
  /// (diffuse + specular) C is `reflected`.
  std::optional<Double3> diffuse, specular;
  Double3 specular_map{1}; // what multiplies ks in it
  std::optional<MerlStory> merl;
  std::optional<MicrofacetStory> microfacet;
  Double3 reflected{0};              // toward the eye: what is added to the sum
  std::optional<ShadowStory> shadow; // of a light that has one
  UndefinedCounts undefined;
};

/// The same terms in 60 digits, rounded to double.
struct ExactTerms {
  Double3 ambient{0};
  std::vector<Double3> reflected; // in the order of FragmentStory::lights
  Double3 radiance{0};
};

/// How maps turn a normal: unit(m.x t + m.y b + m.z n), b = w cross(n, t).
struct NormalMapStory {
  Double3 unmapped{0};  // n, unit: the normal before
  Double3 tangent{0};   // t, as interpolated
  double handedness{0}; // w
  Double3 direction{0}; // m
  std::optional<TextureStory> normal_map, bump_map;
};

/// One triangle that the pixel sees, shaded once at the pixel's centre, in double.
struct FragmentStory {
  NamedTriangle of;
  int samples = 1;                 // that see it
  std::array<double, 3> weights{}; // of its corners, perspective-correct; below 0 where the centre lies beside it
  Double3 position{0};             // world space
  Double3 interpolated_normal{0};  // as it comes out of interpolation
  bool turned = false;             // all normals: a two-sided object shows its back
  std::optional<NormalMapStory> maps_of_normal;
  Double3 normal{0}; // n: unit
  Double3 to_eye{0}; // v: unit
  double n_v = 0;
  std::optional<Double2> uv; // as interpolated, not wrapped
  std::optional<TextureStory> texture;
  std::optional<Double3> vertex_colour; // of the mesh, interpolated
  Double3 texture_colour{1};            // t: the texture's times the vertices'; white without
  std::optional<TextureStory> specular_map, emissive_map, roughness_map, metallic_map;
  std::optional<Double3> specular_colour; // of specular_map, which multiplies ks
  std::optional<Double3> emission;        // light of its own, where the material has any
  std::string material;                   // its name, where a file has one
  std::string function;                   // "phong"
  std::vector<ParameterStory> parameters;
  bool user_function = false; // the formula is not known here: its lights were told apart by asking for them one by one
  Double3 ambient{0};
  std::vector<LightStory> lights; // in the order of the sum
  Double3 radiance{0};       // ambient, emission and all lights, summed in this order: what the frame has, bit for bit
  UndefinedCounts undefined; // all that was met, the lights' too
  ExactTerms exact;
};

/// The pixel in one precision.
struct PrecisionStory {
  Precision precision = Precision::double_;
  Double3 radiance{0};
  std::array<int, 3> levels{}; // linear: 255 times radiance, clamped and rounded
  std::array<int, 3> srgb{};   // through the sRGB curve first
};

/// What a term, or a factor that all channels share, would have to be for the actual value to be right, everything else
/// staying as it is.
struct WouldBe {
  /// factor: one number for all three channels, in now[0], least[0], most[0]; channels: each its own; pixel: nothing of
  /// a formula, but another surface or the background.
  enum class Kind { factor, channels, pixel };
  Kind kind = Kind::channels;
  std::string what;                      // "attenuation of point light 0"
  std::array<double, 3> now{};           // what it is
  std::array<double, 3> least{}, most{}; // between which it would have to be
  std::array<bool, 3> differs{};         // channels in which it would have to be another
  std::string remark;                    // "as if it were left out"
};

/// The value that another renderer has at the pixel.
struct ActualStory {
  std::string path;
  Double3 stored{0};             // as the file has it
  double full_scale = 255;       // that means 1
  Double3 least{0}, most{0};     // linear values that the stored ones may stand for
  Double3 levels{0};             // stored, in levels of 1/255
  Double3 difference{0};         // actual less double, in levels before rounding
  bool same = false;             // double lies within what the stored values stand for, in all channels
  std::vector<WouldBe> would_be; // likeliest first
};

/// What a correct device may have at the pixel, and why it is no narrower: filled in by whoever knows bounds.
struct BoundsStory {
  struct Cause {
    std::string what;    // "sample shift"
    double fraction = 0; // of the width
  };
  Double3 least{0}, most{0};
  std::vector<Cause> causes; // largest first
};

/// The whole story.
struct PixelStory {
  std::string scene; // path, as given
  int x = 0, y = 0, width = 0, height = 0, samples = 1;
  Transfer transfer = Transfer::linear; // of the levels that are told first
  std::vector<SampleStory> sample_stories;
  std::vector<FragmentStory> fragments; // in the order of the first sample that sees each
  Double3 background{0};
  int background_samples = 0;             // that see no triangle
  std::vector<NearMiss> near_misses;      // where all do, nearest first
  std::vector<PrecisionStory> precisions; // in the order of the enum
  std::optional<ActualStory> actual;
  std::optional<BoundsStory> bounds;

  const PrecisionStory& in(Precision precision) const { return precisions[static_cast<std::size_t>(precision)]; }
};

} // namespace refraster
