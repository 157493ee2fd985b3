// The body of tinyobjloader, which is a header. Its warnings are not ours: it is a system header.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
