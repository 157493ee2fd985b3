#include "app/options/man_page.h"

#include "app/options/help.h"
#include "app/options/manual.h"
#include "io/file/build_info.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

namespace refraster {
namespace {

/// The character that begins at text[i], as roff names it: \[u2026].
std::string escape(std::string_view text, std::size_t& i) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])); };
  const std::size_t more = byte(i) >= 0xF0 ? 3 : byte(i) >= 0xE0 ? 2 : 1;
  unsigned code = byte(i) & (0x3Fu >> more);
  for (std::size_t k = 0; k < more && i + 1 < text.size(); ++k) code = code << 6 | (byte(++i) & 0x3F);
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "\\[u%04X]", code);
  return name.data();
}

/// As a line of text: none of it is taken for a request, and '-' can be copied into a shell.
std::string roff(std::string_view text) {
  std::string result;
  if (text.starts_with('.') || text.starts_with('\'')) result = "\\&";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') result += "\\e";
    else if (text[i] == '-') result += "\\-";
    else if (text[i] == '^' || text[i] == '~' || text[i] == '`')
      result += text[i] == '^' ? "\\(ha" : text[i] == '~' ? "\\(ti" : "\\(ga";
    else if (static_cast<unsigned char>(text[i]) < 0x80) result += text[i];
    else result += escape(text, i);
  }
  return result;
}

std::string section(const std::string& heading) {
  std::string text = heading;
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) { return std::toupper(letter); });
  return ".SH " + roff(text) + "\n";
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string entry(const std::string& name, const std::string& meaning) {
  return ".TP\n" + name + "\n" + roff(meaning) + "\n";
}

std::string name_of(const Option& option) {
  if (option.is_argument()) return "\\fI" + roff(option.name) + "\\fR";
  std::string text;
  if (option.short_name != 0) text = bold(std::string("-") + option.short_name) + ", ";
  text += bold(option.name);
  return option.takes == Takes::nothing ? text : text + " \\fI" + roff(option.form) + "\\fR";
}

std::string options(const OptionGroup& group) {
  std::string text = ".SS " + roff(group.heading) + "\n";
  for (const Option& option : group.options) text += entry(name_of(option), sentence(meaning_with_default(option)));
  return text;
}

/// The pages of the command above and of those below.
std::string see_also(const CommandPath& path) {
  std::vector<CommandPath> others;
  if (path.size() > 1) others.emplace_back(path.begin(), path.end() - 1);
  for (const Command& command : path.back()->commands) {
    others.push_back(path);
    others.back().push_back(&command);
  }
  std::string text = section("See also");
  for (const CommandPath& other : others)
    text += ".BR " + roff(page_name(other)) + " (1)" + (&other == &others.back() ? "\n" : ",\n");
  return text;
}

} // namespace

std::string man_page(const CommandPath& path) {
  const Command& command = *path.back();
  std::string title = page_name(path);
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char letter) { return std::toupper(letter); });
  // Without a date: the same program makes the same page.
  std::string text = ".TH " + roff(title) + " 1 \"\" \"refraster " + this_build().version + "\" \"User Commands\"\n";
  text += section("Name") + roff(page_name(path)) + " \\- " + roff(command.meaning) + "\n";
  text += section("Synopsis") + ".B " + roff(full_name(path)) + "\n";
  const std::string usage = synopsis(path).substr(full_name(path).size());
  if (!usage.empty()) text += roff(usage.substr(1)) + "\n";
  const std::vector<std::string> notes = notes_of(command);
  if (!notes.empty()) {
    text += section("Description");
    for (std::size_t i = 0; i < notes.size(); ++i) text += (i == 0 ? "" : ".PP\n") + roff(notes[i]) + "\n";
  }
  if (!command.commands.empty()) {
    text += section("Commands");
    for (const Command& sub : command.commands) text += entry(bold(sub.name), sentence(sub.meaning));
  }
  text += section("Options");
  for (const OptionGroup& group : command.groups) text += options(group);
  text += options(help_group());
  return text + see_also(path);
}

} // namespace refraster
