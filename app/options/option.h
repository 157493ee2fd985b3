#pragma once
// What a command can be given, declared. Parsing (parse.h), help, suggestions, completions and man pages are readings
// of these declarations. The functions below make one; names are "--size", or "-o,--output" with a short one.

#include <refraster/fields.h>

#include <charconv>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// In the one word after an option's name; `values`: one or more, with commas between them.
enum class Takes { nothing, value, values };
/// What a shell offers for a value.
enum class Completes { nothing, words, files, folders, commands };
/// How often an argument may, or an option with a value must at most, be there.
enum class Occurs { at_most_once, once, repeatedly };

/// Why a value is refused: "found "half", expected one of double, float".
struct ValueFault {
  std::string expected;
  std::string found = {}; // a part of the value; empty: all of it
};

/// Takes a value, or says why not.
using ReadValue = std::function<std::optional<ValueFault>(const std::string& text)>;

/// One option, or one argument, which has no name of its own and is known by its place.
struct Option {
  std::string name;              // "--size"; of an argument, the word that stands for it in the help: "SCENE"
  char short_name = 0;           // 'o' for -o; 0: none
  std::string form = {};         // stands for the value in the help: "WxH", "0..1024"
  std::string meaning = {};      // a phrase without a full stop
  std::string default_text = {}; // what holds if it is not given; empty: the meaning says it
  Takes takes = Takes::value;
  Occurs occurs = Occurs::at_most_once;
  Completes completes = Completes::nothing;
  std::vector<std::string> words = {}; // to choose from
  ReadValue read = {};                 // a flag's is called with ""

  bool is_argument() const { return !name.starts_with("--"); }

  // For declarations.
  Option by_default(std::string text) && { return default_text = std::move(text), std::move(*this); }
  Option required() && { return occurs = Occurs::once, std::move(*this); }
};

/// Options under one heading of the help.
struct OptionGroup {
  std::string heading;
  std::vector<Option> options;
};

/// The number that the whole text is. from_chars takes no sign for an unsigned one, and no locale; to it, 010 is 10.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "64", "0.8", "1000000" and not "1e+06".
std::string number_text(double number);

/// Text at commas; at least one part.
std::vector<std::string_view> split(std::string_view text, char separator);

/// A file or any other text that is taken as it stands. A required argument, by its place.
Option argument(std::string name, std::string& value, std::string meaning);
/// All further arguments.
Option arguments(std::string name, std::vector<std::string>& values, std::string meaning);
Option file_option(std::string_view names, std::string form, std::string& path, std::string meaning);
Option folder_option(std::string_view names, std::string& path, std::string meaning);
Option text_option(std::string_view names, std::string form, std::string& text, std::string meaning);
/// An option without a value.
Option flag(std::string_view names, std::function<void()> set, std::string meaning);

/// An option, or an argument if its name is no "--name", whose value is read by `read`. For the functions below.
Option value_option(std::string_view names, std::string form, std::string meaning, ReadValue read);
/// A word that is one of `words`; use(i) takes the one at index i. The help shows all of them.
Option word_option(std::string_view names, std::vector<std::string> words, std::function<void(std::size_t)> use,
                   std::string meaning);
/// Some of the words with commas between them, each at most once; use() takes their indices, in the order given.
Option word_list_option(std::string_view names, std::string form, std::vector<std::string> words,
                        std::function<void(const std::vector<std::size_t>&)> use, std::string meaning);

/// A number in a range; the help shows the range in place of the value. NaN is in none.
template <class Number>
Option number_option(std::string_view names, Number& value, const Range& range, std::string meaning) {
  const std::string form = range.ends == Ends::included ? number_text(range.min) + ".." + number_text(range.max)
                                                        : ">" + number_text(range.min) + "..<" + number_text(range.max);
  const auto read = [&value, range, form](const std::string& text) -> std::optional<ValueFault> {
    const std::optional<Number> number = number_from<Number>(text);
    if (!number || !range.contains(static_cast<double>(*number))) return ValueFault{"a number in " + form};
    value = *number;
    return std::nullopt;
  };
  return value_option(names, form, std::move(meaning), read).by_default(number_text(static_cast<double>(value)));
}

/// One of a few numbers.
Option number_choice_option(std::string_view names, int& value, const std::vector<int>& choices, std::string meaning);

/// One of a few words, which is stored.
template <class Text>
Option choice_option(std::string_view names, Text& value, const std::vector<std::string>& choices,
                     std::string meaning) {
  Option option = word_option(
      names, choices, [&value, choices](std::size_t i) { value = choices[i]; }, std::move(meaning));
  if constexpr (requires { value.empty(); }) option.default_text = value;
  return option;
}

/// One of an enum's words.
template <NamedEnum Enum>
Option enum_option(std::string_view names, Enum& value, std::string meaning) {
  std::vector<std::string> words;
  for (const auto& [listed, name] : EnumNames<Enum>::names) words.emplace_back(name);
  return word_option(
             names, words, [&value](std::size_t i) { value = EnumNames<Enum>::names[i].first; }, std::move(meaning))
      .by_default(std::string(name_of(value)));
}

/// An option whose text `parse` turns into a value; nothing from parse is wrong usage, where `expected` says what is
/// right. form: a comma in it says that several values may stand there.
template <class Value, class Parsed>
Option parsed_option(std::string_view names, std::string form, Value& value,
                     std::optional<Parsed> (*parse)(std::string_view), std::string expected, std::string meaning) {
  const auto read = [&value, parse,
                     expected = std::move(expected)](const std::string& text) -> std::optional<ValueFault> {
    std::optional<Parsed> parsed = parse(text);
    if (!parsed) return ValueFault{expected};
    value = std::move(*parsed);
    return std::nullopt;
  };
  return value_option(names, std::move(form), std::move(meaning), read);
}

/// Lists of options, one behind the other.
std::vector<Option> joined(std::initializer_list<std::vector<Option>> lists);

} // namespace refraster
