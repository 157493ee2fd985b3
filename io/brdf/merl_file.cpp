#include "io/brdf/merl_file.h"

#include <refraster/files.h>

#include "io/file/atomic_file.h"
#include "io/file/fault_list.h"
#include "io/file/input_file.h"

#include <array>
#include <bit>
#include <cmath>

namespace refraster {
namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::array<std::int32_t, 3> dimensions = {MerlTable::theta_h_bins, MerlTable::theta_d_bins,
                                                    MerlTable::phi_d_bins};
constexpr std::size_t header_bytes = sizeof dimensions;

InputFault fault_in(const std::string& file, std::string place, std::string found, std::string expected) {
  return {file, 0, 0, std::move(place), std::move(found), std::move(expected)};
}

std::string text_of(const std::array<std::int32_t, 3>& d) {
  return std::to_string(d[0]) + " x " + std::to_string(d[1]) + " x " + std::to_string(d[2]);
}

InputFault not_finite(const std::string& path, std::size_t channel, std::size_t sample, double stored) {
  constexpr std::size_t row = MerlTable::phi_d_bins, block = row * MerlTable::theta_d_bins;
  const std::string place = std::string(1, "rgb"[channel]) + "[" + std::to_string(sample / block) + "][" +
                            std::to_string(sample % block / row) + "][" + std::to_string(sample % row) + "]";
  return fault_in(path, place, std::isnan(stored) ? "nan" : "infinity", "a finite number");
}

} // namespace

std::shared_ptr<const MerlTable> read_merl(const std::string& path) {
  constexpr std::uint64_t any_size = std::uint64_t{1} << 40; // the exact size is asked for below, before it is read
  const InputFile file(path, "a MERL table", any_size);
  const std::uint64_t size = file.size_bytes();
  if (size >= header_bytes) {
    std::array<std::int32_t, 3> found{};
    file.read(0, found.data(), header_bytes);
    if (found != dimensions) throw InputError(fault_in(path, "dimensions", text_of(found), text_of(dimensions)));
  }
  if (size != merl_file_bytes)
    throw InputError(fault_in(path, "", std::to_string(size) + " bytes", std::to_string(merl_file_bytes) + " bytes"));

  // Plane by plane for each theta_h: what is read stays in the cache until it stands in its place.
  PaddedVector<double> rgb(3 * MerlTable::samples);
  constexpr std::size_t part = MerlTable::theta_d_bins * MerlTable::phi_d_bins;
  std::vector<double> stored(part);
  std::array<FaultList, 3> faults;
  for (std::size_t first = 0; first < MerlTable::samples; first += part)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      file.read(header_bytes + sizeof(double) * (channel * MerlTable::samples + first), stored.data(),
                part * sizeof(double));
      bool finite = true;
      for (std::size_t i = 0; i < part; ++i) {
        finite &= std::isfinite(stored[i]);
        rgb[3 * (first + i) + channel] = stored[i] * merl_scale[channel];
      }
      for (std::size_t i = 0; i < part && !finite; ++i)
        if (!std::isfinite(stored[i]))
          faults[channel].add_from([&] { return not_finite(path, channel, first + i, stored[i]); });
    }
  for (std::size_t channel = 1; channel < 3; ++channel) faults[0].add(faults[channel]);
  faults[0].throw_if_any();
  return std::make_shared<const MerlTable>(std::move(rgb));
}

void write_merl(const std::string& path, const MerlTable& table) {
  AtomicFile file(path);
  file.write(dimensions.data(), header_bytes);
  std::vector<double> plane(MerlTable::samples);
  const double* const rgb = table.values<double>();
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t i = 0; i < MerlTable::samples; ++i) plane[i] = rgb[3 * i + channel] / merl_scale[channel];
    file.write(plane.data(), plane.size() * sizeof(double));
  }
  file.commit();
}

} // namespace refraster
