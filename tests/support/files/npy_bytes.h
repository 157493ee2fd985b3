#pragma once
// Arrays of NumPy, written here, so that reading is not tested against our own writer.

#include <string>

namespace refraster::test {

/// With the header as NumPy 1.24 writes it, of 118 bytes, so that the values begin at byte 128. `shape` as in Python.
inline std::string npy_bytes(const std::string& type, const std::string& shape, const std::string& values,
                             const std::string& order = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  header.resize(117, ' ');
  return "\x93NUMPY\x01" + std::string(1, '\0') + "v" + std::string(1, '\0') + header + "\n" + values;
}

} // namespace refraster::test
