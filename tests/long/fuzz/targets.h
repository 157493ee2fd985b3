#pragma once
// What the fuzzer calls: for each parser of untrusted bytes, one function that reads them as a user's file would be
// read, and checks what must hold whatever they are. A law that is broken ends the process.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace refraster::fuzz {

using Bytes = std::span<const std::uint8_t>;

void read_scene_bytes(Bytes bytes);       // scene JSON, with a mesh and a texture beside it that it may name
void read_limits_bytes(Bytes bytes);      // the limits of a comparison: JSON
void read_device_bytes(Bytes bytes);      // the profile of a device: JSON
void read_csv_bytes(Bytes bytes);         // tables of numbers
void read_obj_bytes(Bytes bytes);         // OBJ
void read_mtl_bytes(Bytes bytes);         // material libraries
void read_merl_bytes(Bytes bytes);        // MERL .binary; a whole table is made of few bytes
void read_image_bytes(Bytes bytes);       // what textures are read from: PNG, JPEG, TGA, BMP
void read_float_image_bytes(Bytes bytes); // HDR, PFM, EXR
void read_suite_bytes(Bytes bytes);       // suite files: JSON
void read_references_bytes(Bytes bytes);  // refs.json of a suite
void read_part_bytes(Bytes bytes);        // parts of an image, of `render --shard`
void read_journal_bytes(Bytes bytes);     // the journal of a suite's results

struct Target {
  std::string_view name;
  void (*run)(Bytes);
};

inline constexpr Target targets[] = {
    {"scene", read_scene_bytes},
    {"limits", read_limits_bytes},
    {"device", read_device_bytes},
    {"csv", read_csv_bytes},
    {"obj", read_obj_bytes},
    {"mtl", read_mtl_bytes},
    {"merl", read_merl_bytes},
    {"image", read_image_bytes},
    {"float_image", read_float_image_bytes},
    {"suite", read_suite_bytes},
    {"references", read_references_bytes},
    {"part", read_part_bytes},
    {"journal", read_journal_bytes},
};

/// Ends the process, with the law that was broken, unless `holds`.
void require(bool holds, std::string_view law);
/// The same for functions that return what is wrong: "" if nothing is.
void require_none(const std::string& fault, std::string_view of);

/// The path of a file of this process with these bytes, in a folder of this process; it is overwritten by the next
/// of that name.
std::string file_of(std::string_view name, Bytes bytes);

} // namespace refraster::fuzz
