#pragma once
// Words of a list, for messages on a word that is not among them: what there is, and which of it was meant.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// How many letters must be inserted, removed, replaced, or exchanged with their neighbour, to make one word the other;
/// no letter is touched twice (Damerau, "A technique for computer detection and correction of spelling errors", 1964;
/// the restricted form). Small and capital letters are the same letter, and so are '_' and '-'. In bytes; takes time in
/// proportion to the product of both lengths.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of the list that somebody who wrote `given` most likely means: the one with the least edit distance, the
/// first of equals, if that is at most one in three letters; else the only one that begins with `given`. Leading '-'
/// count for nothing. Nothing if no word is near, and for a `given` of more than 64 bytes, which is no slip.
std::optional<std::string_view> nearest_word(std::string_view given, const std::vector<std::string_view>& words);

/// "; did you mean b?" if `given` is near to a word of the list, else "".
std::string did_you_mean(const std::vector<std::string_view>& words, std::string_view given);

/// "one of a, b, c", and, if `given` is near to one of them, "; did you mean b?".
std::string one_of(const std::vector<std::string_view>& words, std::string_view given);

} // namespace refraster
