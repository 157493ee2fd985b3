#include <refraster/files.h>
#include <refraster/mesh.h>
#include <refraster/notes.h>

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/render_small.h"
#include "tests/long/fuzz/targets.h"

#include "io/brdf/merl_file.h"

#include <cstring>
#include <vector>

namespace refraster::fuzz {
namespace {

/// A file of the right size from few bytes: the first 12 are its header, then come entries of 12: where (a 32-bit
/// number, taken modulo the number of values) and which double.
std::vector<std::uint8_t> whole_file(Bytes bytes) {
  std::vector<std::uint8_t> file(merl_file_bytes);
  std::memcpy(file.data(), bytes.data(), 12);
  for (std::size_t at = 12; at + 12 <= bytes.size(); at += 12) {
    std::uint32_t place = 0;
    std::memcpy(&place, &bytes[at], sizeof place);
    std::memcpy(&file[12 + 8 * (place % (3 * MerlTable::samples))], &bytes[at + 4], 8);
  }
  return file;
}

void read(Bytes bytes) {
  const std::string path = file_of("t.binary", bytes);
  std::shared_ptr<const MerlTable> table;
  const PeakMemory peak;
  try {
    table = read_merl(path);
  } catch (const InputError& error) {
    require(!error.faults().empty() && error.faults().size() <= 101, "a refusal has faults, not too many");
  }
  // The file, and the table in double.
  require_memory(peak, bytes.size(), 1 << 17, 2);
  if (!table) return;
  require(bytes.size() == merl_file_bytes, "an accepted table has its size");
  Scene scene = showing(std::make_shared<const Mesh>(sphere_mesh(8, 6)), nullptr, TextureFilter::nearest);
  constexpr MerlLookup lookups[] = {MerlLookup::nearest, MerlLookup::trilinear, MerlLookup::trilinear_edge,
                                    MerlLookup::trilinear_log, MerlLookup::tricubic_log};
  Merl function;
  function.table = table;
  function.lookup = lookups[bytes[12] % std::size(lookups)];
  scene.objects[0].material.fragment_function = function;
  render_small(scene, bytes[13]);
}

} // namespace

void read_merl_bytes(Bytes bytes) {
  // Mostly files as they are: those of the right size are 35 MB, and take a hundred thousand times as long.
  if (bytes.size() >= 24 && bytes[0] % 8 == 2) read(whole_file(bytes));
  else read(bytes);
}

} // namespace refraster::fuzz
