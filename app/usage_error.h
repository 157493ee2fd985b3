#pragma once
// Wrong arguments.

#include <stdexcept>
#include <string>

namespace refraster {

/// The command line is wrong: exit code 2. In the form of an error in a file: "--size: found "640", expected …".
class UsageError : public std::runtime_error {
public:
  /// place: an option, an argument or a command; may be empty. What is wrong is said in `message`.
  UsageError(const std::string& place, const std::string& message)
      : std::runtime_error(place.empty() ? message : place + ": " + message) {}
  /// found: as it is to be printed, words in quotes.
  UsageError(const std::string& place, const std::string& found, const std::string& expected)
      : UsageError(place, "found " + found + ", expected " + expected) {}
};

/// A command stands there alone that needs another word to say what to do: its help is the answer.
class BareCommand : public UsageError {
public:
  using UsageError::UsageError;
};

} // namespace refraster
