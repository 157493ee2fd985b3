#pragma once
// What is said to a user whose file or argument is wrong.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// One fault in one input. As text: `file:line:column: /json/path: found X, expected Y`; parts that do not apply are
/// left out.
struct InputFault {
  std::string file;
  int line = 0, column = 0; // counted from 1; 0: not known
  std::string path;         // JSON pointer, or a name of a place in a binary file
  std::string found;
  std::string expected;

  std::string text() const;
};

/// All faults found in the input, in the order of the file. what() has one line for each. Exit code 3.
class InputError : public std::runtime_error {
public:
  /// `unlisted`: how many faults the last of the list stands for ("found 400 more faults"); 0 if it is one itself.
  explicit InputError(std::vector<InputFault> list, std::size_t unlisted = 0);
  explicit InputError(InputFault fault) : InputError(std::vector<InputFault>{std::move(fault)}) {}
  InputError(InputFault fault, std::string advice) : InputError(std::move(fault)) { advice_ = std::move(advice); }
  const std::vector<InputFault>& faults() const { return faults_; }
  /// What to do about it: lines to print below what(), each with its line end. Mostly empty.
  const std::string& advice() const { return advice_; }
  std::size_t unlisted() const { return unlisted_; }

private:
  std::string advice_;
  std::vector<InputFault> faults_;
  std::size_t unlisted_ = 0;
};

/// An output file cannot be written: full disk, missing folder, no permission. Exit code 4.
class OutputError : public std::runtime_error {
public:
  OutputError(const std::string& file, const std::string& reason);
};

} // namespace refraster
