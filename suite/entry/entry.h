#pragma once
// What a suite asks for: plain data.

#include <refraster/compare.h>
#include <refraster/files.h>
#include <refraster/render.h>

#include "verify/verdict/verdict_report.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster::suite {

/// What is done with an entry's scene.
enum class Action {
  compare, ///< its image, made here or by something else, against its reference
  verify,  ///< OpenGL's image, or one from a file, against the bounds of a device: every pixel must be explained
  render,  ///< its image is made, and nothing asked of it
  gl,      ///< the same by OpenGL
  bench    ///< the time of a frame is measured
};

/// What a reference is.
enum class ReferenceKind {
  image, ///< a PNG file
  digest ///< the sha256 of the float image: only where the same bits come out everywhere
};

/// Where the image that is judged comes from.
enum class ImageFrom {
  render,
  gl,       ///< OpenGL, in 8 bits
  gl_float, ///< the same of its float image: `verify` alone has bounds for floats
  file
};

struct PixelSize {
  int width = 0, height = 0;
  bool operator==(const PixelSize&) const = default;
};

/// When an entry passes.
struct EntryLimits {
  CompareLimits compare;           ///< of `compare`, in levels
  std::vector<ClassLimit> classes; ///< of `verify`: pixels of a class that may be
  std::optional<double> frame_ms;  ///< of `bench`: median of a frame
};

/// One thing to do, and when it passes. Paths are relative to the current directory.
struct Entry {
  std::string name;  ///< of this suite only this one's; a file name without extension
  std::string scene; ///< scene file or model
  Action action = Action::compare;
  ImageFrom image_from = ImageFrom::render; ///< of `compare` and `verify`
  std::string image_file;                   ///< ImageFrom::file
  std::string device;                       ///< profile, or empty; of what OpenGL draws also who draws
  std::optional<PixelSize> size;            ///< nothing: what the scene says
  std::optional<int> samples;               ///< likewise
  std::optional<Transfer> transfer;         ///< likewise
  Precision precision = Precision::double_; ///< of what is rendered here
  std::optional<ReferenceKind> reference;   ///< nothing: what there is, or an image
  EntryLimits limits;
  std::vector<std::string> tags;
  Outside outside = Outside::refused;
  double timeout_seconds = 600;     ///< it is ended then
  std::uint64_t max_memory_mib = 0; ///< likewise, beyond so much memory; 0: what its worker may take

  /// Whether OpenGL draws.
  bool needs_gl() const {
    return action == Action::gl ||
           (judges_image() && (image_from == ImageFrom::gl || image_from == ImageFrom::gl_float));
  }
  bool judges_image() const { return action == Action::compare || action == Action::verify; }
  /// Whether the machine must do nothing else meanwhile.
  bool is_alone() const { return action == Action::bench; }
};

/// Entries that belong together.
struct Suite {
  std::string path;       ///< its file; empty: of the command line
  std::string references; ///< folder; may be empty
  std::vector<Entry> entries;
};

} // namespace refraster::suite

namespace refraster {

template <>
struct EnumNames<suite::Action> {
  static constexpr std::pair<suite::Action, std::string_view> names[] = {{suite::Action::compare, "compare"},
                                                                         {suite::Action::verify, "verify"},
                                                                         {suite::Action::render, "render"},
                                                                         {suite::Action::gl, "gl"},
                                                                         {suite::Action::bench, "bench"}};
};

/// What a suite file calls them; all other words are files.
template <>
struct EnumNames<suite::ImageFrom> {
  static constexpr std::pair<suite::ImageFrom, std::string_view> names[] = {
      {suite::ImageFrom::render, "render"}, {suite::ImageFrom::gl, "gl"}, {suite::ImageFrom::gl_float, "gl-float"}};
};

template <>
struct EnumNames<suite::ReferenceKind> {
  static constexpr std::pair<suite::ReferenceKind, std::string_view> names[] = {
      {suite::ReferenceKind::image, "image"}, {suite::ReferenceKind::digest, "digest"}};
};

} // namespace refraster
