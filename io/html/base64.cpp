#include "io/html/base64.h"

#include <nettle/base64.h>

namespace refraster {

std::string base64(const std::vector<std::uint8_t>& bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), bytes.data());
  return text;
}

} // namespace refraster
