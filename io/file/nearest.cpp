#include "io/file/nearest.h"

#include <algorithm>

namespace refraster {
namespace {

constexpr std::size_t max_given = 64; // bytes; beyond it nobody has mistyped a word, and the time would be felt

char folded(char letter) {
  if (letter == '_') return '-';
  return 'A' <= letter && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string_view without_dashes(std::string_view word) {
  word.remove_prefix(std::min(word.find_first_not_of('-'), word.size()));
  return word;
}

bool begins_with(std::string_view word, std::string_view beginning) {
  return beginning.size() <= word.size() && edit_distance(word.substr(0, beginning.size()), beginning) == 0;
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // distance[j]: between the first i letters of a and the first j of b; with the rows of i - 1 and i - 2 beside it.
  std::vector<std::size_t> distance(b.size() + 1), above(b.size() + 1), above_that(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) distance[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(above_that, above);
    std::swap(above, distance);
    distance[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = folded(a[i - 1]) == folded(b[j - 1]);
      distance[j] = std::min({above[j] + 1, distance[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && folded(a[i - 1]) == folded(b[j - 2]) && folded(a[i - 2]) == folded(b[j - 1]))
        distance[j] = std::min(distance[j], above_that[j - 2] + 1);
    }
  }
  return distance[b.size()];
}

std::optional<std::string_view> nearest_word(std::string_view given, const std::vector<std::string_view>& words) {
  given = without_dashes(given);
  if (given.empty() || given.size() > max_given) return std::nullopt;
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  for (const std::string_view word : words) {
    const std::size_t length = without_dashes(word).size(), distance = edit_distance(given, without_dashes(word));
    if (3 * distance > length + 1) continue; // one slip in three letters, and in two: "gk" is gl, "x" is nothing
    if (nearest && distance >= least) continue;
    nearest = word;
    least = distance;
  }
  if (nearest || given.size() < 2) return nearest;
  for (const std::string_view word : words) {
    if (!begins_with(without_dashes(word), given)) continue;
    if (nearest) return std::nullopt; // of two, neither is more likely
    nearest = word;
  }
  return nearest;
}

std::string did_you_mean(const std::vector<std::string_view>& words, std::string_view given) {
  const std::optional<std::string_view> nearest = nearest_word(given, words);
  return nearest ? std::string("; did you mean ").append(*nearest).append("?") : "";
}

std::string one_of(const std::vector<std::string_view>& words, std::string_view given) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "one of " : ", ").append(word);
  return text + did_you_mean(words, given);
}

} // namespace refraster
