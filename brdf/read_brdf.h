#pragma once
// A reflectance by the words of a user.

#include "brdf/brdf.h"

#include <string>

namespace refraster {

/// Reads the table of that name, or makes the model, of which read_models() must find no fault. Throws InputError for a
/// file.
Brdf read_brdf(const std::string& word, MerlLookup lookup);

} // namespace refraster
