#include "io/merl_file.h"

#include "io/atomic_file.h"
#include "io/fault_list.h"
#include "io/input_file.h"

#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

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

} // namespace

std::shared_ptr<const MerlTable> read_merl(const std::string& path) {
  constexpr std::uint64_t any_size = std::uint64_t{1} << 40; // the exact size is asked for below, before it is read
  if (auto fault = file_fault(path, "a MERL table", any_size)) throw InputError(std::move(*fault));
  const std::uint64_t size = file_size_bytes(path);
  if (size >= header_bytes) {
    std::array<std::int32_t, 3> found{};
    const std::string header = read_prefix(path, header_bytes);
    std::memcpy(found.data(), header.data(), header_bytes);
    if (found != dimensions) throw InputError(fault_in(path, "dimensions", text_of(found), text_of(dimensions)));
  }
  if (size != merl_file_bytes)
    throw InputError(fault_in(path, "", std::to_string(size) + " bytes", std::to_string(merl_file_bytes) + " bytes"));

  const std::string bytes = read_file(path, "a MERL table", merl_file_bytes);
  PaddedVector<double> rgb(3 * MerlTable::samples);
  FaultList faults;
  for (std::size_t channel = 0; channel < 3; ++channel)
    for (std::size_t i = 0; i < MerlTable::samples; ++i) {
      double stored = 0;
      std::memcpy(&stored, &bytes[header_bytes + sizeof stored * (channel * MerlTable::samples + i)], sizeof stored);
      rgb[3 * i + channel] = stored * merl_scale[channel];
      if (std::isfinite(stored)) continue;
      faults.add_from([&] {
        constexpr std::size_t row = MerlTable::phi_d_bins, block = row * MerlTable::theta_d_bins;
        const std::string place = std::string(1, "rgb"[channel]) + "[" + std::to_string(i / block) + "][" +
                                  std::to_string(i % block / row) + "][" + std::to_string(i % row) + "]";
        return fault_in(path, place, std::isnan(stored) ? "nan" : "infinity", "a finite number");
      });
    }
  faults.throw_if_any();
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

std::string file_sha256(const std::string& path) {
  const std::string bytes = read_file(path, "a file", std::uint64_t{1} << 40);
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned size = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  std::string result;
  for (unsigned i = 0; i < 2 * size; ++i) result += "0123456789abcdef"[i % 2 ? digest[i / 2] & 15 : digest[i / 2] >> 4];
  return result;
}

} // namespace refraster
