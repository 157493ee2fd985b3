#pragma once
// NumPy arrays of the library's memory, and back.

#include <refraster/image.h>

#include "python/bindings.h"
#include "python/errors.h"

#include <string>
#include <vector>

namespace refraster::python {

enum class Access { read, write };

/// An array of memory that `owner` keeps alive. Strides are those of rows that follow each other.
template <class Value>
py::array array_view(std::vector<py::ssize_t> shape, const Value* memory, py::handle owner, Access access) {
  py::array view(py::dtype::of<Value>(), std::move(shape), memory, owner);
  if (access == Access::read) view.attr("setflags")(py::arg("write") = false);
  return view;
}

/// The pixels of an image, top row first: (height, width, channels), or (height, width) of a single channel. No copy.
template <class Value>
py::array image_view(const Image<Value>& image, py::handle owner) {
  std::vector<py::ssize_t> shape = {image.height, image.width};
  if (image.channels > 1) shape.push_back(image.channels);
  return array_view(std::move(shape), image.values.data(), owner, Access::write);
}

/// An image that is an array of numbers, as an image file has them.
struct ArrayImage {
  Image<float> values;
  double full_scale = 255; ///< the number that means 1: 255 of uint8, 65535 of uint16, 1 of floats
};

/// Copies (height, width), (height, width, 1) or (height, width, channels), top row first, of uint8, uint16, float32 or
/// float64, which is rounded to float32. Throws ArgumentError, also for other numbers of channels than these.
ArrayImage image_argument(const std::string& place, py::handle given, const std::vector<int>& channels);

} // namespace refraster::python
