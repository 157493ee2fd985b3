#pragma once
// What --help prints.

#include "app/command.h"

#include <string>
#include <vector>

namespace refraster {

/// "-o, --output FILE", "--size WxH", "SCENE", "[COMMAND…]"
std::string usage_of(const Option& option);

/// "refraster render [OPTION…] SCENE".
std::string synopsis(const CommandPath& path);

/// "image to write (default 1280x720)".
std::string meaning_with_default(const Option& option);

/// "Rough metal."
std::string sentence(std::string meaning);

/// Those that are declared, and what is to be said of the forms of its options.
std::vector<std::string> notes_of(const Command& command);

/// With how to read the page of the manual; in lines of at most `width` columns, but for words that are wider.
std::string help_text(const CommandPath& path, int width);

} // namespace refraster
