#pragma once
// Bytes within text.

#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

/// Base64 (RFC 4648, 4) of any bytes.
std::string base64(const std::vector<std::uint8_t>& bytes);

} // namespace refraster
