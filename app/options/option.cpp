#include "app/options/option.h"

#include "io/file/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace refraster {
namespace {

std::vector<std::string_view> views(const std::vector<std::string>& words) {
  return {words.begin(), words.end()};
}

std::string joined(const std::vector<std::string>& words, char separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : std::string(1, separator)) + word;
  return text;
}

std::optional<std::size_t> index_of(const std::vector<std::string>& words, std::string_view word) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<std::size_t>(found - words.begin());
}

/// Takes any text.
ReadValue text_into(std::string& value) {
  return [&value](const std::string& text) -> std::optional<ValueFault> {
    value = text;
    return std::nullopt;
  };
}

} // namespace

std::string number_text(double number) {
  std::array<char, 32> text{};
  const bool whole = std::floor(number) == number && std::abs(number) < 1e15;
  std::snprintf(text.data(), text.size(), whole ? "%.0f" : "%g", number);
  return text.data();
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

Option value_option(std::string_view names, std::string form, std::string meaning, ReadValue read) {
  Option option{.name = std::string(names.substr(names.find(',') + 1))};
  if (names.find(',') == 2) option.short_name = names[1];
  option.takes = form.find(',') == std::string::npos ? Takes::value : Takes::values;
  option.form = std::move(form);
  option.meaning = std::move(meaning);
  option.read = std::move(read);
  return option;
}

Option argument(std::string name, std::string& value, std::string meaning) {
  Option option = value_option(name, "", std::move(meaning), text_into(value));
  option.occurs = Occurs::once;
  option.completes = Completes::files;
  return option;
}

Option arguments(std::string name, std::vector<std::string>& values, std::string meaning) {
  Option option = value_option(name, "", std::move(meaning), [&values](const std::string& text) {
    values.push_back(text);
    return std::optional<ValueFault>();
  });
  option.occurs = Occurs::repeatedly;
  option.completes = Completes::files;
  return option;
}

Option file_option(std::string_view names, std::string form, std::string& path, std::string meaning) {
  Option option = value_option(names, std::move(form), std::move(meaning), text_into(path)).by_default(path);
  option.completes = Completes::files;
  return option;
}

Option folder_option(std::string_view names, std::string& path, std::string meaning) {
  Option option = value_option(names, "DIR", std::move(meaning), text_into(path));
  option.completes = Completes::folders;
  return option;
}

Option text_option(std::string_view names, std::string form, std::string& text, std::string meaning) {
  return value_option(names, std::move(form), std::move(meaning), text_into(text));
}

Option flag(std::string_view names, std::function<void()> set, std::string meaning) {
  Option option = value_option(names, "", std::move(meaning), [set = std::move(set)](const std::string&) {
    set();
    return std::optional<ValueFault>();
  });
  option.takes = Takes::nothing;
  return option;
}

Option word_option(std::string_view names, std::vector<std::string> words, std::function<void(std::size_t)> use,
                   std::string meaning) {
  const auto read = [words, use = std::move(use)](const std::string& text) -> std::optional<ValueFault> {
    const std::optional<std::size_t> index = index_of(words, text);
    if (!index) return ValueFault{one_of(views(words), text)};
    use(*index);
    return std::nullopt;
  };
  Option option = value_option(names, joined(words, '|'), std::move(meaning), read);
  option.completes = Completes::words;
  option.words = std::move(words);
  return option;
}

Option word_list_option(std::string_view names, std::string form, std::vector<std::string> words,
                        std::function<void(const std::vector<std::size_t>&)> use, std::string meaning) {
  const auto read = [words, use = std::move(use)](const std::string& text) -> std::optional<ValueFault> {
    std::vector<std::size_t> indices;
    for (const std::string_view part : split(text, ',')) {
      const std::optional<std::size_t> index = index_of(words, part);
      if (!index) return ValueFault{one_of(views(words), part), std::string(part)};
      if (std::find(indices.begin(), indices.end(), *index) != indices.end())
        return ValueFault{"some of " + joined(words, ',') + ", each once"};
      indices.push_back(*index);
    }
    use(indices);
    return std::nullopt;
  };
  Option option = value_option(names, std::move(form), std::move(meaning), read);
  option.takes = Takes::values;
  option.completes = Completes::words;
  option.words = std::move(words);
  return option;
}

Option number_choice_option(std::string_view names, int& value, const std::vector<int>& choices, std::string meaning) {
  std::vector<std::string> words;
  for (const int choice : choices) words.push_back(std::to_string(choice));
  return word_option(
             names, words, [&value, choices](std::size_t i) { value = choices[i]; }, std::move(meaning))
      .by_default(std::to_string(value));
}

std::vector<Option> joined(std::initializer_list<std::vector<Option>> lists) {
  std::vector<Option> all;
  for (const std::vector<Option>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

} // namespace refraster
