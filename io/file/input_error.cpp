#include <refraster/notes.h>

#include "io/file/text.h"

#include <string>

namespace refraster {

std::string InputFault::text() const {
  std::string result = file;
  if (line > 0) result.append(":").append(std::to_string(line));
  if (line > 0 && column > 0) result.append(":").append(std::to_string(column));
  if (!path.empty()) result.append(result.empty() ? "" : ": ").append(path);
  result.append(result.empty() ? "found " : ": found ").append(found);
  if (!expected.empty()) result.append(", expected ").append(expected);
  return one_line(result); // a name may have any character
}

namespace {
std::string joined(const std::vector<InputFault>& faults) {
  std::string result;
  for (const InputFault& fault : faults) result.append(result.empty() ? "" : "\n").append(fault.text());
  return result;
}
} // namespace

InputError::InputError(std::vector<InputFault> list, std::size_t unlisted)
    : std::runtime_error(joined(list)), faults_(std::move(list)), unlisted_(unlisted) {}

OutputError::OutputError(const std::string& file, const std::string& reason)
    : std::runtime_error(one_line(file + ": cannot write: " + reason)) {}

} // namespace refraster
