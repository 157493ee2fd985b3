#pragma once
// Where a page of the manual is to be found.

#include "app/command.h"

#include <string>

namespace refraster {

/// "refraster-brdf-info", the name of a page, as `man` takes it.
std::string page_name(const CommandPath& path);

/// A sentence: how to read the page of a command. It names the file where the page was installed with the program that
/// runs; else what prints it.
std::string manual_note(const CommandPath& path);

} // namespace refraster
