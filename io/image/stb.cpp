// The bodies of stb_image and stb_image_write, which are headers. Their warnings are not ours: they are system headers.
// stb_image is compiled without the formats that are read by other means; cmake/stb.cmake says with which flags.
#include <cstdlib>
#include <new>

namespace {
/// stb_image_write writes to whatever it is given. (stb_image looks, and tells.)
void* given(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}
} // namespace

// Memory is handed out as zeros. If a decoder did not fill all of an image, it would show what was in memory before: so
// that is black, and the same each time.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(memory, size) std::realloc(memory, size)
#define STBI_FREE(memory) std::free(memory)

#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 65536 // limit::image_side
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#define STBIW_MALLOC(size) given(std::malloc(size))
#define STBIW_REALLOC(memory, size) given(std::realloc(memory, size))
#define STBIW_FREE(memory) std::free(memory)
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
