#include "tests/encoded_image.h"

#include <stdexcept>

#include <dlfcn.h>

namespace foveola::test {
namespace {

using Encoder = void (*)(const EncodableSamples& image, std::string& bytes);

Encoder load_encoder() {
  void* const module = dlopen(ENCODER_MODULE, RTLD_NOW | RTLD_LOCAL);
  void* const function = module == nullptr ? nullptr : dlsym(module, "foveola_test_encode");
  if (function == nullptr) {
    throw std::runtime_error(dlerror());
  }
  return reinterpret_cast<Encoder>(function);
}

}  // namespace

std::string encoded_image(const EncodableSamples& image) {
  static const Encoder encode = load_encoder();
  std::string bytes;
  encode(image, bytes);
  return bytes;
}

}  // namespace foveola::test
