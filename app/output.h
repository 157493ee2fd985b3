#pragma once
// Where results go.

#include <refraster/image.h>

#include "io/image/image_formats.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace refraster {

/// A report on standard output instead of in a file.
inline constexpr const char* standard_output = "-";

/// Throws OutputError unless a file can be made at this path: its folder exists and lets itself be written to, and
/// the path itself is no folder. To be asked before the work, so that no one waits for an image that cannot be kept.
/// Standard output is always fine.
void check_writable(const std::string& path);

/// Throws UsageError if two of the outputs are one file, or an output is an input: one would be lost. Paths may be
/// empty. Devices and pipes may be named more than once.
void check_different(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// Makes the folder of --cache if need be; nothing if it is empty. Throws OutputError unless files can be written to
/// it.
void prepare_cache(const std::string& folder);

/// Makes a folder, and those it lies in, if it is not there. Throws OutputError if it cannot be made.
void prepare_folder(const std::string& folder);

/// Writes a text file as a whole or not at all; or to standard output. Throws OutputError.
void write_text(const std::string& path, const std::string& text);

/// Throws UsageError unless the extension of this path is one of a format that can hold any of `contents`.
void check_extension(const std::string& option, const std::string& path, std::initializer_list<ImageContent> contents);

/// Writes an image of floats, format by extension; one that has no images of two channels gets a third one of zeros.
/// `channels` names those of a file that has names; by default as write_image does, and U V of two.
void write_values(const std::string& path, const ImageRows<float>& image, std::vector<std::string> channels = {},
                  const WriteOptions& options = {});

/// "scenes/ball.json" gives "ball".
std::string stem(const std::string& path);

} // namespace refraster
