// tinyobjloader, compiled with the fuzzer's instruments: its package is not, and these functions
// take the place of those in the package's library.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
