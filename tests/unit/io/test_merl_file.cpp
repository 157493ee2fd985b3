#include <refraster/files.h>

#include "io/brdf/merl_file.h"
#include "io/file/sha256.h"
#include "tests/support/files/malformed_inputs.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <fstream>

namespace refraster::test {

TEST_CASE("a MERL table is written and read back within an ulp, negatives included") {
  const TemporaryFolder folder;
  PaddedVector<double> rgb(3 * MerlTable::samples);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<double>(i % 1000) / 7;
  rgb[MerlTable::offset(89, 0, 7)] = -1.0 / 1500; // never measured
  const MerlTable table(rgb);
  write_merl(folder / "t.binary", table);
  CHECK(std::filesystem::file_size(folder / "t.binary") == merl_file_bytes);
  const auto read = read_merl(folder / "t.binary");
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    // x / s * s: two roundings, each half an ulp.
    const double value = read->values<double>()[i], ulp = std::nextafter(std::abs(rgb[i]), HUGE_VAL) - std::abs(rgb[i]);
    wrong += std::abs(value - rgb[i]) <= ulp ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(read->sample(89, 0, 7).x < 0);
}

TEST_CASE("a MERL file has planes of red, green and blue, each with its scale") {
  const TemporaryFolder folder;
  PaddedVector<double> rgb(3 * MerlTable::samples);
  write_merl(folder / "t.binary", MerlTable(rgb));
  const std::size_t sample = (3 * 90 + 4) * 180 + 5; // theta_h 3, theta_d 4, phi_d 5
  std::fstream file(folder / "t.binary", std::ios::binary | std::ios::in | std::ios::out);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double stored = 1500;
    char bytes[sizeof stored];
    std::memcpy(bytes, &stored, sizeof stored);
    file.seekp(static_cast<std::streamoff>(12 + 8 * (channel * 1458000 + sample)));
    file.write(bytes, sizeof bytes);
  }
  file.close();
  const Rgb<double> f = read_merl(folder / "t.binary")->sample(3, 4, 5);
  CHECK(f.x == 1500 * (1.0 / 1500));
  CHECK(f.y == 1500 * (1.15 / 1500));
  CHECK(f.z == 1500 * (1.66 / 1500));
}

TEST_CASE("a file's sha256 names the material, if it is one of the 100") {
  const TemporaryFolder folder;
  write_files(folder.path, {{"abc", "abc"}});
  // FIPS 180-2, appendix B.1.
  CHECK(file_sha256(folder / "abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(merl_material_name(file_sha256(folder / "abc")).empty());
  CHECK(merl_material_name("ca43554a1b0afd9bcb437113bd431742a9918f744e14675af917f89e0eba74c8") == "aluminium");
  CHECK(merl_material_name("ca43554a1b0afd9bcb437113bd431742a9918f744e14675af917f89e0eba74c9").empty());
  CHECK(merl_material_name("").empty());
}

} // namespace refraster::test
