#include "io/file/limits.h"

namespace refraster {
namespace {

std::string with_number(std::string_view text, const std::string& number) {
  std::string result(text);
  const std::size_t at = result.find('N');
  return at == std::string::npos ? result : result.replace(at, 1, number);
}

} // namespace

std::string at_most(const Limit& limit) {
  if (!limit.expected.empty()) return std::string(limit.expected);
  return "at most " + std::to_string(limit.value) + " " + std::string(limit.unit);
}

std::string found_of(const Limit& limit, std::uint64_t count) {
  return with_number(limit.found, std::to_string(count));
}

std::string limits_markdown() {
  std::string text = "| what | at most | why not more | what is said |\n|---|---|---|---|\n";
  for (const Limit* const limit : all_limits)
    text.append("| ")
        .append(limit->what)
        .append(" | ")
        .append(std::to_string(limit->value) + " " + std::string(limit->unit))
        .append(" | ")
        .append(limit->reason)
        .append(" | `found ")
        .append(limit->found)
        .append(", expected " + at_most(*limit))
        .append("` |\n");
  return text;
}

} // namespace refraster
