// tinygltf, compiled with the fuzzer's instruments: its package is not, and these functions take
// the place of those in the package's library.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
