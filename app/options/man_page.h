#pragma once
// Pages of the manual.

#include "app/command.h"

#include <string>

namespace refraster {

/// The page of a command in roff, with the macros of man(7), in ASCII.
std::string man_page(const CommandPath& path);

} // namespace refraster
