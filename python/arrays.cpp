#include "python/arrays.h"

#include "io/file/limits.h"

#include <algorithm>
#include <cstring>

namespace refraster::python {
namespace {

template <class Value>
void copy_values(const py::array& given, Image<float>& image) {
  const auto array = py::array_t<Value, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array) throw py::error_already_set();
  std::transform(array.data(), array.data() + array.size(), image.values.begin(),
                 [](Value value) { return static_cast<float>(value); });
}

} // namespace

ArrayImage image_argument(const std::string& place, py::handle given, const std::vector<int>& channels) {
  const auto refuse = [&] {
    std::string shapes;
    for (const int count : channels)
      shapes += (shapes.empty() ? "" : " or ") +
                (count == 1 ? std::string("(height, width)") : "(height, width, " + std::to_string(count) + ")");
    refuse_argument(place, given, "an array of uint8, uint16, float32 or float64 with shape " + shapes);
  };
  if (!py::isinstance<py::array>(given)) refuse();
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (array.ndim() != 2 && array.ndim() != 3) refuse();
  const auto count = array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1;
  const auto most = static_cast<py::ssize_t>(limit::image_side.value);
  if (std::find(channels.begin(), channels.end(), count) == channels.end()) refuse();
  for (const int axis : {0, 1})
    if (array.shape(axis) < 1 || array.shape(axis) > most) refuse();
  ArrayImage image;
  image.values = Image<float>(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)), count);
  const char kind = array.dtype().kind();
  const py::ssize_t size = array.itemsize();
  if (kind == 'u' && size == 1) copy_values<std::uint8_t>(array, image.values);
  else if (kind == 'u' && size == 2) copy_values<std::uint16_t>(array, image.values), image.full_scale = 65535;
  else if (kind == 'f' && size == 4) copy_values<float>(array, image.values), image.full_scale = 1;
  else if (kind == 'f' && size == 8) copy_values<double>(array, image.values), image.full_scale = 1;
  else refuse();
  return image;
}

} // namespace refraster::python
