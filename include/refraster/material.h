#pragma once
// Materials: which fragment function shades a surface, and its parameters as plain data. The formulas are in the
// fragment kit (shading/phong.h …).

#include <refraster/fields.h>
#include <refraster/memory.h>
#include <refraster/texture.h>
#include <refraster/vector.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace refraster {

/// f(theta_h, theta_d, phi_d) in 1/sr, without cosine, for red, green and blue. A sample with a negative channel was
/// never measured. Matusik et al., "A data-driven reflectance model", 2003; half and difference angles after
/// Rusinkiewicz, "A new change of variables for efficient BRDF representation", 1998.
///
/// Immutable. Copies in other precisions are made when they are first asked for, once, whatever threads ask: a frame
/// pays only for those it reads.
class MerlTable {
public:
  static constexpr int theta_h_bins = 90; ///< from 0 to pi/2, in steps of the square root
  static constexpr int theta_d_bins = 90; ///< from 0 to pi/2
  static constexpr int phi_d_bins = 180;  ///< from 0 to pi
  /// Of three channels each.
  static constexpr std::size_t samples = std::size_t{90} * 90 * 180;

  /// `rgb` holds 3 * samples finite values, interleaved, phi_d fastest, then theta_d, then theta_h. Throws
  /// std::invalid_argument for another number of values.
  explicit MerlTable(PaddedVector<double> rgb);
  ~MerlTable();

  /// Index of the first channel of a sample. 0 <= h, d < 90, 0 <= p < 180.
  static constexpr int offset(int h, int d, int p) { return 3 * ((h * theta_d_bins + d) * phi_d_bins + p); }

  // What the formulas of the fragment kit read.

  /// The values as a precision reads them: in double; in float, each rounded once; or in Half (math/half.h), in units
  /// of unit<Half>(), each rounded once. A sample that was never measured has -1 in all channels; in double, what the
  /// file has.
  template <class Stored>
  const Stored* values() const;

  /// The f that a stored value of 1 means. Of double and float 1; of Half a power of two, chosen so that the greatest
  /// value of the table lies in (32752, 65504]: a metal's highlight is brighter than the largest half, and what is
  /// 2^28 times darker still has all its digits.
  template <class Stored>
  double unit() const;

  /// g = log2(1 + f / log_epsilon) >= 0 in double or float; -1 in all channels of a sample that was never measured.
  /// Not in Half: g goes up to 30, and half's 11 bits of that are a worse f than half's 11 bits of f.
  template <class F>
  const F* log_values() const;

  /// Below this value, in 1/sr, interpolating logarithms turns into interpolating values: it keeps the logarithm of
  /// black finite. Black paint has f near 1e-2, so that nothing measured is that dark.
  static constexpr double log_epsilon = 1e-4;

  /// f of a sample as the file has it. 0 <= h, d < 90, 0 <= p < 180.
  Rgb<double> sample(int h, int d, int p) const {
    const double* at = doubles_.data() + offset(h, d, p);
    return {at[0], at[1], at[2]};
  }

private:
  struct Copies;

  PaddedVector<double> doubles_;
  std::unique_ptr<Copies> copies_;
};

/// Whether a light at or below the horizon (n.l <= 0) still makes a highlight. The textbook formula keeps it.
enum class SpecularGate { open, cut_below_horizon };

template <>
struct EnumNames<SpecularGate> {
  static constexpr std::pair<SpecularGate, std::string_view> names[] = {
      {SpecularGate::open, "false"},
      {SpecularGate::cut_below_horizon, "true"},
  };
};

/// The parameters that Phong and Blinn-Phong share.
struct PhongParameters {
  Double3 ka{0.05};                                ///< ambient reflection, linear; each channel >= 0
  Double3 kd{1};                                   ///< diffuse reflection
  Double3 ks{1};                                   ///< specular reflection
  double glossiness = 8;                           ///< s, the exponent of the highlight; >= 0
  SpecularGate specular_gate = SpecularGate::open; ///< whether a light below the horizon makes a highlight

  /// Declares the parameters: <refraster/fields.h>.
  static void fields(auto& self, auto&& field) {
    field("ka", self.ka, Range{}, "ambient reflection, r g b");
    field("kd", self.kd, Range{}, "diffuse reflection, r g b");
    field("ks", self.ks, Range{}, "specular reflection, r g b");
    field("glossiness", self.glossiness, Range{}, "exponent of the highlight");
    field("specular_gate", self.specular_gate, Range{}, "true: no highlight from a light at or below the horizon");
  }
};

/// Phong reflection: radiance toward the eye from one light,
///
///     (kd t <n.l> + ks <r.v>^s) C,     r = 2 (n.l) n - l,     <x> = max(x, 0),
///
/// t the texture colour: the highlight is not coloured by it. Phong, "Illumination for computer generated pictures",
/// 1975.
struct Phong : PhongParameters {
  /// In a scene file.
  static constexpr std::string_view name = "phong";
  /// Of names of GLSL files that mean it.
  static constexpr std::string_view shader_stems[] = {"phong_fs", "phong"};
};

/// Blinn-Phong reflection: radiance toward the eye from one light,
///
///     (kd t <n.l> + ks <n.h>^s) C,     h = (l + v) / |l + v|,     <x> = max(x, 0).
///
/// Blinn, "Models of light reflection for computer synthesized pictures", 1977.
struct BlinnPhong : PhongParameters {
  /// In a scene file.
  static constexpr std::string_view name = "blinn_phong";
  /// Of names of GLSL files that mean it.
  static constexpr std::string_view shader_stems[] = {"blinn_phong_fs", "blinn_fs", "blinn_phong", "blinn"};
};

/// How a MERL table is read between its samples. docs/merl.md shows what each is for.
///   nearest         the sample of the bin that holds the point
///   trilinear       linear in u, v and w, samples at the centres of their bins: the default
///   trilinear_edge  the same with samples at the starts of their bins, as several published readers have it
///   trilinear_log   the same as trilinear on g = log2(1 + f / epsilon)
///   tricubic_log    Catmull-Rom splines in u, v and w on g
/// phi_d wraps from 179 to 0, since it is periodic in pi; theta_h and theta_d are clamped. Samples that were never
/// measured are left out and the weights of the others scaled up to a sum of 1.
enum class MerlLookup { nearest, trilinear, trilinear_edge, trilinear_log, tricubic_log };

template <>
struct EnumNames<MerlLookup> {
  static constexpr std::pair<MerlLookup, std::string_view> names[] = {
      {MerlLookup::nearest, "nearest"},
      {MerlLookup::trilinear, "trilinear"},
      {MerlLookup::trilinear_edge, "trilinear-edge"},
      {MerlLookup::trilinear_log, "trilinear-log"},
      {MerlLookup::tricubic_log, "tricubic-log"},
  };
};

/// How the azimuth of the difference vector is computed. All agree in exact arithmetic.
enum class MerlAngles { closed, rotation, frame };

template <>
struct EnumNames<MerlAngles> {
  static constexpr std::pair<MerlAngles, std::string_view> names[] = {
      {MerlAngles::closed, "closed"},
      {MerlAngles::rotation, "rotation"},
      {MerlAngles::frame, "frame"},
  };
};

/// Measured reflection: radiance toward the eye from one light,
///
///     f(l, v) <n.l> C,     0 unless n.l > 0 and n.v > 0,     <x> = max(x, 0).
///
/// f is read from a MERL table. There is no ambient term, and the texture is not used.
struct Merl {
  /// In a scene file.
  static constexpr std::string_view name = "merl";
  /// Of names of GLSL files that mean it.
  static constexpr std::string_view shader_stems[] = {"merl_fs", "merl"};

  std::shared_ptr<const MerlTable> table;    ///< not null when shading
  MerlLookup lookup = MerlLookup::trilinear; ///< between its samples
  MerlAngles angles = MerlAngles::closed;    ///< how the place in it is computed

  /// Declares the parameters: <refraster/fields.h>.
  static void fields(auto& self, auto&& field) {
    field("merl_lookup", self.lookup, Range{}, "how the table is read between its samples");
    field("merl_angles", self.angles, Range{}, "how the half and difference angles are computed");
  }
};

/// By what law a smooth boundary reflects, of the fraction of a Microfacet's surface that is metal and of the rest.
///   schlick     Schlick's for both: f0 of the metal is the base colour, of the rest that of its refractive index
///   dielectric  Schlick's for the metal, the exact one of dielectrics for the rest
///   conductor   the exact ones: that of conductors, by eta and k, for the metal
enum class MicrofacetFresnel { schlick, dielectric, conductor };

template <>
struct EnumNames<MicrofacetFresnel> {
  static constexpr std::pair<MicrofacetFresnel, std::string_view> names[] = {
      {MicrofacetFresnel::schlick, "schlick"},
      {MicrofacetFresnel::dielectric, "dielectric"},
      {MicrofacetFresnel::conductor, "conductor"},
  };
};

/// Reflection by microfacets, with the parameters of glTF's metallic-roughness: radiance toward the eye from one light,
///
///     (D(h) G2(l, v) F(h.l) / (4 n.l n.v) + (1 - m) T(n.l) T(n.v) b t / pi) <n.l> C,     0 unless n.l > 0 and n.v > 0,
///
/// D being GGX of width alpha = roughness^2, G2 Smith's masking and shadowing with correlated heights, F the Fresnel
/// factor, m the metallic fraction, b the base colour, t the texture colour, and T what a smooth boundary lets through.
/// There is no ambient term. docs/microfacet.md has the formulas and their sources.
struct Microfacet {
  /// In a scene file.
  static constexpr std::string_view name = "microfacet";
  /// Of names of GLSL files that mean it.
  static constexpr std::string_view shader_stems[] = {"microfacet_fs", "microfacet", "pbr_fs", "pbr"};
  /// A roughness below it, the product with its map, counts as it: of a mirror a light without size shows nothing.
  static constexpr double min_roughness = 1e-4;

  Double3 base_color{1};           ///< linear, each channel in [0, 1]
  double metallic = 1;             ///< m, the fraction that is metal, in [0, 1]
  double roughness = 1;            ///< in [0, 1]; its square is alpha
  double ior = 1.5;                ///< refractive index of what is not metal, in [1, 10]
  Double3 eta{0.143, 0.375, 1.44}; ///< refractive index of the metal, with `conductor`; as it is here, gold's
  Double3 k{3.98, 2.39, 1.6};      ///< its extinction coefficient
  MicrofacetFresnel fresnel = MicrofacetFresnel::schlick; ///< by what law a smooth boundary reflects

  /// Declares the parameters: <refraster/fields.h>.
  static void fields(auto& self, auto&& field) {
    field("base_color", self.base_color, Range{0, 1}, "colour of the diffuse light, and of metal, r g b");
    field("metallic", self.metallic, Range{0, 1}, "the fraction of the surface that is metal");
    field("roughness", self.roughness, Range{0, 1}, "the square root of the width of the highlight; 1e-4 at least");
    field("fresnel", self.fresnel, Range{}, "by what law a smooth boundary reflects");
    field("ior", self.ior, Range{.min = 1, .max = 10, .need = Need::optional}, "refractive index of what is not metal");
    const Range above_0{0, 100, Ends::excluded, Zero::included, Need::optional};
    field("eta", self.eta, above_0, "refractive index of metal, r g b, for `conductor`");
    field("k", self.k, Range{.max = 100, .need = Need::optional}, "extinction coefficient of metal, r g b, likewise");
  }
};

/// Every fragment function of the library. The order is that of `refraster list fragment-functions`; nothing else
/// depends on it. The formula of each is in shading/fragment_functions.h.
using FragmentFunction = std::variant<Phong, BlinnPhong, Merl, Microfacet>;

struct FragmentBatch; // of the fragment kit

/// A fragment function of one's own: made by user_function() of the fragment kit, from a block of parameters and a
/// formula like those above. Immutable while a frame is rendered; materials may share it.
class UserFunction {
public:
  virtual ~UserFunction() = default;
  /// The word in "fragment_function" of a scene file.
  virtual std::string_view name() const = 0;
  /// Shows each parameter to `visitor`, which may change it.
  virtual void fields(FieldVisitor& visitor) = 0;
  /// With parameters of its own.
  virtual std::shared_ptr<UserFunction> copy() const = 0;
  /// Shades many fragments at once. Called by the library, from several threads. Throws std::invalid_argument for a
  /// number that it was not compiled for: one built with an older kit.
  virtual void shade(const FragmentBatch& batch) const = 0;
};

/// What an object's surface is like. The maps are read where `texture_slots` says.
struct Material {
  FragmentFunction fragment_function = {};                ///< with its parameters
  std::shared_ptr<const UserFunction> user_function = {}; ///< shades instead of it, if not null
  TextureMap diffuse_map = {};                            ///< t of the formulas
  TextureMap specular_map = {};                           ///< of Phong and Blinn-Phong: multiplies ks
  TextureMap emissive_map = {};                           ///< of all but Merl: multiplies `emissive`
  TextureMap roughness_map = {};                          ///< of Microfacet: red of what is read multiplies roughness
  TextureMap metallic_map = {};                           ///< of Microfacet: and metallic
  TextureMap opacity_map = {};                            ///< of any function: red is how much of the surface is there
  /// Where the opacity at a pixel's centre, in double, is less than this, the triangle has none of the pixel's samples,
  /// and what is behind it is seen. In [0, 1].
  double opacity_threshold = 0.5;
  TextureMap normal_map = {}; ///< of all functions: normals in the frame of the tangents, docs/normal-maps.md
  TextureMap bump_map = {};   ///< of all functions: heights, in red, by whose slopes normals are turned
  double normal_scale = 1;    ///< of normal_map: multiplies red and green, less 1/2: its strength; finite
  double bump_scale = 1;      ///< of bump_map: height of white over black, in texels; finite
  /// Light of its own, of all but Merl: added to the ambient term. Linear; each channel >= 0.
  Double3 emissive{0};

  std::string name = {}; ///< for reports: of a file's its own

  /// What is measured of it; null if another function shades it.
  const Merl* measured() const { return user_function ? nullptr : std::get_if<Merl>(&fragment_function); }

  /// What is microfacets of it; null if another function shades it.
  const Microfacet* microfacets() const {
    return user_function ? nullptr : std::get_if<Microfacet>(&fragment_function);
  }

  /// Whether there is more to its fragments than the parameters and t: a colour of highlights, a roughness or a
  /// metallic fraction that varies, or light of its own.
  bool has_fragment_maps() const {
    if (user_function || measured()) return false;
    const bool varies = microfacets() ? roughness_map.texture || metallic_map.texture : specular_map.texture != nullptr;
    return varies || emissive != Double3(0);
  }

  /// Whether parts of it may be cut out: where its opacity is below the threshold.
  bool has_cut_outs() const { return opacity_map.texture && opacity_threshold > 0; }

  /// Whether maps turn its normals: on meshes with tangents.
  bool turns_normals() const { return normal_map.texture || bump_map.texture; }

  /// Of what shades it.
  std::string_view function_name() const {
    if (user_function) return user_function->name();
    return std::visit([](const auto& function) { return function.name; }, fragment_function);
  }
};

/// What a texture's values are: r g b, or one number, three times the same.
enum class SlotValue { colour, scalar };

/// What a texture changes: colours, as a fragment function has them; or the surface itself, whatever the function.
enum class SlotUse { colours, surface };

/// A texture that a material may have. Where there is none, or no texture coordinates, it is `blank`.
struct TextureSlot {
  TextureMap Material::*map = nullptr;     ///< the member that holds it
  Double3 Material::*multiplied = nullptr; ///< the member that it multiplies, if the material itself has that
  std::string_view name = {};              ///< in faults and, in capitals, in our GLSL
  std::string_view key = {};               ///< in a scene file: a path, or an object with all that a TextureMap has
  std::string_view file_key = {};          ///< the short form of it, its image; empty: there is none
  std::string_view filter_key = {};        ///< beside that its filter; the member's value if left out
  std::string_view sampler = {};           ///< the uniform
  std::string_view place = {};             ///< the uniform of its scale and offset, in this order
  std::string_view meaning = {};           ///< of the image, for the documentation
  SlotValue value = SlotValue::colour;     ///< what is read of the image
  SlotUse use = SlotUse::colours;          ///< what it changes
  ScalarChannel channel = ScalarChannel::automatic; ///< of scalar values: which they are, where nothing else is said
  Double3 blank{1}; ///< what stands for it where there is none: white, or what turns no normal
};

/// Every texture that a material may have. Scene files and their documentation, loading, checks and OpenGL's texture
/// units follow from this list; what a texture's colour is for is in raster/shade/shade_packet.h, what an opacity is
/// for in raster/shade/opacity.h.
inline constexpr std::array texture_slots{
    TextureSlot{&Material::diffuse_map, nullptr, "texture", "diffuse_map", "texture_file_path", "texture_filter", "tex",
                "texPlace", "a `.png`, `.jpg`, `.tga` or `.bmp` image; not loaded for `merl`"},
    TextureSlot{&Material::specular_map,
                nullptr,
                "specular_map",
                "specular_map",
                {},
                {},
                "specularTex",
                "specularTexPlace",
                "multiplies `ks`; for `phong` and `blinn_phong`"},
    TextureSlot{&Material::emissive_map,
                &Material::emissive,
                "emissive_map",
                "emissive_map",
                {},
                {},
                "emissiveTex",
                "emissiveTexPlace",
                "multiplies `emissive`; not for `merl`"},
    TextureSlot{&Material::opacity_map,
                nullptr,
                "opacity_map",
                "opacity_map",
                {},
                {},
                "opacityTex",
                "opacityTexPlace",
                "how much of the surface is there: below `opacity_threshold` it is cut out",
                SlotValue::scalar,
                SlotUse::surface},
    TextureSlot{.map = &Material::normal_map,
                .name = "normal_map",
                .key = "normal_map",
                .sampler = "normalTex",
                .place = "normalTexPlace",
                .meaning = "turns normals: red along u, green along v, blue away from the surface, 1/2 is 0",
                .use = SlotUse::surface,
                .blank = {0.5, 0.5, 1}},
    TextureSlot{.map = &Material::bump_map,
                .name = "bump_map",
                .key = "bump_map",
                .sampler = "bumpTex",
                .place = "bumpTexPlace",
                .meaning = "turns normals by the slopes of its heights",
                .value = SlotValue::scalar,
                .use = SlotUse::surface,
                .channel = ScalarChannel::luminance},
    TextureSlot{.map = &Material::roughness_map,
                .name = "roughness_map",
                .key = "roughness_map",
                .sampler = "roughnessTex",
                .place = "roughnessTexPlace",
                .meaning = "multiplies `roughness`; for `microfacet`; read in green, as glTF packs it",
                .value = SlotValue::scalar,
                .channel = ScalarChannel::green},
    TextureSlot{.map = &Material::metallic_map,
                .name = "metallic_map",
                .key = "metallic_map",
                .sampler = "metallicTex",
                .place = "metallicTexPlace",
                .meaning = "multiplies `metallic`; for `microfacet`; read in blue, as glTF packs it",
                .value = SlotValue::scalar,
                .channel = ScalarChannel::blue}};

/// The slot of this member.
constexpr TextureSlot declared(TextureMap Material::*map) {
  for (const TextureSlot& slot : texture_slots)
    if (slot.map == map) return slot;
  return {};
}

/// Whether a texture that the material may have is one that its fragment function shows.
inline bool shows(const Material& material, const TextureSlot& slot) {
  if (slot.use == SlotUse::surface) return true;
  const bool of_microfacets = slot.map == &Material::roughness_map || slot.map == &Material::metallic_map;
  if (of_microfacets || slot.map == &Material::specular_map)
    return of_microfacets == (material.microfacets() != nullptr) && !material.measured();
  return !material.measured();
}

/// Calls visit(map) with each texture that the material has.
void for_each_texture(auto& material, auto&& visit) {
  for (const TextureSlot& slot : texture_slots)
    if ((material.*slot.map).texture) visit(material.*slot.map);
}

/// Whether has(map) holds for any of them.
bool any_texture(const Material& material, auto&& has) {
  bool any = false;
  for_each_texture(material, [&](const TextureMap& map) { any = any || has(map); });
  return any;
}

/// Whether it has any.
inline bool is_textured(const Material& material) {
  return any_texture(material, [](const TextureMap&) { return true; });
}

} // namespace refraster
