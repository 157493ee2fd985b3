#include "app/options/help.h"

#include "app/options/manual.h"
#include "app/options/wrap.h"

#include <algorithm>
#include <cctype>

namespace refraster {
namespace {

/// One row of a list: what is explained, and how.
struct Row {
  std::string name, meaning;
};

constexpr int max_name_width = 28;  // columns; the meaning of a longer one begins below it
constexpr int min_table_width = 60; // in fewer columns every meaning begins below its name

std::string indented(int columns, const std::string& text) {
  return std::string(static_cast<std::size_t>(columns), ' ') + text + "\n";
}

/// With all but the first line farther in.
std::string paragraph(const std::string& text, int indent, int further, int width) {
  std::string result;
  // The first line must fit where the others stand, too: a few columns are lost, and nothing is wrapped twice.
  for (const std::string& line : wrapped(text, width - indent - further))
    result += indented(result.empty() ? indent : indent + further, line);
  return result;
}

/// Rows under a heading.
struct List {
  std::string heading;
  std::vector<Row> rows;
};

/// Where the meanings begin, in all lists of a page.
int meaning_column(const std::vector<List>& lists, int width) {
  if (width < min_table_width) return 8;
  int widest = 0;
  for (const List& list : lists)
    for (const Row& row : list.rows)
      if (const int columns = columns_of(row.name); columns <= max_name_width) widest = std::max(widest, columns);
  return widest + 4; // two before, two behind
}

std::string text_of(const List& list, int column, int width) {
  std::string text = "\n" + list.heading + ":\n";
  for (const Row& row : list.rows) {
    const std::vector<std::string> lines = wrapped(row.meaning, width - column);
    auto line = lines.begin();
    const int gap = column - 2 - columns_of(row.name);
    if (width >= min_table_width && gap >= 2)
      text += indented(2, row.name + std::string(static_cast<std::size_t>(gap), ' ') + *line++);
    else if (columns_of(row.name) + 2 <= width) text += indented(2, row.name); // with its own indentation
    else text += paragraph(row.name, 2, 4, width);
    for (; line != lines.end(); ++line) text += indented(column, *line);
  }
  return text;
}

List list_of(const OptionGroup& group) {
  List list{group.heading, {}};
  for (const Option& option : group.options) {
    // Long names stand below each other, with or without a short one before them.
    const bool indent = !option.is_argument() && option.short_name == 0;
    list.rows.push_back({(indent ? "    " : "") + usage_of(option), meaning_with_default(option)});
  }
  return list;
}

} // namespace

std::string usage_of(const Option& option) {
  if (option.is_argument())
    return option.occurs == Occurs::once           ? option.name
           : option.occurs == Occurs::at_most_once ? "[" + option.name + "]"
                                                   : "[" + option.name + "…]";
  std::string text;
  if (option.short_name != 0) text = std::string("-") + option.short_name + ", ";
  text += option.name;
  return option.takes == Takes::nothing ? text : text + " " + option.form;
}

std::string synopsis(const CommandPath& path) {
  std::string text = full_name(path);
  if (!path.back()->commands.empty()) return text + " COMMAND …";
  text += " [OPTION…]";
  for (const Option* const option : all_options(*path.back()))
    if (option->is_argument()) text += " " + usage_of(*option);
  return text;
}

std::string meaning_with_default(const Option& option) {
  if (option.default_text.empty()) return option.meaning;
  return option.meaning + " (default " + option.default_text + ")";
}

std::string sentence(std::string meaning) {
  if (!meaning.empty()) meaning[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(meaning[0])));
  return meaning + ".";
}

std::vector<std::string> notes_of(const Command& command) {
  std::vector<std::string> notes = command.notes;
  for (const Option* const option : all_options(command)) {
    if (option->takes != Takes::values) continue;
    notes.emplace_back("Several values of one option are separated by commas, without blanks.");
    break;
  }
  return notes;
}

std::string help_text(const CommandPath& path, int width) {
  const Command& command = *path.back();
  std::string text = paragraph(sentence(command.meaning), 0, 0, width) + "\n";
  text += paragraph("Usage: " + synopsis(path), 0, 7, width);
  std::vector<List> lists;
  if (!command.commands.empty()) lists.push_back({"Commands", {}});
  for (const Command& sub : command.commands) lists[0].rows.push_back({sub.name, sub.meaning});
  for (const OptionGroup& group : command.groups) lists.push_back(list_of(group));
  lists.push_back(list_of(help_group()));
  for (const List& list : lists) text += text_of(list, meaning_column(lists, width), width);
  std::vector<std::string> notes = notes_of(command);
  notes.push_back(manual_note(path));
  text += "\n";
  for (const std::string& note : notes) text += paragraph(note, 0, 0, width);
  return text;
}

} // namespace refraster
