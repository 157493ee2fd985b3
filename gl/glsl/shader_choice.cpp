#include "gl/glsl/shader_choice.h"

#include <refraster/notes.h>

#include "gl/glsl/own_glsl.h"
#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/trace/file_trace.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace refraster {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

/// The three digits of `#version 330` if that is what a line says, however it is set out; else empty.
std::string_view version_in(std::string_view line) {
  const auto skip_blanks = [&line] {
    std::size_t count = 0;
    while (count < line.size() && is_blank(line[count])) ++count;
    line.remove_prefix(count);
    return count > 0;
  };
  const auto skip = [&line](std::string_view word) {
    if (!line.starts_with(word)) return false;
    line.remove_prefix(word.size());
    return true;
  };
  skip_blanks();
  if (!skip("#")) return {};
  skip_blanks();
  if (!skip("version") || !skip_blanks()) return {};
  const std::string_view number = line.substr(0, 3);
  if (number.size() < 3 || !std::all_of(number.begin(), number.end(), is_digit)) return {};
  const bool goes_on = line.size() > 3 && (is_digit(line[3]) || line[3] == '_' || ('a' <= line[3] && line[3] <= 'z') ||
                                           ('A' <= line[3] && line[3] <= 'Z'));
  return goes_on ? std::string_view() : number;
}

/// Lowers the number after #version to the newest one; words for people where it did.
std::string lower_version(std::string& text, int newest) {
  const std::string_view all = text;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end + 1) {
    end = std::min(all.find('\n', begin), all.size());
    const std::string_view found = version_in(all.substr(begin, end - begin));
    if (found.empty()) continue;
    const std::string number(found);
    if (std::stoi(number) <= newest) return {};
    text.replace(static_cast<std::size_t>(found.data() - all.data()), 3, std::to_string(newest));
    return " (#version " + number + " taken as " + std::to_string(newest) + ")";
  }
  return {};
}

/// A stage's text, and in words where it is from.
std::pair<ShaderText, std::string> choose(const std::string& path, std::string own_text, const std::string& own_name,
                                          int newest_version) {
  std::error_code ignored;
  if (path.empty()) return {{own_name, std::move(own_text)}, "ours (the scene names none)"};
  trace_file(path); // also where it is not there yet
  if (!std::filesystem::exists(path, ignored))
    return {{own_name, std::move(own_text)}, "ours (there is no " + path + ")"};
  std::string text = read_file(path, "a GLSL file", limit::glsl_bytes.value);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3); // a byte order mark, which compilers take for GLSL
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw InputError({path, 0, 0, "", "UTF-16 text", "a GLSL file, which is ASCII or UTF-8"});
  const std::string lowered = lower_version(text, newest_version);
  return {{path, std::move(text)}, path + lowered};
}

} // namespace

ShaderChoice choose_shaders(const Scene& scene, const Object& object, MerlFilter filter, int newest_version) {
  const std::string_view function = object.material.function_name();
  if (std::error_code ignored;
      !has_own_glsl(object.material) && !std::filesystem::exists(object.fragment_shader_path, ignored))
    throw InputError({object.name, 0, 0, "/fragment_shader_file_path",
                      object.fragment_shader_path.empty() ? "none" : "no file " + object.fragment_shader_path,
                      "a GLSL file: there is none of ours of " + std::string(function)});
  if (const auto without = without_glsl(scene, object); !without.empty())
    if (std::error_code ignored; !std::filesystem::exists(object.fragment_shader_path, ignored))
      throw InputError({object.name, 0, 0, "/fragment_shader_file_path", "none that can be read",
                        "a GLSL file: there is none of ours of " + std::string(without.front())});
  const auto [vertex, vertex_from] =
      choose(object.vertex_shader_path, own_vertex_glsl(*object.mesh, GlslDialect::core_330), "our vertex shader",
             newest_version);
  const auto [fragment, fragment_from] =
      choose(object.fragment_shader_path,
             own_fragment_glsl(scene, *object.mesh, object.material, object.two_sided, filter, GlslDialect::core_330),
             "our fragment shader of " + std::string(function), newest_version);
  return {vertex, fragment,
          object.name + ": vertex shader " + vertex_from + ", fragment shader of " + std::string(function) + " " +
              fragment_from,
          vertex.file == object.vertex_shader_path, fragment.file == object.fragment_shader_path};
}

} // namespace refraster
