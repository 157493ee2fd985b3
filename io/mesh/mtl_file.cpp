#include "io/mesh/mtl_file.h"

#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/file/number_text.h"
#include "io/file/text.h"
#include "io/file/text_kind.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace refraster {
namespace {

constexpr std::string_view blanks = " \t\v\f";

/// The first word, which goes with the blanks after it.
std::string_view take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end), blanks);
  return word;
}

// What a key sets.
constexpr std::pair<std::string_view, std::optional<Double3> MeshMaterial::*> colours[] = {
    {"Ka", &MeshMaterial::ambient},
    {"Kd", &MeshMaterial::diffuse},
    {"Ks", &MeshMaterial::specular},
    {"Ke", &MeshMaterial::emissive},
};
constexpr std::pair<std::string_view, std::optional<double> MeshMaterial::*> numbers[] = {
    {"Ns", &MeshMaterial::exponent},
    {"d", &MeshMaterial::dissolve},
    {"Pr", &MeshMaterial::roughness},
    {"Pm", &MeshMaterial::metallic},
};
constexpr std::pair<std::string_view, MeshTexture MeshMaterial::*> maps[] = {
    {"map_Ka", &MeshMaterial::ambient_map},  {"map_Kd", &MeshMaterial::diffuse_map},
    {"map_Ks", &MeshMaterial::specular_map}, {"map_Ke", &MeshMaterial::emissive_map},
    {"map_d", &MeshMaterial::dissolve_map},  {"map_Bump", &MeshMaterial::bump_map},
    {"map_bump", &MeshMaterial::bump_map},   {"bump", &MeshMaterial::bump_map},
    {"norm", &MeshMaterial::normal_map},     {"map_Pr", &MeshMaterial::roughness_map},
    {"map_Pm", &MeshMaterial::metallic_map},
};
/// Of light that goes through the surface, which stays opaque, and how sharp reflections of other things are.
constexpr std::string_view without_part[] = {"Ni", "Tf", "sharpness"};
/// Of the format, or its extension for physically based rendering: no fragment function has use for them.
constexpr std::string_view without_use[] = {"Ps",     "Pc",   "Pcr",      "aniso",    "anisor", "map_Ps", "map_Ns",
                                            "map_Pc", "disp", "map_disp", "map_Disp", "decal",  "refl",   "map_aat"};
/// Options of a texture that take this many words.
constexpr std::pair<std::string_view, int> skipped_options[] = {
    {"-blendu", 1}, {"-blendv", 1}, {"-boost", 1}, {"-cc", 1},         {"-mm", 2},
    {"-t", 3},      {"-texres", 1}, {"-type", 1},  {"-colorspace", 1},
};

template <class Entry, std::size_t count>
const Entry* find(const Entry (&entries)[count], std::string_view key) {
  for (const Entry& entry : entries)
    if (entry.first == key) return &entry;
  return nullptr;
}
template <std::size_t count>
bool has(const std::string_view (&keys)[count], std::string_view key) {
  return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

class MtlReader {
public:
  MtlReader(const std::string& file, NoteList& notes) : file_(file), notes_(notes) {}

  std::vector<MeshMaterial> read(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
      statement(trimmed(text.substr(0, end), blanks));
      const bool is_pair = text.substr(end).starts_with("\r\n");
      text.remove_prefix(std::min(end + (is_pair ? 2 : 1), text.size()));
    }
    return std::move(materials_);
  }

private:
  void note(std::string_view found, std::string consequence) {
    notes_.add({file_, line_, in_quotes(found), std::move(consequence)});
  }

  void statement(std::string_view all) {
    if (all.empty() || all.front() == '#') return;
    std::string_view rest = all;
    const std::string_view key = take_word(rest);
    if (key == "newmtl") return begin_material(all, rest);
    if (!in_material_) return note(all, "skipped: it stands before any newmtl");
    if (skips_) return;
    MeshMaterial& material = materials_.back();
    if (const auto* const map = find(maps, key)) texture(all, rest, material.*map->second);
    else if (const auto* const colour = find(colours, key)) set_colour(all, rest, material.*colour->second);
    else if (const auto* const number = find(numbers, key)) set_number(all, rest, material.*number->second);
    else if (key == "Tr") transparency(all, rest, material);
    else if (key == "illum") illumination(all, rest, material);
    else if (has(without_use, key)) note(all, std::string(key) + " is not used");
    else if (!has(without_part, key)) note(all, "skipped: the format has no such statement");
  }

  void begin_material(std::string_view all, std::string_view name) {
    in_material_ = true;
    skips_ = name.empty() || !names_.insert(std::string(name)).second;
    if (name.empty()) return note(all, "skipped: the material has no name");
    if (skips_) return note(all, "skipped: there is a material of that name");
    MeshMaterial& material = materials_.emplace_back();
    material.name = name, material.file = file_, material.line = line_;
  }

  /// A number that a statement begins with, if it is one of 0 or more.
  static bool take_number(std::string_view& text, double& value) {
    std::string_view rest = text;
    const std::string_view word = take_word(rest);
    if (word.empty() || read_number(word, value) != NumberText::good) return false;
    text = rest;
    return true;
  }

  /// Three numbers; or one, which all three are.
  void set_colour(std::string_view all, std::string_view text, std::optional<Double3>& colour) {
    Double3 read(0);
    int count = 0;
    while (count < 3 && take_number(text, read[count])) ++count;
    if (count == 1) read = Double3(read.x);
    const bool negative = std::min({read.x, read.y, read.z}) < 0;
    if ((count != 1 && count != 3) || negative || !ends(text))
      return note(all, "skipped: a colour is three numbers of 0 or more");
    colour = read;
  }

  /// Whether nothing follows but a comment.
  static bool ends(std::string_view text) { return text.empty() || text.front() == '#'; }

  bool single(std::string_view all, std::string_view text, double& value) {
    if (text.starts_with("-halo")) take_word(text); // of d
    if (take_number(text, value) && value >= 0 && ends(text)) return true;
    note(all, "skipped: it has a number of 0 or more");
    return false;
  }
  void set_number(std::string_view all, std::string_view text, std::optional<double>& number) {
    if (double value = 0; single(all, text, value)) number = value;
  }
  /// Where both are there, d counts, which is the format's own.
  void transparency(std::string_view all, std::string_view text, MeshMaterial& material) {
    if (double value = 0; single(all, text, value) && !material.dissolve) material.dissolve = 1 - std::min(value, 1.0);
  }
  void illumination(std::string_view all, std::string_view text, MeshMaterial& material) {
    double value = 0;
    if (!single(all, text, value)) return;
    if (value > 10 || value != std::floor(value)) return note(all, "skipped: a model is a whole number from 0 to 10");
    material.illumination = static_cast<int>(value);
  }

  /// Options, and then a file name, which may have blanks in it.
  void texture(std::string_view all, std::string_view text, MeshTexture& texture) {
    MeshTexture read;
    read.line = line_;
    while (text.starts_with('-')) {
      std::string_view rest = text;
      const std::string_view option = take_word(rest);
      if (option == "-s") rest = numbers_of(rest, read.scale);
      else if (option == "-o") rest = numbers_of(rest, read.offset);
      else if (option == "-clamp") read.clamp = take_word(rest) == "on";
      else if (option == "-imfchan") read.channel = first_letter(take_word(rest));
      else if (option == "-bm") take_number(rest, read.bump_multiplier);
      else if (const auto* const skipped = find(skipped_options, option)) {
        for (int i = 0; i < skipped->second; ++i) skip_word_of(option, rest);
        note(option, std::string(option) + " is not used");
      } else break; // a name may begin so
      text = rest;
    }
    if (text.empty()) return note(all, "skipped: it names no file");
    read.path = text;
    texture = read;
  }
  static char first_letter(std::string_view word) { return word.empty() ? '\0' : word.front(); }
  /// -t has one to three numbers.
  static void skip_word_of(std::string_view option, std::string_view& rest) {
    if (double unused = 0; option == "-t" || option == "-mm") take_number(rest, unused);
    else take_word(rest);
  }
  /// Up to three, of which two count; those that are left out stay.
  static std::string_view numbers_of(std::string_view text, Double2& values) {
    for (int count = 0; count < 3; ++count) {
      double value = 0;
      if (!take_number(text, value)) break;
      if (count < 2) values[count] = value;
    }
    return text;
  }

  const std::string& file_;
  NoteList& notes_;
  std::vector<MeshMaterial> materials_;
  std::unordered_set<std::string> names_;
  int line_ = 0;
  bool in_material_ = false, skips_ = false; // skips: this material is left out
};

} // namespace

std::vector<MeshMaterial> parse_mtl(const std::string& file, std::string text, NoteList& notes) {
  const TextKind kind = text_kind(text);
  if (kind != TextKind::plain) {
    notes.add({file, 0, std::string(name_of(kind)), "not read: a material library is ASCII or UTF-8 text"});
    return {};
  }
  std::string_view all = text;
  if (all.starts_with("\xef\xbb\xbf")) all.remove_prefix(3); // byte order mark
  return MtlReader(file, notes).read(all);
}

std::vector<MeshMaterial> read_mtl(const std::string& path, NoteList& notes) {
  return parse_mtl(path, read_file(path, "a material library", limit::mtl_bytes.value), notes);
}

} // namespace refraster
