#pragma once
// What is wrong with an argument.

#include "python/bindings.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace refraster::python {

/// refraster.UsageError: "size: found (0, 5), expected …", as the program says it of its options.
class ArgumentError : public std::runtime_error {
public:
  /// place: the argument, or the attribute that is set. found: as it is to be printed.
  ArgumentError(const std::string& place, const std::string& found, const std::string& expected)
      : std::runtime_error(place + ": found " + found + ", expected " + expected) {}
};

/// An argument for a message: words in quotes, arrays by type and shape, all else as Python prints it, cut where it is
/// long.
std::string found_text(py::handle value);

/// Throws ArgumentError with found_text().
[[noreturn]] void refuse_argument(const std::string& place, py::handle value, const std::string& expected);

} // namespace refraster::python
